//! What a linear propagation at one solution leaves out of an uncertainty: a product of inertia that
//! acts on roll by its square, and a session that contradicts itself, in which any one of several
//! stated figures could be the wrong one.
//!
//! Both are averages over solutions with weights by their likelihood (law of total variance): a
//! quantity's variance is the mean of its variances plus the variance of its values.

use gyradius_recording::Quantity;

use super::estimate::{Derived, Solution, System};
use super::names::Input;
use super::suspects::{Freed, explanations};

/// The product of inertia is stepped so many standard uncertainties either way, in steps of
/// [`STEP_U`]: a normal distribution has 0.3 % of its variance beyond.
const STEPS: i32 = 5;
const STEP_U: f64 = 0.75;
/// A session solved in every way that its data allow.
pub struct Spread<'a> {
    /// The likeliest.
    main: Solved<'a>,
    /// Others, each with its weight; those of all add to 1.
    others: Vec<(f64, Solution)>,
    main_weight: f64,
    /// What was opened; empty unless the session contradicts itself.
    pub suspects: Vec<Input>,
}

/// A solution of a system, and how it goes with the product of inertia.
struct Solved<'a> {
    system: System<'a>,
    solution: Solution,
    /// The same with the product of inertia held, and its values to either side by weight; none
    /// where nothing was solved.
    product: Option<Product>,
}

struct Product {
    held: Solution,
    by_value: Vec<(f64, Vec<f64>)>,
    /// Variance that is left of its prior's.
    of_prior: f64,
}

impl<'a> Spread<'a> {
    /// Solves the session with its product of inertia held at several values; where it contradicts
    /// itself beyond chance, with each stated figure that would explain it set free.
    pub fn of(system: &System<'a>, solution: &Solution) -> Self {
        let mut freed = match solution.birge > 1.0 {
            true => explanations(system, solution),
            false => vec![],
        };
        freed.sort_by(|a, b| a.solution.chi2.total_cmp(&b.solution.chi2));
        let mut suspects: Vec<Input> = Vec::new();
        for one in &freed {
            if !suspects.contains(&one.suspect) {
                suspects.push(one.suspect.clone());
            }
        }
        let least = freed.first().map_or(0.0, |one| one.solution.chi2);
        let weight = |one: &Freed| (-0.5 * (one.solution.chi2 - least)).exp();
        let total: f64 = freed.iter().map(weight).sum();
        let weights: Vec<f64> = freed.iter().map(|one| weight(one) / total).collect();
        let mut all = freed.into_iter().zip(weights);
        let (main, main_weight) = match all.next() {
            Some((one, weight)) => (Solved::of(one.system, one.solution), weight),
            None => {
                let same = system.with(system.layout.clone());
                (Solved::of(same, solution.clone()), 1.0)
            }
        };
        Self {
            main,
            others: all.map(|(one, weight)| (weight, one.solution)).collect(),
            main_weight,
            suspects,
        }
    }

    /// The likeliest solution.
    pub fn solution(&self) -> &Solution {
        &self.main.solution
    }

    /// The system that it is a solution of.
    pub fn system(&self) -> &System<'a> {
        &self.main.system
    }

    /// A function of the parameters: its mean over all solutions, and what each input contributes to
    /// its uncertainty.
    pub fn derive(&self, f: impl Fn(&[f64]) -> Option<f64>) -> Option<Averaged> {
        let mut main = self.main.derive(&f)?;
        let mut values = vec![(self.main_weight, main.derived.value)];
        for (weight, other) in &self.others {
            values.push((*weight, f(&other.x)?));
        }
        let mean: f64 = values.iter().map(|(weight, value)| weight * value).sum();
        let rows = values
            .iter()
            .map(|(weight, value)| weight.sqrt() * (value - mean));
        let doubt: Vec<f64> = rows.collect();
        main.by_doubt = norm(&doubt);
        main.derived.value = mean;
        main.derived.append(&doubt);
        Some(main)
    }
}

/// A scalar with what is not in the rows of one solution.
pub struct Averaged {
    /// The scalar; its rows are those of the likeliest solution, and one for each other that it is
    /// averaged over.
    pub derived: Derived,
    /// What the product of inertia contributes.
    pub by_product: f64,
    /// What the doubt contributes, which stated figure is wrong.
    pub by_doubt: f64,
}

impl<'a> Solved<'a> {
    fn of(system: System<'a>, solution: Solution) -> Self {
        let product = Product::of(&system, &solution);
        Self {
            system,
            solution,
            product,
        }
    }

    fn derive(&self, f: &dyn Fn(&[f64]) -> Option<f64>) -> Option<Averaged> {
        let layout = &self.system.layout;
        let plain = || {
            let derived = self.solution.derive(layout, f)?;
            Some(Averaged {
                derived,
                by_product: 0.0,
                by_doubt: 0.0,
            })
        };
        let Some(product) = &self.product else {
            return plain();
        };
        let Some(mut derived) = product.held.derive(layout, f) else {
            return plain();
        };
        let rows: Option<Vec<f64>> = product
            .by_value
            .iter()
            .map(|(weight, x)| Some(weight.sqrt() * (f(x)? - derived.value)))
            .collect();
        let rows = rows?;
        let by_product = norm(&rows);
        // What goes with the product itself is known by its prior alone where that decides it; what
        // goes with its square is a correction of what was measured.
        let odd: Vec<f64> = rows
            .iter()
            .zip(rows.iter().rev())
            .map(|(ahead, back)| 0.5 * (ahead - back))
            .collect();
        let weak =
            derived.weak_share * derived.u * derived.u + product.of_prior * norm(&odd).powi(2);
        derived.append(&rows);
        derived.weak_share = weak / (derived.u * derived.u).max(f64::MIN_POSITIVE);
        Some(Averaged {
            derived,
            by_product,
            by_doubt: 0.0,
        })
    }
}

impl Product {
    fn of(system: &System, solution: &Solution) -> Option<Self> {
        let place = system.layout.product_xz;
        let (u, prior) = (solution.u(place), system.layout.parameters[place].prior);
        if u == 0.0 {
            return None;
        }
        let held_at = |step: i32| {
            let value = solution.x[place] + f64::from(step) * STEP_U * u;
            let mut layout = system.layout.clone();
            layout.parameters[place].prior = Quantity::new(value, 1e-6 * u);
            let mut start = solution.x.clone();
            start[place] = value;
            let held = system.with(layout).solve(&start).ok()?;
            let chi2 = held.chi2 + ((value - prior.value) / prior.u).powi(2);
            Some((chi2, held))
        };
        let (least, mut held) = held_at(0)?;
        held.birge = solution.birge;
        let mut by_value: Vec<(f64, Vec<f64>)> = Vec::new();
        let (mut total, mut mean, mut square) = (0.0, 0.0, 0.0);
        for step in -STEPS..=STEPS {
            let Some((chi2, at)) = held_at(step) else {
                continue;
            };
            let weight = (-0.5 * (chi2 - least) / solution.birge.powi(2)).exp();
            total += weight;
            mean += weight * at.x[place];
            square += weight * (at.x[place] - solution.x[place]).powi(2);
            by_value.push((weight, at.x));
        }
        by_value.iter_mut().for_each(|(weight, _)| *weight /= total);
        let off = mean / total - solution.x[place];
        let variance = square / total - off * off;
        Some(Self {
            held,
            by_value,
            of_prior: (variance / prior.u.powi(2)).min(1.0),
        })
    }
}

fn norm(rows: &[f64]) -> f64 {
    rows.iter().map(|r| r * r).sum::<f64>().sqrt()
}
