//! The search for causes: every one fitted in full, the best taken, and again while it pays. A
//! cause acts in all swings, its strength is each swing's own.

use super::super::cause_id::CauseId;
use super::super::evidence::{LEAST_GAIN, is_missed, pays};
use super::super::point::{Part, SETTLING_S};
use super::super::search::{MOST_CAUSES, UNNAMED_LEAVES};
use super::super::verdict::simplest_first;
use super::super::white::{Left, in_record};
use super::causes::{Cause, Kind, catalogue};
use super::fitting::{Fitted, fit, fit_from_afar};
use super::swing::Swing;
use gyradius_base::error::Result;
use gyradius_base::parallel::in_parallel;
use gyradius_base::progress::{Progress, tell};

/// Causes by their places in the catalogue, fitted to every swing.
#[derive(Clone)]
pub struct Extended {
    pub causes: Vec<usize>,
    pub fits: Vec<Fitted>,
    /// What is left, χ² beyond noise.
    pub left: Left,
}

/// A further cause fitted.
#[derive(Clone)]
pub struct Tried {
    pub id: CauseId,
    pub with: Extended,
    /// Of the logarithm of the evidence, over the model without it.
    pub gain: f64,
}

/// What was tried in one place, the best first.
pub struct Round {
    pub tried: Vec<Tried>,
    pub taken: bool,
}

/// What the search found.
pub struct Found<'a> {
    pub swings: &'a [Swing<'a>],
    pub base: Extended,
    /// Without the last cause.
    pub before: Option<Extended>,
    pub best: Extended,
    pub rounds: Vec<Round>,
}

impl Extended {
    pub fn rms(&self) -> f64 {
        let sum = |of: fn(&Fitted) -> f64| self.fits.iter().map(of).sum::<f64>();
        (sum(|f| f.chi2) / sum(|f| f.rows as f64).max(1.0)).sqrt()
    }

    /// Its causes as a swing has them.
    pub fn causes_of<'a>(&self, swing: &'a Swing) -> Vec<&'a Cause> {
        self.causes
            .iter()
            .map(|place| &swing.catalogue[*place])
            .collect()
    }
}

/// The swings with causes, each fitted from a start; `None` where one of them cannot be.
fn extended(swings: &[Swing], causes: Vec<usize>, fits: Vec<Option<Fitted>>) -> Option<Extended> {
    let fits = fits.into_iter().collect::<Option<Vec<_>>>()?;
    let mut extended = Extended {
        causes,
        fits,
        left: Left::default(),
    };
    for (s, swing) in swings.iter().enumerate() {
        let residuals = over_noise(swing, &extended.fits[s].point, &extended.causes_of(swing))?;
        extended.left.bands.extend(in_record(
            (s, 0),
            &swing.stream.t_s,
            &residuals,
            swings.len(),
        ));
    }
    Some(extended)
}

/// Residuals of the samples over their noise.
fn over_noise(swing: &Swing, point: &[f64], causes: &[&Cause]) -> Option<Vec<f64>> {
    let readings = swing.readings(point, causes)?;
    let pairs = swing.rates_rad_s.iter().zip(&readings);
    Some(
        pairs
            .map(|(measured, reading)| (measured - reading) / swing.noise_rad_s)
            .collect(),
    )
}

/// Searches; `None` where no simulation can be fitted to a swing.
pub fn search<'a>(swings: &'a [Swing<'a>], progress: &Progress) -> Result<Option<Found<'a>>> {
    let fits = in_parallel(swings.len(), |s| fit_from_afar(&swings[s]));
    let Some(base) = extended(swings, vec![], fits) else {
        return Ok(None);
    };
    let mut found = Found {
        swings,
        best: base.clone(),
        base,
        before: None,
        rounds: vec![],
    };
    while found.best.causes.len() < MOST_CAUSES {
        let n = found.rounds.len();
        tell(
            progress,
            0.3 + 0.2 * n as f64,
            "fitting every cause in full",
        )?;
        let tried = found.tried();
        let taken = tried.first().filter(|best| found.pays(best)).cloned();
        found.rounds.push(Round {
            tried,
            taken: taken.is_some(),
        });
        let Some(best) = taken else { break };
        let has_a_name = best.id != CauseId::Unknown;
        found.take(best);
        // A polynomial bends to whatever there is: names found beside it would mean little.
        if !has_a_name {
            break;
        }
    }
    found.prune();
    found.learn();
    Ok(Some(found))
}

impl Found<'_> {
    fn take(&mut self, best: Tried) {
        self.before = Some(std::mem::replace(&mut self.best, best.with));
    }

    /// Name of a cause by its place in the catalogue.
    pub fn id(&self, place: usize) -> CauseId {
        self.swings[0].catalogue[place].id
    }

    /// Whether a cause can be told from what is fitted already.
    fn is_open(&self, place: usize) -> bool {
        let scale = self.swings[0].catalogue[place].kind == Kind::GyroScale;
        let is_new = self
            .best
            .causes
            .iter()
            .all(|known| self.id(*known) != self.id(place));
        is_new && (!scale || self.swings.iter().any(|s| s.law.knows_the_angle()))
    }

    /// Every cause in the next place, the best of each name, the best first. A shape without a name
    /// comes first only where it takes nearly all that the named ones leave.
    fn tried(&self) -> Vec<Tried> {
        let open: Vec<usize> = (0..catalogue(&self.swings[0].scales).len())
            .filter(|p| self.is_open(*p))
            .collect();
        let mut tried: Vec<Tried> = in_parallel(open.len(), |k| self.with(open[k]))
            .into_iter()
            .flatten()
            .collect();
        tried.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        let mut best: Vec<Tried> = Vec::new();
        for t in tried {
            if best.iter().all(|known| known.id != t.id) {
                best.push(t);
            }
        }
        let unknown = best
            .iter()
            .position(|t| t.id == CauseId::Unknown)
            .map(|k| best.remove(k));
        simplest_first(&mut best, |t| self.parameters(t));
        let Some(unknown) = unknown else { return best };
        let left = best.first().map_or(&self.best.left, |t| &t.with.left);
        if !left.is_next_to_nothing(&self.base.left) {
            let beats = best.first().is_none_or(|t| unknown.gain > t.gain);
            let takes_all = beats && unknown.with.left.excess() < UNNAMED_LEAVES * left.excess();
            best.insert(if takes_all { 0 } else { best.len() }, unknown);
        }
        best
    }

    fn with(&self, place: usize) -> Option<Tried> {
        let causes: Vec<usize> = self.best.causes.iter().copied().chain([place]).collect();
        let fitted = |(swing, known): (&Swing, &Fitted)| {
            let start: Vec<f64> = known
                .point
                .iter()
                .copied()
                .chain(swing.catalogue[place].start())
                .collect();
            let list: Vec<&Cause> = causes.iter().map(|p| &swing.catalogue[*p]).collect();
            fit(swing, &list, Part::All, &start)
        };
        let fits = self
            .swings
            .iter()
            .zip(&self.best.fits)
            .map(fitted)
            .collect();
        let with = extended(self.swings, causes, fits)?;
        let gain = Self::gain(&self.best, &with)?;
        Some(Tried {
            id: self.id(place),
            with,
            gain,
        })
    }

    /// Logarithm of the evidence with a cause over that without.
    fn gain(without: &Extended, with: &Extended) -> Option<f64> {
        let of_all = |fits: &[Fitted]| fits.iter().map(|fit| fit.log_evidence).sum::<Option<f64>>();
        Some(of_all(&with.fits)? - of_all(&without.fits)?)
    }

    fn pays(&self, best: &Tried) -> bool {
        let first = self.rounds.first().and_then(|round| round.tried.first());
        pays(
            first.map(|t| t.gain),
            best.gain,
            &best.with.left,
            &self.best.left,
        )
    }

    /// A cause taken first may owe its gain to one that was taken later: without it nothing is then
    /// lost, and it goes.
    fn prune(&mut self) {
        for k in (0..self.best.causes.len().saturating_sub(1)).rev() {
            let Some(without) = self.without(k) else {
                continue;
            };
            let Some(lost) = Self::gain(&without, &self.best) else {
                continue;
            };
            if !is_missed(lost, &without.left, &self.best.left) {
                self.best = without;
                self.rounds[k].taken = false;
            }
        }
    }

    /// Without the k-th cause.
    fn without(&self, k: usize) -> Option<Extended> {
        let mut causes = self.best.causes.clone();
        causes.remove(k);
        let fitted = |(swing, known): (&Swing, &Fitted)| {
            let sizes = |list: &[usize]| -> usize {
                list.iter()
                    .map(|p| swing.catalogue[*p].parameters.len())
                    .sum()
            };
            let from = swing.first_cause() + sizes(&self.best.causes[..k]);
            let mut start = known.point.clone();
            start.drain(from..from + sizes(&self.best.causes[k..=k]));
            let list: Vec<&Cause> = causes.iter().map(|p| &swing.catalogue[*p]).collect();
            fit(swing, &list, Part::All, &start)
        };
        let fits = self
            .swings
            .iter()
            .zip(&self.best.fits)
            .map(fitted)
            .collect();
        extended(self.swings, causes, fits)
    }

    /// Where structure remains, the model is extended even without a name for it.
    fn learn(&mut self) {
        if !self.is_unexplained()
            || self
                .best
                .causes
                .iter()
                .any(|place| self.id(*place) == CauseId::Unknown)
        {
            return;
        }
        let Some(last) = self.rounds.last_mut().filter(|round| !round.taken) else {
            return;
        };
        if let Some(k) = last
            .tried
            .iter()
            .position(|t| t.id == CauseId::Unknown && t.gain > LEAST_GAIN)
        {
            let best = last.tried.remove(k);
            last.tried.insert(0, best.clone());
            last.taken = true;
            self.take(best);
        }
    }

    /// χ² of the stretches that are held out and their rows, the model fitted to the others.
    pub fn held_out(&self, model: &Extended) -> Option<(f64, usize)> {
        let of_swing = |s: usize| {
            let (swing, start) = (&self.swings[s], &model.fits[s].point);
            let causes = model.causes_of(swing);
            let there = fit(swing, &causes, Part::Fitted, start)?;
            let rows = swing.residual(&there.point, &causes, Part::HeldOut)?;
            Some((rows.norm_squared(), rows.len()))
        };
        let parts = in_parallel(self.swings.len(), of_swing)
            .into_iter()
            .collect::<Option<Vec<_>>>()?;
        Some(
            parts
                .into_iter()
                .fold((0.0, 0), |(a, b), (c, d)| (a + c, b + d)),
        )
    }
}

/// Periods beyond what is left out that a record must hold to be judged.
pub const LEAST_PERIODS: f64 = 6.0;

/// Whether a record is long enough to be judged.
pub fn is_long_enough(swing: &Swing) -> bool {
    let period_s = std::f64::consts::TAU / swing.scales.omega_rad_s;
    swing.duration_s > SETTLING_S + LEAST_PERIODS * period_s
}
