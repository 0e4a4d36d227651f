//! The simulation fitted to the samples of a swing.
//!
//! Lines in a spectrum hold for small motions; where yaw, sway and pitch act on each other (Kane
//! and Tseng), or where a pitching hull's roll inertia enters its yaw, a swing is no sum of lines.
//! Here the full motion of the body on its lines is fitted to the samples themselves: body and
//! dimensions are the session's parameters with their priors, and each swing has its own start,
//! damping, phone pose and biases. What a swing says of the session's parameters goes into the
//! joint estimate as linear rows.
//!
//! # Conventions
//! Times count from the start of the free span, by the phone's clock. The body hangs in hanging
//! axes (level at rest).

mod equations;
mod expected;
mod fit;
mod linearise;
mod model;
mod modes;
mod nodes;
mod record;
mod scene;
mod session;
mod turn;

pub use expected::expected_statements;
pub use model::Statement;
pub(crate) use record::{BLOCK_OF_PERIOD, blocks, inside};
pub use record::{Recorded, Samples, Sensor, Stream};
pub use scene::{LANES, Own, SHARED_LANES, SwingSetup, place};
pub use session::{FittedSwing, WHITE, Ways};
pub use turn::turn_slopes;
