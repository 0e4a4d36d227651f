//! What a fit has found.

use std::f64::consts::PI;
use std::fmt;

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use statrs::function::erf::erfc;

use crate::factor::Factor;
use crate::normal::Normal;
use crate::parameter::{Parameter, Side};

/// Why a fit ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ending {
    /// The best step of all promises less than what counts: converged.
    Gain,
    /// The slope of χ² is nothing but rounding: converged.
    Gradient,
    /// No step that could still gain what counts leads down: converged as far as χ² can tell.
    Step,
    /// The steps were used up.
    Iterations,
    /// The caller asked to stop.
    Stopped,
    /// Derivatives cannot be computed where the last step led.
    NoDerivatives,
}

impl Ending {
    /// Whether nothing that counts was left to gain.
    pub fn is_converged(self) -> bool {
        match self {
            Ending::Gain | Ending::Gradient | Ending::Step => true,
            Ending::Iterations | Ending::Stopped | Ending::NoDerivatives => false,
        }
    }
}

/// Why there is no fit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Error {
    /// χ² or its derivatives cannot be computed at the start, or are not finite there.
    NoFiniteStart,
    /// Lists of parameters or of the start are not as long as the problem says.
    Count {
        /// By the problem's shape.
        expected: usize,
        /// In the list.
        found: usize,
    },
    /// A prior without a positive finite width or bounds in the wrong order.
    Parameter {
        /// Place of the parameter.
        place: usize,
    },
    /// The data and priors do not determine every parameter: there is no covariance.
    Undetermined,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Error::NoFiniteStart => write!(f, "χ² is not finite at the start"),
            Error::Count { expected, found } => {
                write!(f, "expected {expected} parameters, found {found}")
            }
            Error::Parameter { place } => {
                write!(f, "prior or bounds of parameter {place} are not valid")
            }
            Error::Undetermined => write!(f, "the data do not determine every parameter"),
        }
    }
}

impl std::error::Error for Error {}

/// A parameter that stands at a bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Edge {
    /// Place of the parameter.
    pub place: usize,
    /// Which bound.
    pub side: Side,
    /// Whether χ² falls beyond the bound: the parameter is held there, and its uncertainty is not
    /// that of a free one.
    pub is_pressed: bool,
}

/// A fit.
#[derive(Debug, Clone)]
pub struct Fit {
    /// All parameters.
    pub x: Vec<f64>,
    /// χ² of the data.
    pub chi2: f64,
    /// χ² of the priors.
    pub prior_chi2: f64,
    /// Normal equations there, priors in them; where derivatives failed, those of the last point
    /// that had them.
    pub normal: Normal,
    /// Parameters at a bound; fixed ones are none.
    pub edges: Vec<Edge>,
    /// Why it ended.
    pub ending: Ending,
    /// Steps taken.
    pub steps: usize,
    /// Points at which χ² was computed, and those with new derivatives.
    pub evaluations: (usize, usize),
    pub(crate) parameters: Vec<Parameter>,
}

impl Fit {
    /// χ² of data and priors.
    pub fn cost(&self) -> f64 {
        self.chi2 + self.prior_chi2
    }

    /// Which parameters cannot move: fixed ones, and those pressed against a bound.
    pub fn held(&self) -> Vec<bool> {
        let mut held: Vec<bool> = self.parameters.iter().map(Parameter::is_fixed).collect();
        self.edges
            .iter()
            .filter(|edge| edge.is_pressed)
            .for_each(|edge| held[edge.place] = true);
        held
    }

    /// Factor of the information; held parameters are left out.
    ///
    /// # Errors
    /// [`Error::Undetermined`] where data and priors leave a direction open.
    pub fn factor(&self) -> Result<Factor, Error> {
        Factor::new(&self.normal, None, &self.held()).ok_or(Error::Undetermined)
    }

    /// Covariance of all parameters, for residuals in standard deviations of white noise (JCGM
    /// 102, 8.1); zero by a held one.
    ///
    /// # Errors
    /// As [`Self::factor`].
    pub fn covariance(&self) -> Result<DMatrix<f64>, Error> {
        self.factor().map(|f| f.covariance())
    }

    /// Standard deviations of all parameters, the square roots of the covariance's diagonal, at a
    /// cost that is linear in the number of blocks.
    ///
    /// # Errors
    /// As [`Self::factor`].
    pub fn standard_deviations(&self) -> Result<DVector<f64>, Error> {
        self.factor().map(|f| f.variances().map(f64::sqrt))
    }

    /// Logarithm of the evidence by Laplace's approximation: of the integral, within the bounds, of
    /// the likelihood (1 where χ² of the data is zero) times the priors, which are normalised
    /// there. A parameter without a prior counts as if it had one of width 1.
    ///
    /// Each bounded parameter is taken as normal beside the others, also where it is held: there
    /// the normal distribution has its middle beyond the bound, and its tail counts (N. L.
    /// Johnson, S. Kotz, N. Balakrishnan, *Continuous Univariate Distributions* 1, 2nd ed., sec.
    /// 13.10.1). A parameter that comes to its bound thus makes no jump.
    ///
    /// # Errors
    /// As [`Self::factor`].
    pub fn log_evidence(&self) -> Result<f64, Error> {
        let (factor, held) = (self.factor()?, self.held());
        let (variances, gradient) = (factor.variances(), self.normal.whole_gradient());
        let whole = self.normal.dense();
        let share = |k: usize| {
            let (parameter, x) = (&self.parameters[k], self.x[k]);
            if parameter.is_fixed() {
                return 0.0;
            }
            if !held[k] {
                return parameter.mass(x, variances[k].sqrt()).ln();
            }
            // Those that are not held follow it.
            let beside = whole.column(k).into_owned();
            let information = whole[(k, k)] - beside.dot(&factor.solve(&beside));
            log_tail(gradient[k].abs(), information)
        };
        let prior = |p: &Parameter| match p.prior {
            Some((mean, u)) if !p.is_fixed() => u.ln() + p.mass(mean, u).ln(),
            _ => 0.0,
        };
        let shares: f64 = (0..self.x.len()).map(share).sum();
        let priors: f64 = self.parameters.iter().map(prior).sum();
        Ok(shares - factor.half_log_determinant() - priors - 0.5 * self.cost())
    }

    /// The whole information matrix. What is held is set apart: it hangs together with nothing and
    /// has the information of its prior alone, zero without one.
    pub fn information(&self) -> DMatrix<f64> {
        let mut whole = self.normal.dense();
        for (k, held) in self.held().into_iter().enumerate() {
            if held {
                whole.row_mut(k).fill(0.0);
                whole.column_mut(k).fill(0.0);
                whole[(k, k)] = self.parameters[k].prior.map_or(0.0, |(_, u)| u.powi(-2));
            }
        }
        whole
    }

    /// Directions that data and priors leave open, of unit length in the parameters' own scales
    /// (the square roots of the information's diagonal); the rank is the number of all parameters
    /// that are not held, less these. A direction is open where its eigenvalue is rounding of the
    /// largest: below `n·ε` of it.
    pub fn undetermined(&self) -> Vec<DVector<f64>> {
        let (whole, held) = (self.normal.dense(), self.held());
        let free: Vec<usize> = (0..held.len()).filter(|k| !held[*k]).collect();
        let unit = |k: usize| Some(whole[(k, k)].sqrt()).filter(|u| *u > 0.0);
        let scaled = DMatrix::from_fn(free.len(), free.len(), |i, j| {
            let (i, j) = (free[i], free[j]);
            let size = unit(i).unwrap_or(1.0) * unit(j).unwrap_or(1.0);
            whole[(i, j)] / size
        });
        let eigen = SymmetricEigen::new(scaled);
        let least = free.len() as f64 * f64::EPSILON * eigen.eigenvalues.amax();
        let open = (0..free.len()).filter(|k| eigen.eigenvalues[*k] <= least);
        open.map(|k| {
            let mut all = DVector::zeros(held.len());
            free.iter()
                .zip(eigen.eigenvectors.column(k).iter())
                .for_each(|(place, part)| all[*place] = *part);
            all
        })
        .collect()
    }

    /// How many directions of the parameters that are not held are determined.
    pub fn rank(&self) -> usize {
        let free = self.held().iter().filter(|held| !**held).count();
        free - self.undetermined().len()
    }
}

/// `ln ∫₀^∞ exp(−slope·x − information·x²/2) dx/√(2π)`, for a slope that is not negative: what a
/// parameter held at its bound adds to the evidence.
pub fn log_tail(slope: f64, information: f64) -> f64 {
    let z = slope / (2.0 * information).sqrt();
    log_scaled_erfc(z) - 2f64.ln() - 0.5 * information.ln()
}

/// `ln(exp(z²)·erfc(z))` for `z ≥ 0`; far out by its asymptotic series (M. Abramowitz, I. A. Stegun,
/// *Handbook of Mathematical Functions*, eq. 7.1.23), there good to 1e-9.
fn log_scaled_erfc(z: f64) -> f64 {
    const FAR: f64 = 20.0;
    if z < FAR {
        return z * z + erfc(z).ln();
    }
    let w = 0.5 / (z * z);
    (1.0 - w * (1.0 - 3.0 * w * (1.0 - 5.0 * w))).ln() - (z * PI.sqrt()).ln()
}
