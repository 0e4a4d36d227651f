//! Integration tests of `gyradius-mechanics`, in one program.

#![allow(missing_docs)]

mod dynamics;
mod one_angle;
mod sensors;
mod simulation;
