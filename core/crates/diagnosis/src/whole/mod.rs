//! Criticism of sessions whose whole body is simulated, by one selection among all sets of causes.
//!
//! Every set of up to three causes competes ([`selection`](super::selection)), with and without
//! something that has no name: a force over a coordinate, a knock, a line that slips, another thing
//! that moves inside. What begins at a number that no linear look finds (a frequency, a moment, an
//! exponent) is looked at from several values of it, and fitted from those that promise most.
//!
//! A wind's gusts are fitted once a wind is in the set; no linear look sees them before. A session that
//! a wind alone explains may therefore be taken for something that moves inside, and this search is
//! not yet the one that [`criticise`](super::criticise) uses.

mod competing;
mod found;
mod kind;
mod linearised;
mod quadratic;

pub use found::criticise;
