//! What a phone fixed to the hull feels.

use super::numbers::numbers;
use super::path::Moment;
use super::real::{M3, Real, V3, times};
use super::state::matrix;
use gyradius_base::frames::Rotation;

numbers! {
    /// Where the phone sits and what its sensors add to everything.
    ///
    /// # Conventions
    /// The position is in hull axes from the mid-point of the suspension points. The turn is a
    /// rotation vector that comes on top of a nominal `hull_from_phone`, phone axes:
    /// `hull_from_phone = nominal · exp(turn)`.
    pub struct Phone {
        /// Forward.
        position_x_m: "m",
        /// To port.
        position_y_m: "m",
        /// Up.
        position_z_m: "m",
        /// Turn.
        turn_x_rad: "rad",
        /// Turn.
        turn_y_rad: "rad",
        /// Turn.
        turn_z_rad: "rad",
        /// Bias of the gyroscope, phone axes.
        gyro_bias_x_rad_s: "rad/s",
        /// Bias of the gyroscope, phone axes.
        gyro_bias_y_rad_s: "rad/s",
        /// Bias of the gyroscope, phone axes.
        gyro_bias_z_rad_s: "rad/s",
        /// Bias of the accelerometer, phone axes.
        acc_bias_x_m_s2: "m/s^2",
        /// Bias of the accelerometer, phone axes.
        acc_bias_y_m_s2: "m/s^2",
        /// Bias of the accelerometer, phone axes.
        acc_bias_z_m_s2: "m/s^2",
    }
}

/// Readings at one instant, phone axes.
#[derive(Debug, Clone, Copy)]
pub struct Reading<S: Real> {
    /// Angular rate, rad/s.
    pub gyro: V3<S>,
    /// Specific force (acceleration less gravity: +g upwards at rest), m/s².
    pub force: V3<S>,
}

impl<S: Real> Reading<S> {
    /// Angular rate x, y, z, then specific force x, y, z.
    pub fn six(&self) -> [S; 6] {
        let (w, f) = (&self.gyro, &self.force);
        [w.x, w.y, w.z, f.x, f.y, f.z]
    }
}

/// Where the phone is against its place on the hull.
///
/// # Conventions
/// The shift is in hull axes. The turn is a rotation vector in phone axes, about an axis that
/// stays, or small.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Offset<S: Real> {
    /// m.
    pub shift: V3<S>,
    /// m/s.
    pub shift_rate: V3<S>,
    /// m/s².
    pub shift_acceleration: V3<S>,
    /// rad.
    pub turn: V3<S>,
    /// rad/s.
    pub turn_rate: V3<S>,
}

impl<S: Real> Default for Offset<S> {
    fn default() -> Self {
        let none = V3::zeros();
        Self {
            shift: none,
            shift_rate: none,
            shift_acceleration: none,
            turn: none,
            turn_rate: none,
        }
    }
}

/// A phone ready to be read.
pub struct Mounted<S: Real> {
    arm: V3<S>,
    phone_from_hull: M3<S>,
    gyro_bias: V3<S>,
    acc_bias: V3<S>,
    gravity: S,
}

impl<S: Real> Phone<S> {
    /// The phone on a body whose centre of mass is at `cm_m`, both from the mid-point of the
    /// suspension points.
    pub fn mounted(&self, nominal: &Rotation, cm_m: &V3<S>, gravity_m_s2: S) -> Mounted<S> {
        let turn = rotation(&V3::new(self.turn_x_rad, self.turn_y_rad, self.turn_z_rad));
        let nominal: M3<S> = nominal.to_rotation_matrix().matrix().map(S::constant);
        Mounted {
            arm: V3::new(self.position_x_m, self.position_y_m, self.position_z_m) - cm_m,
            phone_from_hull: (nominal * turn).transpose(),
            gyro_bias: V3::new(
                self.gyro_bias_x_rad_s,
                self.gyro_bias_y_rad_s,
                self.gyro_bias_z_rad_s,
            ),
            acc_bias: V3::new(
                self.acc_bias_x_m_s2,
                self.acc_bias_y_m_s2,
                self.acc_bias_z_m_s2,
            ),
            gravity: gravity_m_s2,
        }
    }
}

impl<S: Real> Mounted<S> {
    /// Readings while the body moves so.
    pub fn read(&self, moment: &Moment<S>) -> Reading<S> {
        Reading {
            gyro: times(&self.phone_from_hull, &moment.rate) + self.gyro_bias,
            force: times(&self.phone_from_hull, &self.force_at_place(moment)) + self.acc_bias,
        }
    }

    /// Readings while the phone moves against the hull as well, by several motions one upon the
    /// other.
    pub(crate) fn read_moving(&self, moment: &Moment<S>, offsets: &[Offset<S>]) -> Reading<S> {
        let mut arm = self.arm;
        let mut own = V3::zeros();
        for offset in offsets {
            arm += offset.shift;
            own += moment.rate.cross(&offset.shift_rate).map(|x| x.scale(2.0))
                + offset.shift_acceleration;
        }
        let mut gyro = self.phone_from_hull * moment.rate;
        let mut force = self.phone_from_hull * (force_at(moment, &arm, self.gravity) + own);
        for offset in offsets {
            let turn = rotation(&offset.turn);
            gyro = turn.tr_mul(&gyro) + offset.turn_rate;
            force = turn.tr_mul(&force);
        }
        Reading {
            gyro: gyro + self.gyro_bias,
            force: force + self.acc_bias,
        }
    }

    /// Specific force where the phone sits, hull axes, m/s².
    pub(super) fn force_at_place(&self, moment: &Moment<S>) -> V3<S> {
        force_at(moment, &self.arm, self.gravity)
    }

    /// Acceleration of free fall, m/s².
    pub(super) fn gravity(&self) -> S {
        self.gravity
    }

    pub(super) fn phone_from_hull(&self) -> &M3<S> {
        &self.phone_from_hull
    }
}

/// Specific force at a place so far from the centre of mass, both in hull axes.
fn force_at<S: Real>(moment: &Moment<S>, arm: &V3<S>, gravity: S) -> V3<S> {
    let (rate, angular) = (&moment.rate, &moment.angular_acceleration);
    let up = V3::new(S::zero(), S::zero(), gravity);
    let centre = moment.turn().tr_mul(&(moment.acceleration + up));
    centre + angular.cross(arm) + rate.cross(&rate.cross(arm))
}

/// Rotation matrix of a rotation vector.
pub(crate) fn rotation<S: Real>(vector: &V3<S>) -> M3<S> {
    let square = vector.dot(vector);
    // Below, cos(θ/2) and sin(θ/2)/θ by their series in θ²: the next terms are under 1e-16.
    let (cos, sinc) = if square.value() < 1e-4 {
        let series = |c: [f64; 4]| {
            c.iter()
                .rev()
                .fold(S::zero(), |sum, c| sum * square + S::constant(*c))
        };
        let cos = series([1.0, -1.0 / 8.0, 1.0 / 384.0, -1.0 / 46080.0]);
        (
            cos,
            series([0.5, -1.0 / 48.0, 1.0 / 3840.0, -1.0 / 645_120.0]),
        )
    } else {
        let angle = square.sqrt();
        let half = angle.scale(0.5);
        (half.cos(), half.sin() / angle)
    };
    let v = vector * sinc;
    matrix(&[cos, v.x, v.y, v.z])
}
