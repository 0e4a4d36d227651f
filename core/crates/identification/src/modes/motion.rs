//! One oscillation of the phone as a rigid motion: rotation and displacement amplitudes in phone
//! axes.
//!
//! # Conventions
//! Complex amplitudes multiply exp((−α + iω)(t − t_ref)); the record holds the real part. All
//! vectors are in phone axes. `up` is the unit vector of the specific force at rest: it points up.

use nalgebra::Vector3;
use num_complex::Complex64;

use gyradius_base::frames::Vec3;
use gyradius_signal::FittedMode;

/// A complex 3-vector.
pub type CVec3 = Vector3<Complex64>;

/// Which channels of a decomposition are the gyroscope's and the accelerometer's.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct ChannelMap {
    /// Index of the gyroscope's x channel; y and z follow.
    pub gyroscope: Option<usize>,
    /// Index of the accelerometer's x channel; y and z follow.
    pub accelerometer: Option<usize>,
    /// True where the accelerometer channels are free of gravity (the phone took it out).
    pub gravity_free: bool,
}

/// The motion of the phone in one mode.
#[derive(Debug, Clone, PartialEq)]
pub struct PhoneMotion {
    /// Angular frequency, rad/s.
    pub omega_rad_s: f64,
    /// Rotation-vector amplitude, rad; absent without a gyroscope.
    pub rotation_rad: Option<CVec3>,
    /// Its standard error per component, rad.
    pub rotation_se_rad: f64,
    /// Acceleration amplitude of the phone's place with the tilt of gravity taken out, m/s².
    pub acceleration_m_s2: Option<CVec3>,
    /// Its standard error per component, m/s².
    pub acceleration_se_m_s2: f64,
}

impl PhoneMotion {
    /// Rotation and acceleration of the phone in one fitted mode.
    ///
    /// The rate is the rotation times iω. In phone axes the specific force swings by δf = a − g Θ ×
    /// û (first order), so a = δf + g Θ × û; for a gravity-free accelerometer a = δf.
    pub fn of(mode: &FittedMode, map: ChannelMap, gravity_m_s2: f64, up: Option<Vec3>) -> Self {
        let omega = mode.omega_rad_s;
        let pole = Complex64::new(-mode.alpha_per_s, omega);
        let rotation = map
            .gyroscope
            .map(|first| vector(mode, first).map(|rate| rate / pole));
        let force = map.accelerometer.map(|first| vector(mode, first));
        let acceleration = match (force, rotation, up, map.gravity_free) {
            (Some(f), Some(theta), Some(up), false) => {
                Some(f + theta.cross(&up.map(Complex64::from)) * Complex64::from(gravity_m_s2))
            }
            (force, ..) => force,
        };
        PhoneMotion {
            omega_rad_s: omega,
            rotation_rad: rotation,
            rotation_se_rad: map.gyroscope.map_or(0.0, |i| largest(&mode.shape_se, i)) / omega,
            acceleration_m_s2: acceleration,
            acceleration_se_m_s2: map
                .accelerometer
                .map_or(0.0, |i| largest(&mode.shape_se, i)),
        }
    }

    /// Size of the rotation about `axis` and across it, rad.
    pub fn rotation_split(&self, axis: &Vec3) -> Option<(f64, f64)> {
        self.rotation_rad.map(|theta| split(&theta, axis))
    }

    /// Size of the acceleration along `axis` and across it, m/s².
    pub fn acceleration_split(&self, axis: &Vec3) -> Option<(f64, f64)> {
        self.acceleration_m_s2.map(|a| split(&a, axis))
    }

    /// The horizontal line along which the phone rotates or is accelerated most, whichever is
    /// given.
    pub fn principal_direction(vector: &CVec3, up: &Vec3) -> Option<Vec3> {
        let across = vector - up.map(Complex64::from) * along(vector, up);
        in_phase(&across).try_normalize(1e-300)
    }
}

/// The line along which a complex vector swings: its real part at the phase at which that is longest.
pub fn in_phase(vector: &CVec3) -> Vec3 {
    let phase = vector.iter().map(|c| c * c).sum::<Complex64>().sqrt();
    vector.map(|c| (c * phase.conj()).re)
}

fn vector(mode: &FittedMode, first: usize) -> CVec3 {
    CVec3::from_fn(|i, _| mode.shape.get(first + i).copied().unwrap_or_default())
}

fn largest(values: &[f64], first: usize) -> f64 {
    values
        .iter()
        .skip(first)
        .take(3)
        .fold(0.0, |a: f64, b| a.max(*b))
}

fn along(vector: &CVec3, axis: &Vec3) -> Complex64 {
    vector.iter().zip(axis.iter()).map(|(c, x)| c * x).sum()
}

fn split(vector: &CVec3, axis: &Vec3) -> (f64, f64) {
    let on_axis = along(vector, axis).norm();
    let total = vector.iter().map(|c| c.norm_sqr()).sum::<f64>();
    (on_axis, (total - on_axis * on_axis).max(0.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    fn mode(shape: Vec<Complex64>) -> FittedMode {
        FittedMode {
            omega_rad_s: 2.0,
            omega_se_rad_s: 0.0,
            alpha_per_s: 0.0,
            alpha_se_per_s: 0.0,
            shape_se: vec![1e-6; shape.len()],
            shape,
            snr_db: 60.0,
            law: Default::default(),
        }
    }

    /// A phone tilting about y through its own place: the accelerometer sees gravity's tilt only,
    /// the place rests. Closed form: Θ = θ ŷ, δf = −g θ ŷ × ẑ = −g θ x̂.
    #[test]
    fn pure_tilt_leaves_no_acceleration() {
        let theta = Complex64::new(0.1, 0.0);
        let rate = theta * Complex64::new(0.0, 2.0);
        let zero = Complex64::default();
        let shape = vec![zero, rate, zero, -9.81 * theta, zero, zero];
        let map = ChannelMap {
            gyroscope: Some(0),
            accelerometer: Some(3),
            gravity_free: false,
        };
        let motion = PhoneMotion::of(&mode(shape), map, 9.81, Some(Vec3::z()));
        let (_, across) = motion.acceleration_split(&Vec3::z()).unwrap();
        assert!(across < 1e-12);
        let (on, across) = motion.rotation_split(&Vec3::z()).unwrap();
        assert!(on < 1e-12);
        assert_relative_eq!(across, 0.1, epsilon = 1e-12);
    }
}
