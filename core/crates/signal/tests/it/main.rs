//! Integration tests of `gyradius-signal`, in one program.

#![allow(missing_docs)]

mod mode_count;
mod periods;
