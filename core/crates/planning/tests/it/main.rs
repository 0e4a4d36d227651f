//! Integration tests of `gyradius-planning`, in one program.

#![allow(missing_docs)]

mod plan;
