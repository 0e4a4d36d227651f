//! Integration tests of `gyradius-import`, in one program.

#![allow(missing_docs)]

mod alike;
mod described;
mod grow;
mod kept;
mod kinds;
mod told;
