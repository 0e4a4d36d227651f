//! The fit of one swing.

use nalgebra::DMatrix;

use gyradius_estimation::{
    Block, ByRows, Options, Parameter, Rows, Shape, UNSTOPPED, Wanted, minimise,
};

use super::super::fitted_swing::HORIZONS_S;
use super::super::point::Part;
use super::causes::Cause;
use super::swing::{DAMPING, Swing};

const OPTIONS: Options = Options {
    most_steps: 60,
    // A hundredth of a standard deviation.
    gain: 1e-4,
    // Derivatives by differences are good to a few times this.
    gain_share: 1e-9,
    keep: None,
};

/// A swing fitted.
#[derive(Clone)]
pub struct Fitted {
    pub point: Vec<f64>,
    /// χ² of samples and priors, of the samples alone, and how many rows they have.
    pub cost: f64,
    pub chi2: f64,
    pub rows: usize,
    /// Half of the second derivative of the cost; what stands at a bound has the width of its
    /// prior, so that it neither gains nor costs evidence.
    pub matrix: DMatrix<f64>,
    /// Logarithm of the evidence; none where it cannot be told.
    pub log_evidence: Option<f64>,
}

impl Fitted {
    pub fn covariance(&self) -> Option<DMatrix<f64>> {
        Some(self.matrix.clone().cholesky()?.inverse())
    }
}

/// What is fitted to which part of a swing.
struct Problem<'a> {
    swing: &'a Swing<'a>,
    causes: &'a [&'a Cause],
    part: Part,
    count: usize,
}

impl Rows for Problem<'_> {
    fn shape(&self) -> Shape {
        Shape::single(self.count)
    }

    fn rows(&self, _: usize, point: &[f64], _: &[f64], wanted: Wanted) -> Option<Block> {
        let residuals = self.swing.residual(point, self.causes, self.part)?;
        let jacobian = match wanted {
            Wanted::Residuals => None,
            // That of measured less simulated.
            Wanted::Jacobian => Some(-self.swing.jacobian(point, self.causes, self.part)?),
        };
        Some(Block {
            residuals,
            jacobian,
        })
    }
}

/// Priors and bounds of everything that is fitted to a swing.
fn parameters(swing: &Swing, causes: &[&Cause]) -> Vec<Parameter> {
    let priors = swing.priors(causes);
    let mut parameters: Vec<Parameter> = priors
        .into_iter()
        .map(|(mean, u)| Parameter::FREE.with_prior(mean, u))
        .collect();
    for k in swing.one_sided(causes) {
        parameters[k].low = 0.0;
    }
    for (k, most) in swing.line_limits() {
        parameters[k] = parameters[k].within(-most, most);
    }
    parameters
}

/// Fits a swing with causes from a start; `None` where no motion can be computed there.
pub fn fit(swing: &Swing, causes: &[&Cause], part: Part, start: &[f64]) -> Option<Fitted> {
    let parameters = parameters(swing, causes);
    let problem = Problem {
        swing,
        causes,
        part,
        count: parameters.len(),
    };
    let mut equations = ByRows::new(&problem);
    let found = minimise(&mut equations, &parameters, start, &OPTIONS, UNSTOPPED).ok()?;
    Some(Fitted {
        cost: found.cost(),
        chi2: found.chi2,
        rows: swing.times_s(part).len(),
        matrix: found.information(),
        log_evidence: found.log_evidence().ok(),
        point: found.x,
    })
}

/// The same from what the spectrum says, led over longer and longer parts of the recording: a phase
/// known over one stays within a quarter of a cycle over the next.
pub fn fit_from_afar(swing: &Swing) -> Option<Fitted> {
    let mut point = swing.start.clone();
    for horizon_s in HORIZONS_S.into_iter().filter(|h| *h < swing.duration_s) {
        if let Some(fitted) = fit(swing, &[], Part::First(horizon_s), &point) {
            point = fitted.point;
            // A few swings say little of how they die away, and a rate that is wrong runs away over
            // the next part.
            point[DAMPING] = swing.start_damping_per_s();
        }
    }
    fit(swing, &[], Part::All, &point)
}
