//! Integration tests of `gyradius-core`, in one program.

#![allow(missing_docs)]

mod languages;
mod schemas;
