//! Phone exports and recorder's files into a session folder, and the units of platforms.

use std::path::{Path, PathBuf};

use gyradius_core::import::{ImportRequest, import_session};
use gyradius_core::recording::import::{Platform, from_core_motion, stamp_from_core_motion};
use gyradius_core::recording::{Overwrite, Quantity, Suspension};

use crate::block;
use crate::error::Result;
use crate::work::aside;

/// The system of the phone, where a file's signs depend on it and the file does not say.
pub type PhonePlatform = Platform;

/// The system of the phone, where a file's signs depend on it and the file does not say.
#[uniffi::remote(Enum)]
pub enum PhonePlatform {
    /// At rest, screen up, z = +g.
    Android,
    /// At rest, screen up, z = −g.
    Ios,
}

/// What the caller knows of the session beside its recordings.
#[uniffi::remote(Record)]
pub struct ImportRequest {
    /// Columns of a CSV that is not recognised, and their units: `gx=xGyro:deg/s`.
    pub mapping: Vec<String>,
    /// Which of several trials in one file is meant, as the file numbers or names them.
    pub trial: Option<String>,
    /// The phone's system.
    pub platform: Option<PhonePlatform>,
    /// Width of the flag in a light gate's beam, m.
    pub flag_width_m: Option<f64>,
    /// Title of the session, and name of the body.
    pub title: String,
    /// Everything that swings, kg.
    pub mass_kg: Option<Quantity>,
    /// Free-fall acceleration, m/s².
    pub gravity_m_s2: Option<Quantity>,
    /// How every swing hung.
    pub suspension: Suspension,
}

/// Writes a session folder from phone exports and recorder's files, one swing for each recording;
/// returns what a reader must know.
#[uniffi::export]
pub fn import_recordings(
    files: Vec<String>,
    folder: &str,
    request: &ImportRequest,
    overwrite: Overwrite,
) -> Result<Vec<String>> {
    let files: Vec<PathBuf> = files.into_iter().map(PathBuf::from).collect();
    aside(|| import_session(&files, Path::new(folder), request, overwrite))
}

/// Accelerations of Core Motion (in g, at rest, screen up: z = −1) as specific force, m/s² (z =
/// +9.80665): a block of x, y, z each way.
#[uniffi::export]
pub fn forces_from_core_motion(accelerations_g: &[u8]) -> Result<Vec<u8>> {
    let forces: Vec<[f64; 3]> = block::triples("accelerations_g", accelerations_g)?
        .into_iter()
        .map(from_core_motion)
        .collect();
    Ok(block::of_floats(forces.as_flattened()))
}

/// Time stamps of Core Motion, a block of floats, s since the phone was switched on, as a block of
/// stamps, ns.
#[uniffi::export]
pub fn stamps_from_core_motion(timestamps_s: &[u8]) -> Result<Vec<u8>> {
    let stamps = block::floats("timestamps_s", timestamps_s)?
        .into_iter()
        .map(stamp_from_core_motion);
    Ok(block::of_stamps(
        &stamps.collect::<gyradius_core::Result<Vec<_>>>()?,
    ))
}
