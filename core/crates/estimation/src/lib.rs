//! Nonlinear least squares: Gaussian priors, box bounds, shared parameters and blocks of own ones.
//!
//! [`minimise`] is the one solver of the project: a trust region with Moré's scaling, an active
//! set for bounds, and the Schur complement for blocks. Derivatives are exact; the problem hands
//! them over as rows ([`Rows`] by [`ByRows`]) or as normal equations that it has added up itself
//! ([`Problem`]).
//!
//! # Why our own
//! `levenberg-marquardt` and `argmin` know neither priors, bounds nor blocks; `tiny-solver` and
//! `apex-solver` have priors and (the latter) the Schur complement, but clip what leaves a bound
//! instead of solving for the rest, do not tell what stands at one, and take rows alone. Fits of
//! long recordings add up normal equations without keeping rows, and need a covariance that knows
//! what is held.
//!
//! # Example
//! ```
//! use gyradius_estimation::{Block, ByRows, Options, Parameter, Rows, Shape, UNSTOPPED, Wanted};
//! use nalgebra::{DMatrix, DVector};
//!
//! /// `exp(−x·t)` read as 0.5 at `t = 1`, to 0.01.
//! struct Decay;
//! impl Rows for Decay {
//!     fn shape(&self) -> Shape {
//!         Shape::single(1)
//!     }
//!     fn rows(&self, _: usize, x: &[f64], _: &[f64], wanted: Wanted) -> Option<Block> {
//!         let value = (-x[0]).exp();
//!         Some(Block {
//!             residuals: DVector::from_element(1, (value - 0.5) / 0.01),
//!             jacobian: (wanted == Wanted::Jacobian)
//!                 .then(|| DMatrix::from_element(1, 1, -value / 0.01)),
//!         })
//!     }
//! }
//! let free = [Parameter::FREE];
//! let options = Options::default();
//! let fit = gyradius_estimation::minimise(
//!     &mut ByRows::new(&Decay), &free, &[0.0], &options, UNSTOPPED)?;
//! assert!(fit.ending.is_converged());
//! assert!((fit.x[0] - 2f64.ln()).abs() < 1e-3);
//! # Ok::<(), gyradius_estimation::Error>(())
//! ```

mod factor;
mod fit;
mod normal;
mod parameter;
mod problem;
mod quadratic;
mod region;
mod shape;
mod solver;

pub use factor::Factor;
pub use fit::{Edge, Ending, Error, Fit, log_tail};
pub use normal::{Normal, Own};
pub use parameter::{Parameter, Side};
pub use problem::{Block, ByRows, Problem, Rows, Slopes, Wanted};
pub use shape::Shape;
pub use solver::{Keep, Options, Progress, Stop, UNSTOPPED, minimise};
