//! The Python face of `gyradius-core`: conversions only, no science.
//!
//! Every function reads its arguments, calls the core without the interpreter lock, and turns the
//! result or the error into Python's. Results that Python reads as a tree cross as the JSON text
//! that the core writes; samples cross as numpy arrays.

use pyo3::prelude::*;

mod arrays;
mod critique;
mod errors;
mod import;
mod live;
mod measurement;
mod plan;
mod practice;
mod recorder;
mod routes;
mod session;
mod simulation;

/// The native module; `gyradius` wraps it in views.
#[pymodule]
mod _core {
    use pyo3::prelude::*;

    #[pymodule_export]
    use super::arrays::{Decomposition, decompose};
    #[pymodule_export]
    use super::critique::Criticism;
    #[pymodule_export]
    use super::errors::{CancelledError, GyradiusError, InputError, NoResultError, silence_panics};
    #[pymodule_export]
    use super::import::{describe_exports, import_files, import_into};
    #[pymodule_export]
    use super::live::Live;
    #[pymodule_export]
    use super::measurement::Measurement;
    #[pymodule_export]
    use super::plan::{Plan, plan_swings};
    #[pymodule_export]
    use super::practice::Practice;
    #[pymodule_export]
    use super::recorder::{RecorderFile, read_recorder};
    #[pymodule_export]
    use super::routes::{evaluate_route, routes};
    #[pymodule_export]
    use super::session::{Session, load, load_tables};
    #[pymodule_export]
    use super::simulation::{Rig, Simulation, read_rig};

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        super::errors::declare_places(module.py())
    }
}
