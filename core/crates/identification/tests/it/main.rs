//! Integration tests of `gyradius-identification`, in one program.

#![allow(missing_docs)]

mod axes;
mod contradictions;
mod crossings;
mod findings;
mod inclines;
mod instruments;
mod motions;
mod one_motion;
mod single_routes;
mod uncertainty;
mod vectors;
mod without_result;
