//! Integration tests of `gyradius-estimation`, in one program.

#![allow(missing_docs)]
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "helpers of tests fail as tests do"
)]

mod blocks;
mod bounds;
mod dual;
mod endings;
mod strd;
mod strd_files;
mod strd_models;
