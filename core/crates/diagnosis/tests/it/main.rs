//! Integration tests of `gyradius-diagnosis`, in one program.

#![allow(missing_docs)]

mod critique_periods;
mod one_motion;
mod told;
