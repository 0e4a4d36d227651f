//! Integration tests of `gyradius-simulator`, in one program.

#![allow(missing_docs)]

mod practice;
