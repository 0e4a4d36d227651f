//! Phone exports into a session folder.

use std::path::PathBuf;

use gyradius_core::import::{self, Growth, Hanging, ImportRequest, import_session};
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
    radius: Stated,
    top_radius: Stated,
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
        let hung = plan.hung()?.alone()?;
        import_session(&files, &folder, &plan.request(hung)?, overwrite)
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
        // How new swings hung is in the growth: a kind that is not stated is that of `like`.
        let unused = Hanging::default().alone()?;
        import::import_into(&files, &folder, &plan.request(unused)?, &growth)
    })
}

/// What phone exports hold, line by line; nothing is written.
#[pyfunction]
pub fn describe_exports(py: Python<'_>, files: Vec<PathBuf>, plan: Plan) -> PyResult<Vec<String>> {
    detached(py, || {
        let hung = plan.hung()?.alone()?;
        import::describe_exports(&files, &plan.request(hung)?)
    })
}

impl Plan {
    fn request(self, suspension: Suspension) -> Result<ImportRequest> {
        Ok(ImportRequest {
            suspension,
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
            hung: self.hung()?,
        })
    }

    /// What is stated of the hanging.
    fn hung(&self) -> Result<Hanging> {
        let figures = [
            ("line_length", self.line_length),
            ("spacing", self.spacing),
            ("top_spacing", self.top_spacing),
            ("radius", self.radius),
            ("top_radius", self.top_radius),
            ("hull_pitch_deg", self.hull_pitch),
            ("points_moved", self.points_moved),
            ("axis_height", self.axis_height),
        ];
        let stated = |(key, figure): (&str, Stated)| Some((key.to_owned(), quantity(figure)?));
        Ok(Hanging {
            kind: self.suspension.as_deref().map(kind).transpose()?,
            orientation: self.orientation.as_deref().map(orientation).transpose()?,
            figures: figures.into_iter().filter_map(stated).collect(),
        })
    }
}

fn kind(name: &str) -> Result<SuspensionKind> {
    let unknown = || Error::argument("suspension", SuspensionKind::names(), name);
    SuspensionKind::named(name).ok_or_else(unknown)
}

fn orientation(name: &str) -> Result<Orientation> {
    let unknown = || Error::argument("orientation", Orientation::names(), name);
    Orientation::named(name).ok_or_else(unknown)
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
