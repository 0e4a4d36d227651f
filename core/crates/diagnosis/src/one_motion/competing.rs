//! Sets of causes fitted to all swings: each swing has its own strengths.

use nalgebra::{DMatrix, DVector};

use gyradius_base::parallel::in_parallel;
use gyradius_estimation::{
    Block, ByRows, Fit, Options, Parameter, Rows, Shape, UNSTOPPED, Wanted, minimise,
};
use gyradius_identification::one_motion::{FREQUENCY, solve_towards};

use super::super::selection::{Competing, Form, Set, TOLD};
use super::catalogue::Cause;
use super::swing::Swing;

/// A swing by a model.
#[derive(Debug, Clone)]
pub struct One {
    /// Its numbers, those of the causes of the set last.
    pub x: Vec<f64>,
    pub log_evidence: Option<f64>,
    /// χ² of the samples, over the noise that evidence counts with.
    pub chi2: f64,
    /// That of the priors with it.
    pub cost: f64,
    pub covariance: Option<DMatrix<f64>>,
}

/// A model of all swings.
#[derive(Debug, Clone)]
pub struct Model {
    pub set: Set,
    pub swings: Vec<One>,
}

/// All swings.
pub struct Swings<'a>(pub &'a [Swing<'a>]);

/// A swing linearised: numbers of its own and of every form.
pub struct Linear {
    /// Values of all, and the rows there that hold what the samples say.
    at: DVector<f64>,
    residuals: DVector<f64>,
    jacobian: DMatrix<f64>,
}

impl Rows for Linear {
    fn shape(&self) -> Shape {
        Shape::single(self.at.len())
    }

    fn rows(&self, _: usize, x: &[f64], _: &[f64], wanted: Wanted) -> Option<Block> {
        let moved = DVector::from_column_slice(x) - &self.at;
        Some(Block {
            residuals: &self.residuals + &self.jacobian * moved,
            jacobian: (wanted == Wanted::Jacobian).then(|| self.jacobian.clone()),
        })
    }
}

const LINEAR: Options = Options {
    most_steps: 30,
    gain: 1e-6,
    gain_share: 1e-12,
    keep: None,
};

impl One {
    fn of(fit: Fit) -> Self {
        Self {
            log_evidence: fit.log_evidence().ok(),
            chi2: fit.chi2,
            cost: fit.cost(),
            covariance: fit.covariance().ok(),
            x: fit.x,
        }
    }
}

impl Swing<'_> {
    /// A set fitted from where another model points, and from where the measurement ended if that is
    /// not what was promised.
    fn fitted(&self, set: &Set, pointed: Option<&One>) -> Option<One> {
        let effects = self.fittings(set);
        let problem = self.problem(&effects);
        let promised = pointed.map_or(f64::INFINITY, |one| one.cost + 2.0 * TOLD);
        let led = pointed.and_then(|one| solve_towards(&problem, &one.x, promised));
        let is_kept = |fit: &Fit| fit.ending.is_converged() && fit.cost() < promised;
        let fit = match led {
            Some(fit) if is_kept(&fit) => fit,
            led => {
                let anew = solve_towards(&problem, &self.start_of(set), promised);
                let fits = led.into_iter().chain(anew);
                fits.min_by(|a, b| a.cost().total_cmp(&b.cost()))?
            }
        };
        Some(One::of(fit))
    }

    /// Places of every form's numbers among all, and how many there are.
    fn places(&self) -> (Vec<usize>, usize) {
        let mut next = self.first_cause();
        let places = self.catalogue.iter().map(|cause| {
            let place = next;
            next += cause.known.len();
            place
        });
        (places.collect(), next)
    }

    fn linear(&self, set: &Set, one: &One) -> Option<Linear> {
        let first = self.first_cause();
        let (places, count) = self.places();
        let mut at = one.x[..first].to_vec();
        at.extend(self.catalogue.iter().flat_map(Cause::absent));
        for (form, _, own) in self.causes_of(set) {
            at[places[form]..places[form] + own.len()].copy_from_slice(&one.x[own]);
        }
        let effects = self.fittings(set);
        let problem = self.problem(&effects);
        let known = problem.rows(0, &one.x, &[], Wanted::Jacobian)?;
        let own = known.jacobian?;
        let mut jacobian = DMatrix::zeros(own.nrows(), count);
        jacobian
            .columns_mut(0, first)
            .copy_from(&own.columns(0, first));
        for (form, _, from) in self.causes_of(set) {
            let mut columns = jacobian.columns_mut(places[form], from.len());
            columns.copy_from(&own.columns(from.start, from.len()));
        }
        self.add_absent(set, &one.x, &mut jacobian)?;
        Some(compressed(at, known.residuals, jacobian))
    }

    /// Derivatives by the forms that are not in a set, all that do not exclude each other at once.
    fn add_absent(&self, set: &Set, x: &[f64], jacobian: &mut DMatrix<f64>) -> Option<()> {
        let (places, _) = self.places();
        let id = |form: &usize| self.catalogue[*form].id;
        let is_new = |form: &usize| set.iter().all(|known| id(known) != id(form));
        let mut open: Vec<usize> = (0..self.catalogue.len()).filter(is_new).collect();
        while !open.is_empty() {
            let mut together: Vec<usize> = Vec::new();
            open.retain(|form| {
                let is_alone = together.iter().any(|known| id(known) == id(form));
                if !is_alone {
                    together.push(*form);
                }
                is_alone
            });
            let all: Set = set.iter().chain(&together).copied().collect();
            let effects = self.fittings(&all);
            let problem = self.problem(&effects);
            let mut values = x.to_vec();
            for form in &together {
                values.extend(self.catalogue[*form].absent());
            }
            let slopes = problem.slopes_by(&values, x.len()..values.len())?;
            for (form, _, from) in self.causes_of(&all).skip(set.len()) {
                let mut columns = jacobian.columns_mut(places[form], from.len());
                columns.copy_from(&slopes.columns(from.start, from.len()));
            }
        }
        Some(())
    }

    /// Another set by a linearised one.
    fn predicted(&self, linear: &Linear, set: &Set) -> Option<One> {
        let first = self.first_cause();
        let (places, count) = self.places();
        let problem = self.problem(&[]);
        let mut parameters = problem.parameters();
        parameters.resize(count, Parameter::FREE);
        let mut start = linear.at.as_slice().to_vec();
        for (form, cause) in self.catalogue.iter().enumerate() {
            let own = places[form]..places[form] + cause.known.len();
            for (k, place) in own.enumerate() {
                if set.contains(&form) {
                    parameters[place] = cause.known[k];
                } else {
                    if cause.parameters[k].is_strength {
                        start[place] = 0.0;
                    }
                    parameters[place] = Parameter::FREE.fixed(start[place]);
                }
            }
        }
        let mut rows = ByRows::new(linear);
        let fit = minimise(&mut rows, &parameters, &start, &LINEAR, UNSTOPPED).ok()?;
        let all = One::of(fit);
        let kept: Vec<usize> =
            (0..first)
                .chain(set.iter().flat_map(|form| {
                    places[*form]..places[*form] + self.catalogue[*form].known.len()
                }))
                .collect();
        let covariance = all
            .covariance
            .map(|c| c.select_rows(&kept).select_columns(&kept));
        Some(One {
            x: kept.iter().map(|k| all.x[*k]).collect(),
            covariance,
            ..all
        })
    }
}

/// As many rows as there are numbers, and one more, that say the same as all.
fn compressed(at: Vec<f64>, residuals: DVector<f64>, jacobian: DMatrix<f64>) -> Linear {
    let count = jacobian.ncols();
    let mut both = jacobian.insert_column(count, 0.0);
    both.set_column(count, &residuals);
    let root = both.qr().r();
    Linear {
        at: at.into(),
        residuals: root.column(count).into_owned(),
        jacobian: root.columns(0, count).into_owned(),
    }
}

impl Swings<'_> {
    fn each(&self, of: impl Fn(usize) -> Option<One> + Sync) -> Option<Vec<One>> {
        in_parallel(self.0.len(), of).into_iter().collect()
    }
}

impl Competing for Swings<'_> {
    type Model = Model;
    type Linear = Vec<Linear>;

    fn forms(&self) -> Vec<Form> {
        let Some(first) = self.0.first() else {
            return vec![];
        };
        let shows = |form: usize| self.0.iter().any(|swing| swing.catalogue[form].shows);
        let form = |(k, cause): (usize, &Cause)| Form {
            id: cause.id,
            numbers: cause.known.len(),
            shows: shows(k),
        };
        first.catalogue.iter().enumerate().map(form).collect()
    }

    fn log_evidence(&self, model: &Model) -> Option<f64> {
        let swings = self.0.iter().zip(&model.swings);
        let each = swings.map(|(swing, one)| {
            let mut causes = swing.causes_of(&model.set);
            let is_at_edge = causes.any(|(_, cause, own)| cause.is_at_edge(&one.x[own]));
            one.log_evidence.filter(|_| !is_at_edge)
        });
        each.sum()
    }

    fn fitted(&self, set: &Set, pointed: Option<&Model>) -> Option<Model> {
        let swings = self.each(|s| {
            let swing = &self.0[s];
            swing.fitted(set, pointed.map(|model| &model.swings[s]))
        })?;
        Some(Model {
            set: set.clone(),
            swings,
        })
    }

    fn linear(&self, set: &Set, model: &Model) -> Option<Vec<Linear>> {
        let each = |s: usize| self.0[s].linear(set, &model.swings[s]);
        in_parallel(self.0.len(), each).into_iter().collect()
    }

    fn predicted(&self, linear: &Vec<Linear>, set: &Set) -> Option<Model> {
        let each = |s: usize| self.0[s].predicted(&linear[s], set);
        let swings = (0..self.0.len()).map(each).collect::<Option<Vec<One>>>()?;
        Some(Model {
            set: set.clone(),
            swings,
        })
    }
}

impl One {
    /// Standard uncertainty of the logarithm of the frequency, for the noise that evidence counts with.
    pub fn frequency_u(&self) -> Option<f64> {
        let variance = self.covariance.as_ref()?[(FREQUENCY, FREQUENCY)];
        Some(variance.max(0.0).sqrt())
    }

    /// By what factor it is larger where more is left than that noise.
    pub fn wider(&self, swing: &Swing, set: &Set) -> f64 {
        let covariance = self.covariance.as_ref();
        let dispersion = covariance.and_then(|c| swing.dispersion(set, &self.x, c));
        dispersion.unwrap_or(1.0).max(1.0).sqrt()
    }
}
