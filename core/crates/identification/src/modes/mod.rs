//! Where the phone sits, and what each oscillation is.
//!
//! May know `signal`, `recording` and what they may know. Knows nothing of inertia.
//!
//! Nothing is asked that the data can answer: gravity gives the vertical in phone axes, the
//! rotation and the acceleration of each mode give its axis and its kind. A gyroscope does not see
//! a sway, an accelerometer sees everything; what turns about the vertical is a yaw, what turns
//! about a level axis is a pitch (or roll) mode, what is accelerated without turning is a sway.

mod motion;
mod naming;
mod pose;

pub use motion::{CVec3, ChannelMap, PhoneMotion, in_phase};
pub use naming::{Hanging, NamedMode, name_modes};
pub use pose::{line_direction, tilt_between_rad, up_direction};
