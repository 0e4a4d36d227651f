//! Every route of the paper to a quantity, each a pure function that names its equation.
//!
//! Source: P. F. Hinrichsen, *Bifilar suspension measurement of boat inertia parameters*, Journal
//! of Sailboat Technology 2014-01. Numbers in brackets are its equations; where the print is wrong
//! the code holds the corrected form and says so. Functions take SI units, refuse arguments outside
//! their domain with [`gyradius_base::Error::Argument`], and answer [`gyradius_base::Error::NoResult`] where the
//! arguments contradict each other; none returns NaN or panics.

pub mod attachments;
pub mod beat;
pub mod catalogue;
pub mod compound;
pub mod corrections;
mod domain;
pub mod double_pendulum;
pub mod ellipsoid;
mod entry;
pub mod finite_amplitude;
pub mod guard;
pub mod incline;
pub mod principal;
pub mod propagate;
pub mod ratio;
mod table;
pub mod yaw;

pub use catalogue::{CatalogueEntry, catalogue, evaluate, evaluate_with_u};
