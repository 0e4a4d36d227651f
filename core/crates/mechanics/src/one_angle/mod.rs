//! A body that swings in one angle about a fixed axis, as far as it goes: what brings it back
//! ([`Law`]), what brakes it, and the full motion with its derivatives.

pub mod effects;
mod law;
mod motion;

pub use law::{Law, TwoLines};
pub use motion::{Now, Torque, follow, follow_each};
