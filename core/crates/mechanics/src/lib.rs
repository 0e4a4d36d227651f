//! The body on its lines: small oscillations and full motion.
//!
//! May know `error`, `constants`, `frames`. Must never know `modes` or `signal`: a simulation that
//! knows the estimator makes every simulated test circular.
//!
//! # Conventions
//! **World axes**: z up; gravity is −z. **Hanging axes** are fixed in the body and agree with the
//! world axes when the body hangs level: the suspension points lie where the [`Rig`] says. A hull
//! hung level has hanging axes = hull axes; a pitched hull enters by [`RigidBody::rotated`]. Body
//! points count from the mid-point of the two suspension points.

mod constraint;
mod dop853;
pub mod effects;
mod equations;
mod equilibrium;
mod experiment;
mod numbers;
pub mod one_angle;
mod path;
mod phone;
mod pose;
mod real;
mod rig;
mod scene;
mod sensor;
pub mod sensors;
mod small;
mod start;
mod state;
mod suspended;
mod trajectory;

pub use equilibrium::Equilibrium;
pub use experiment::{Draws, Experiment, Jet, Record};
pub use numbers::{Number, Numbers};
pub use path::{Fineness, Moment, Path, Slack};
pub use phone::{Mounted, Phone, Reading};
pub use pose::Pose;
pub use real::{Dual, M3, Real, V3, is_still};
pub use rig::{Hanging, Line, Rig, RigidBody, SuspensionAxis};
pub use scene::{Body, Dimensions, LANES, Scene};
pub use sensor::{IdealPhone, ideal_phone};
pub use small::{
    ModeKind, SmallEffects, SmallModes, compound_pendulum_period_s, mode_kind, small_modes,
};
pub use start::Start;
pub use trajectory::{Damping, ModalPart, Sampling, State, Trajectory, initial_state, simulate};
