//! Phone exports into a session folder.

use std::path::PathBuf;

use gyradius_core::import::{self, Growth, ImportRequest, import_session};
use gyradius_core::recording::import::Platform;
use gyradius_core::recording::{Orientation, Overwrite, Quantity, Suspension, SuspensionKind};
use gyradius_core::{Error, Result};
use pyo3::prelude::*;

use crate::errors::detached;

/// What the caller knows of the session beside its recordings (`gyradius.imports.ImportPlan`).
#[derive(FromPyObject)]
pub struct Plan {
    mapping: Vec<String>,
    trial: Option<String>,
    platform: Option<String>,
    flag_width: Option<f64>,
    replace: bool,
    title: String,
    suspension: Option<String>,
    orientation: Option<String>,
    swing: Option<String>,
    like: Option<String>,
    mass: Stated,
    gravity: Stated,
    line_length: Stated,
    spacing: Stated,
    top_spacing: Stated,
    hull_pitch: Stated,
    points_moved: Stated,
    axis_height: Stated,
}

/// A value and its standard uncertainty, where stated.
type Stated = Option<(f64, f64)>;

/// Write a session folder from phone exports; returns what a reader must know.
#[pyfunction]
pub fn import_files(
    py: Python<'_>,
    files: Vec<PathBuf>,
    folder: PathBuf,
    plan: Plan,
) -> PyResult<Vec<String>> {
    let overwrite = if plan.replace {
        Overwrite::Replace
    } else {
        Overwrite::Refuse
    };
    detached(py, || {
        import_session(&files, &folder, &plan.request()?, overwrite)
    })
}

/// Add swings to a session folder from phone exports; returns what a reader must know.
#[pyfunction]
pub fn import_into(
    py: Python<'_>,
    files: Vec<PathBuf>,
    folder: PathBuf,
    plan: Plan,
) -> PyResult<Vec<String>> {
    detached(py, || {
        let growth = plan.growth()?;
        import::import_into(&files, &folder, &plan.request()?, &growth)
    })
}

/// What phone exports hold, line by line; nothing is written.
#[pyfunction]
pub fn describe_exports(py: Python<'_>, files: Vec<PathBuf>, plan: Plan) -> PyResult<Vec<String>> {
    detached(py, || import::describe_exports(&files, &plan.request()?))
}

impl Plan {
    fn request(self) -> Result<ImportRequest> {
        Ok(ImportRequest {
            suspension: self.hanging()?,
            platform: self.platform.as_deref().map(platform).transpose()?,
            mapping: self.mapping,
            trial: self.trial,
            flag_width_m: self.flag_width,
            title: self.title,
            mass_kg: quantity(self.mass),
            gravity_m_s2: quantity(self.gravity),
        })
    }

    /// Which swings of a session the recordings are, and how new ones hung.
    fn growth(&self) -> Result<Growth> {
        Ok(Growth {
            swing: self.swing.clone(),
            like: self.like.clone(),
            kind: self.suspension.as_deref().map(kind).transpose()?,
            orientation: self.orientation.as_deref().map(orientation).transpose()?,
        })
    }

    fn hanging(&self) -> Result<Suspension> {
        let Growth {
            kind, orientation, ..
        } = self.growth()?;
        Ok(Suspension {
            kind: kind.unwrap_or(SuspensionKind::Bifilar),
            orientation: orientation.unwrap_or(Orientation::Athwartships),
            line_length_m: quantity(self.line_length),
            spacing_m: quantity(self.spacing),
            top_spacing_m: quantity(self.top_spacing),
            hull_pitch_deg: quantity(self.hull_pitch),
            hull_roll_deg: None,
            points_m: None,
            points_moved_m: quantity(self.points_moved),
            axis_height_m: quantity(self.axis_height),
        })
    }
}

fn kind(name: &str) -> Result<SuspensionKind> {
    match name {
        "bifilar" => Ok(SuspensionKind::Bifilar),
        "compound" => Ok(SuspensionKind::Compound),
        "free" => Ok(SuspensionKind::Free),
        other => Err(Error::argument(
            "suspension",
            "bifilar, compound or free",
            other,
        )),
    }
}

fn orientation(name: &str) -> Result<Orientation> {
    match name {
        "athwartships" => Ok(Orientation::Athwartships),
        "fore_and_aft" => Ok(Orientation::ForeAndAft),
        other => Err(Error::argument(
            "orientation",
            "athwartships or fore_and_aft",
            other,
        )),
    }
}

fn platform(name: &str) -> Result<Platform> {
    match name {
        "android" => Ok(Platform::Android),
        "ios" => Ok(Platform::Ios),
        other => Err(Error::argument("platform", "android or ios", other)),
    }
}

fn quantity(stated: Stated) -> Option<Quantity> {
    stated.map(|(value, u)| Quantity::new(value, u))
}
