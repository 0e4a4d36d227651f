//! Sets of causes fitted to all swings of a session at once.

use std::cell::{Cell, RefCell};
use std::sync::Arc;

use gyradius_base::error::{Error, Result};
use gyradius_base::progress::{Progress, tell};

use super::super::cause_id::CauseId;
use super::super::causes::Scales;
use super::super::decision::Decided;
use super::super::fitting::{FAR, Fitted};
use super::super::found::Found;
use super::super::point::{Cause, Form as Shape, Model, Point};
use super::super::selection::{Competing, Form, Set};
use super::kind::{Kind, kinds};
use super::linearised::{Linearised, only};

/// A fit of a set that differs in more than one cause begins at the best of these shares of the way to
/// where another set points.
const SHARES: [f64; 5] = [1.0, 0.5, 0.2, 0.05, 0.0];
/// After so many fits half of the way is told.
const USUAL_FITS: f64 = 5.0;

/// A session with everything that may be wrong with its simulation.
pub struct Session<'a> {
    base: Model<'a>,
    /// Where the fits of single swings lead.
    begin: Point,
    /// Fitted to all.
    fitted: Fitted,
    pub kinds: Vec<Kind>,
    forms: Vec<Form>,
    progress: &'a Progress<'a>,
    /// How many sets were fitted, and whether somebody stopped that.
    fits: Cell<usize>,
    stopped: RefCell<Option<Error>>,
}

/// A set of causes in the simulation.
#[derive(Clone)]
pub enum Explained<'a> {
    Fitted(Arc<Found<'a>>),
    /// As a linearised one has it, with the logarithm of its evidence.
    Promised(Arc<Linearised<'a>>, f64),
}

impl<'a> Session<'a> {
    pub fn of(
        base: Model<'a>,
        begin: Point,
        fitted: Fitted,
        progress: &'a Progress<'a>,
    ) -> Result<Self> {
        let scales = Scales::of(base.base, &fitted.point)?;
        let (kinds, forms) = kinds(&scales).into_iter().unzip();
        Ok(Self {
            base,
            begin,
            fitted,
            kinds,
            forms,
            progress,
            fits: Cell::new(0),
            stopped: RefCell::new(None),
        })
    }

    /// An error if somebody stopped the work: no set was fitted from then on.
    pub fn not_stopped(&self) -> Result<()> {
        self.stopped.take().map_or(Ok(()), Err)
    }

    /// Tells of one fit more, of which nobody knows how many follow.
    fn goes_on(&self) -> bool {
        let fits = self.fits.get() as f64;
        self.fits.set(self.fits.get() + 1);
        let share = 0.3 + 0.6 * fits / (fits + USUAL_FITS);
        let told = tell(self.progress, share, "fitting sets of causes");
        told.map_err(|error| self.stopped.replace(Some(error)))
            .is_ok()
    }

    /// A fitted model; an unknown cause's strengths are over the scales at `looked_from`.
    fn found(&self, model: Model<'a>, fitted: Fitted, looked_from: &Point) -> Option<Found<'a>> {
        let model = Model {
            of_many: false,
            ..model
        };
        // Derivatives are most of what a fit holds, and there may be many fits.
        let fitted = Fitted {
            jacobians: vec![],
            ..fitted
        };
        let found = Found::begun(model, self.begin.clone(), fitted).ok()?;
        let looked_from = looked_from.clone();
        Some(Found {
            looked_from,
            ..found
        })
    }

    /// With gusts where there is a wind that leaves something.
    fn with_gusts(&self, mut found: Found<'a>) -> Arc<Found<'a>> {
        let has = |form: Shape| {
            let mut winds = found.model.causes.iter().filter(|c| c.id == CauseId::Wind);
            winds.any(|cause| cause.form == form)
        };
        if has(Shape::Law) && !has(Shape::Gust) {
            found.blow(0.0, false);
        }
        Arc::new(found)
    }

    /// One cause more, by all ways that lead there.
    fn with_one_more(&self, from: &Linearised<'a>, form: usize) -> Option<Arc<Found<'a>>> {
        let tried = from
            .found
            .fit_to_its_end(&from.outside[form].as_ref()?.look)?;
        let looked_from = match tried.cause.id {
            CauseId::Unknown => &tried.from,
            _ => &from.found.looked_from,
        };
        let model = Model {
            causes: tried.causes,
            ..from.found.model.clone()
        };
        Some(self.with_gusts(self.found(model, tried.fitted, looked_from)?))
    }

    fn along(&self, from: &Linearised<'a>, set: &Set) -> Option<Arc<Found<'a>>> {
        let starts = SHARES.map(|share| from.start(set, &self.kinds, share));
        let costs = starts.into_iter().flatten().map(|(model, point)| {
            let cost = model.cost(&point).unwrap_or(f64::INFINITY);
            (cost, model, point)
        });
        let (_, model, point) = costs.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let fitted = model.fit(&point, &|_| false).ok()?;
        Some(self.with_gusts(self.found(model, fitted, &from.found.looked_from)?))
    }
}

/// Whether a number of a cause with a name stands at a limit that is not where its strength begins.
fn is_at_edge(found: &Found) -> bool {
    let swings = found.model.base.swings.len();
    let causes = found.model.causes.iter().zip(&found.fitted.point.causes);
    let mut named = causes.filter(|(cause, _)| cause.id != CauseId::Unknown);
    named.any(|(cause, values): (&Cause, &Vec<f64>)| {
        let mut all = values.iter().zip(cause.limits(swings));
        all.any(|(x, (low, high))| *x >= high || (*x <= low && low != 0.0))
    })
}

impl<'a> Competing for Session<'a> {
    type Model = Explained<'a>;
    type Linear = Arc<Linearised<'a>>;

    fn forms(&self) -> Vec<Form> {
        self.forms.clone()
    }

    fn log_evidence(&self, model: &Explained<'a>) -> Option<f64> {
        match model {
            Explained::Fitted(found) if is_at_edge(found) => None,
            Explained::Fitted(found) => found.fitted.log_evidence,
            Explained::Promised(_, log_evidence) => Some(*log_evidence),
        }
    }

    fn fitted(&self, set: &Set, pointed: Option<&Explained<'a>>) -> Option<Explained<'a>> {
        if !self.goes_on() {
            return None;
        }
        let found = match pointed {
            None if set.is_empty() => {
                let (base, fitted) = (self.base.clone(), self.fitted.clone());
                self.found(base, fitted, &self.fitted.point).map(Arc::new)
            }
            Some(Explained::Promised(from, _)) => {
                let is_new = |form: &&usize| !from.set.contains(form);
                let added: Vec<usize> = set.iter().filter(is_new).copied().collect();
                let is_gone = from.set.iter().any(|form| !set.contains(form));
                match added[..] {
                    [form] if !is_gone => self.with_one_more(from, form),
                    _ => self.along(from, set),
                }
            }
            _ => None,
        };
        found.map(Explained::Fitted)
    }

    fn linear(&self, set: &Set, model: &Explained<'a>) -> Option<Arc<Linearised<'a>>> {
        let Explained::Fitted(found) = model else {
            return None;
        };
        let linear = Linearised::of(Arc::clone(found), set.clone(), &self.kinds);
        linear.ok().map(Arc::new)
    }

    /// Far from the data what is linear tells of one cause more, no further.
    fn predicted(&self, linear: &Arc<Linearised<'a>>, set: &Set) -> Option<Explained<'a>> {
        let new = set.iter().filter(|form| !linear.set.contains(form)).count();
        if linear.found.fitted.rms() > FAR && new > 1 {
            return None;
        }
        let log_evidence = linear.solved(set)?.log_evidence;
        Some(Explained::Promised(Arc::clone(linear), log_evidence))
    }
}

impl<'a> Decided for Session<'a> {
    fn held_out(&self, model: &Explained<'a>) -> Option<(f64, usize)> {
        let Explained::Fitted(found) = model else {
            return None;
        };
        let whole = found.model.unmoved(&found.fitted.point).ok()?;
        Found::held_out(&found.model, &whole).ok()
    }

    fn without(&self, set: &Set, larger: &Explained<'a>) -> Option<Explained<'a>> {
        let Explained::Fitted(found) = larger else {
            return None;
        };
        let (model, point) = only(&found.model, &found.fitted.point, set, &self.kinds);
        let fitted = model.fit(&point, &|_| false).ok()?;
        let found = self.found(model, fitted, &found.looked_from)?;
        Some(Explained::Fitted(Arc::new(found)))
    }

    fn chi2(&self, model: &Explained<'a>) -> f64 {
        match model {
            Explained::Fitted(found) => found.fitted.chi2,
            Explained::Promised(..) => f64::INFINITY,
        }
    }
}
