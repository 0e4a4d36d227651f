//! The one place where an error of the core becomes an exception.

use gyradius_core::Error;
use gyradius_core::error::ErrorKind;
use pyo3::create_exception;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

create_exception!(
    gyradius,
    GyradiusError,
    PyValueError,
    "What went wrong, with its `file` and `line`."
);
create_exception!(
    gyradius,
    InputError,
    GyradiusError,
    "The input cannot be read or used."
);
create_exception!(
    gyradius,
    NoResultError,
    GyradiusError,
    "The data do not allow a result."
);
create_exception!(
    gyradius,
    CancelledError,
    GyradiusError,
    "The work was stopped by whoever watched it."
);

/// Every instance has `file` and `line`; a class attribute makes both readable before they are set.
pub fn declare_places(py: Python<'_>) -> PyResult<()> {
    let base = py.get_type::<GyradiusError>();
    base.setattr("file", py.None())?;
    base.setattr("line", py.None())
}

/// Let panics print nothing by themselves: the exception that they become holds their text.
#[pyfunction]
pub fn silence_panics() {
    std::panic::set_hook(Box::new(|_| {}));
}

/// The exception that an error of the core becomes.
pub fn raise(py: Python<'_>, error: &Error) -> PyErr {
    let message = error.to_string();
    let exception = match error.kind() {
        ErrorKind::Input => InputError::new_err(message),
        ErrorKind::NoResult => NoResultError::new_err(message),
    };
    match placed(py, &exception, error) {
        Ok(()) => exception,
        Err(failure) => failure,
    }
}

fn placed(py: Python<'_>, exception: &PyErr, error: &Error) -> PyResult<()> {
    let value = exception.value(py);
    value.setattr("file", error.file())?;
    value.setattr("line", error.line())
}

/// Runs work of the core without the interpreter lock and raises its error.
pub fn detached<T: Send>(
    py: Python<'_>,
    work: impl FnOnce() -> gyradius_core::Result<T> + Send,
) -> PyResult<T> {
    py.detach(work).map_err(|error| raise(py, &error))
}
