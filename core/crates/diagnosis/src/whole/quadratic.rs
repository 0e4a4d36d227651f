//! What a linearised model says of the numbers of causes: those that are in it, and the strengths of
//! those that are not, everything else made the best of.

use std::f64::consts::LN_2;

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};
use statrs::distribution::{ContinuousCDF, Normal};

use gyradius_estimation::log_tail;

/// A number of a cause in the model, or a strength of one that is not.
#[derive(Debug, Clone, Copy)]
pub struct Number {
    pub value: f64,
    /// Mean and standard deviation of its prior.
    pub prior: (f64, f64),
    /// Its cause does nothing where it is zero.
    pub is_strength: bool,
    /// It has no meaning below zero.
    pub one_sided: bool,
    /// It is none of the model's.
    pub is_new: bool,
}

/// Half of χ² of samples and priors about the model, as a quadratic form of changes of the numbers.
pub struct Quadratic {
    numbers: Vec<Number>,
    /// Priors included.
    information: DMatrix<f64>,
    /// Downhill.
    pull: DVector<f64>,
    /// Logarithm of the model's evidence, but for the determinant of its own numbers' information.
    log_evidence: f64,
}

/// The best changes with some of the numbers.
pub struct Solved {
    /// Logarithm of the evidence.
    pub log_evidence: f64,
    /// Number by number; of the model's that are left out, those of strengths to zero.
    pub delta: DVector<f64>,
}

impl Quadratic {
    /// Of a model with its evidence. `None` where its own numbers are not all known.
    pub fn of(
        numbers: Vec<Number>,
        information: DMatrix<f64>,
        pull: DVector<f64>,
        log_evidence: f64,
    ) -> Option<Self> {
        let all = 0..numbers.len();
        let own: Vec<usize> = all.filter(|k| !numbers[*k].is_new).collect();
        let part = information.select_rows(&own).select_columns(&own);
        let half = half_log_determinant(&part.cholesky()?);
        Some(Self {
            numbers,
            information,
            pull,
            log_evidence: log_evidence + half,
        })
    }

    /// With some of the numbers, places among all, and without the model's others. Strengths that would
    /// fall below zero stay there.
    pub fn solved(&self, with: &[usize]) -> Option<Solved> {
        let gone = (0..self.numbers.len())
            .filter(|k| !self.numbers[*k].is_new && !with.contains(k))
            .collect::<Vec<usize>>();
        let mut delta = DVector::zeros(self.numbers.len());
        for k in gone.iter().filter(|k| self.numbers[**k].is_strength) {
            delta[*k] = -self.numbers[*k].value;
        }
        let left_out = gone.iter().map(|k| self.without(*k, delta[*k]));
        let mut log_evidence = self.log_evidence + left_out.sum::<f64>();
        let (mut open, mut closed) = (with.to_vec(), vec![]);
        loop {
            let pull = &self.pull - &self.information * &delta;
            let part = self.information.select_rows(&open).select_columns(&open);
            let factor = part.cholesky()?;
            let wanted = pull.select_rows(&open);
            let found = factor.solve(&wanted);
            if let Some(worst) = self.worst(&open, &found) {
                let place = open.remove(worst);
                delta[place] = -self.numbers[place].value;
                closed.push(place);
                continue;
            }
            let half = half_log_determinant(&factor);
            let variances = factor.inverse().diagonal();
            for (i, k) in open.iter().enumerate() {
                log_evidence += self.opened(*k, found[i], variances[i].sqrt());
            }
            // Strengths at zero pull below it; those that are open follow them.
            for k in closed {
                let beside = self.information.column(k).select_rows(&open);
                let followed = factor.solve(&beside);
                let information = self.information[(k, k)] - beside.dot(&followed);
                let slope = followed.dot(&wanted) - pull[k];
                log_evidence += log_tail(slope.max(0.0), information) - self.prior_of_new(k);
            }
            open.iter()
                .zip(found.iter())
                .for_each(|(k, x)| delta[*k] = *x);
            let change = delta.dot(&(&self.information * &delta)) - 2.0 * self.pull.dot(&delta);
            return Some(Solved {
                log_evidence: log_evidence - 0.5 * change - half,
                delta,
            });
        }
    }

    /// What the evidence gains by a number of the model that is left out: its prior, at the value that
    /// stands in the quadratic form, and the width of that.
    fn without(&self, k: usize, delta: f64) -> f64 {
        let number = self.numbers[k];
        let (mean, u) = number.prior;
        let away = (number.value + delta - mean) / u;
        let side = if number.one_sided { LN_2 } else { 0.0 };
        0.5 * away * away + u.ln() - side
    }

    /// Logarithm of the width of the prior of a new one.
    fn prior_of_new(&self, k: usize) -> f64 {
        let number = self.numbers[k];
        let side = if number.one_sided { LN_2 } else { 0.0 };
        if number.is_new {
            number.prior.1.ln() - side
        } else {
            0.0
        }
    }

    /// What a new number that is free adds, beside the determinant.
    fn opened(&self, k: usize, found: f64, u: f64) -> f64 {
        let number = self.numbers[k];
        if !number.is_new {
            return 0.0;
        }
        let above = if number.one_sided {
            Normal::standard().cdf((number.value + found) / u).ln()
        } else {
            0.0
        };
        above - self.prior_of_new(k)
    }

    /// Of the strengths that would fall below zero, the furthest, in standard deviations of their
    /// priors: their units differ.
    fn worst(&self, open: &[usize], found: &DVector<f64>) -> Option<usize> {
        let there = |i: usize| {
            let number = self.numbers[open[i]];
            (number.value + found[i]) / number.prior.1
        };
        let below = |i: &usize| self.numbers[open[*i]].one_sided && there(*i) < 0.0;
        let all = (0..open.len()).filter(below);
        all.min_by(|a, b| there(*a).total_cmp(&there(*b)))
    }
}

fn half_log_determinant(factor: &Cholesky<f64, Dyn>) -> f64 {
    factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Eight readings with noise of 1 that are sums of three columns; the first is in the model, at
    /// where it is likeliest.
    struct Columns {
        readings: DVector<f64>,
        columns: DMatrix<f64>,
        one_sided: [bool; 3],
    }

    const U: f64 = 3.0;

    impl Columns {
        fn new(signs: [f64; 3]) -> Self {
            let columns = DMatrix::from_fn(8, 3, |i, k| ((i + 1) as f64 * (k as f64 + 0.7)).sin());
            let truth = DVector::from_column_slice(&signs);
            let noise = DVector::from_fn(8, |i, _| 0.3 * (1.9 * i as f64).cos());
            Self {
                readings: &columns * truth + noise,
                columns,
                one_sided: [false; 3],
            }
        }

        fn quadratic(&self) -> Quadratic {
            let first = self.columns.column(0);
            let information = first.norm_squared() + U.powi(-2);
            let value = first.dot(&self.readings) / information;
            let left = &self.readings - first * value;
            let mut pull = self.columns.tr_mul(&left);
            pull[0] -= value * U.powi(-2);
            let square = left.norm_squared() + (value / U).powi(2);
            let number = |k: usize| Number {
                value: if k == 0 { value } else { 0.0 },
                prior: (0.0, U),
                is_strength: true,
                one_sided: self.one_sided[k],
                is_new: k > 0,
            };
            Quadratic::of(
                (0..3).map(number).collect(),
                self.columns.tr_mul(&self.columns) + DMatrix::identity(3, 3) * U.powi(-2),
                pull,
                -0.5 * square - U.ln() - 0.5 * information.ln(),
            )
            .unwrap()
        }

        /// Logarithm of the density of the readings, up to that of the noise alone: normal, with the
        /// covariance 1 + u² C Cᵀ.
        fn log_evidence(&self, with: &[usize]) -> f64 {
            let columns = self.columns.select_columns(with);
            let covariance = DMatrix::identity(8, 8) + U * U * &columns * columns.transpose();
            let root = covariance.clone().cholesky().unwrap();
            let square = self.readings.dot(&root.solve(&self.readings));
            -0.5 * (square + covariance.determinant().ln())
        }
    }

    #[test]
    fn every_set_has_the_evidence_of_its_normal_density() {
        let columns = Columns::new([1.0, -0.4, 0.2]);
        let quadratic = columns.quadratic();
        for with in [
            vec![],
            vec![0],
            vec![1],
            vec![0, 2],
            vec![1, 2],
            vec![0, 1, 2],
        ] {
            let found = quadratic.solved(&with).unwrap();
            let expected = columns.log_evidence(&with);
            let off = found.log_evidence - expected;
            assert!(off.abs() < 1e-9, "{with:?}: {off}");
        }
    }

    /// One column more whose strength cannot be below zero: the integral over it by the trapezium
    /// rule, of the density of the readings with that strength times a half normal prior.
    #[test]
    fn a_strength_of_one_sign_has_the_evidence_of_its_side() {
        for strength in [0.9, 0.05, -0.4] {
            let mut columns = Columns::new([1.0, strength, 0.0]);
            columns.one_sided[1] = true;
            let found = columns.quadratic().solved(&[0, 1]).unwrap();
            let density = |x: f64| {
                let left = Columns {
                    readings: &columns.readings - columns.columns.column(1) * x,
                    columns: columns.columns.clone(),
                    one_sided: [false; 3],
                };
                let prior =
                    2.0 / (U * std::f64::consts::TAU.sqrt()) * (-0.5 * (x / U).powi(2)).exp();
                left.log_evidence(&[0]).exp() * prior
            };
            let step = 1e-3;
            let inner: f64 = (1..6000).map(|k| density(step * f64::from(k))).sum();
            let expected = (step * (inner + 0.5 * density(0.0))).ln();
            let off = found.log_evidence - expected;
            assert!(off.abs() < 1e-6, "{strength}: {off}");
        }
    }
}
