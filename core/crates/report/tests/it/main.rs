//! Integration tests of `gyradius-report`, in one program.

#![allow(missing_docs)]

mod report;
