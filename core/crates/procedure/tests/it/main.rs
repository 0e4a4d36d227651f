//! Integration tests of `gyradius-procedure`, in one program.

#![allow(missing_docs)]

mod live;
mod procedure;
mod suggested_swing;
mod swings;
