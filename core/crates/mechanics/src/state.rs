//! The state of the motion: where its parts begin, and the body as they say it is.
//!
//! # Conventions
//! Time, centre of mass (world), attitude quaternion w, x, y, z (`world_from_hull`), velocity
//! (world), angular rate (hull axes), then the effects' memories in their order. World: z up,
//! origin mid-way between the upper ends.

use super::real::{M3, Real, V3};

/// Where the parts of the state begin.
pub(crate) const TIME: usize = 0;
pub(crate) const PLACE: usize = 1;
pub(crate) const ATTITUDE: usize = 4;
pub(crate) const VELOCITY: usize = 8;
pub(crate) const RATE: usize = 11;
pub(crate) const MEMORY: usize = 14;

/// The body at one instant.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Now<S: Real> {
    /// Time, s.
    pub t_s: S,
    /// Centre of mass, world axes, m.
    pub position: V3<S>,
    /// `world_from_hull`.
    pub turn: M3<S>,
    /// Velocity of the centre of mass, world axes, m/s.
    pub velocity: V3<S>,
    /// Angular rate, hull axes, rad/s.
    pub rate: V3<S>,
}

impl<S: Real> Now<S> {
    pub(crate) fn at(y: &[S]) -> Self {
        let part = |i: usize| V3::new(y[i], y[i + 1], y[i + 2]);
        Self {
            t_s: y[TIME],
            position: part(PLACE),
            turn: matrix(&y[ATTITUDE..VELOCITY]),
            velocity: part(VELOCITY),
            rate: part(RATE),
        }
    }

    /// Velocity of the centre of mass, hull axes, m/s.
    pub fn velocity_hull(&self) -> V3<S> {
        self.turn.tr_mul(&self.velocity)
    }

    /// Downwards, hull axes.
    pub fn down(&self) -> V3<S> {
        -self.turn.row(2).transpose()
    }

    /// Horizontal part of the position, world axes, m.
    pub fn level_position(&self) -> V3<S> {
        V3::new(self.position.x, self.position.y, S::zero())
    }

    /// The turn about the vertical, rad, and its change by a turn about each hull axis: what is
    /// left of the attitude when the least tilt that explains the hull's z axis is taken away
    /// (swing and twist). A tilted hull's axes do not bias it, and a torque along its change
    /// conserves energy.
    pub fn twist(&self) -> (S, V3<S>) {
        let r = &self.turn;
        let angle = (r[(1, 0)] - r[(0, 1)]).atan2(r[(0, 0)] + r[(1, 1)]);
        let upright = S::one() / (S::one() + r[(2, 2)]);
        (
            angle,
            V3::new(r[(2, 0)] * upright, r[(2, 1)] * upright, S::one()),
        )
    }
}

/// Rotation matrix of a quaternion w, x, y, z; its size is divided out.
pub(crate) fn matrix<S: Real>(q: &[S]) -> M3<S> {
    let [w, x, y, z] = [q[0], q[1], q[2], q[3]];
    let two = S::constant(2.0) / (w * w + x * x + y * y + z * z);
    let (xs, ys, zs) = (x * two, y * two, z * two);
    let (wx, wy, wz) = (w * xs, w * ys, w * zs);
    let (xx, xy, xz) = (x * xs, x * ys, x * zs);
    let (yy, yz, zz) = (y * ys, y * zs, z * zs);
    let one = S::one();
    M3::new(
        one - (yy + zz),
        xy - wz,
        xz + wy,
        xy + wz,
        one - (xx + zz),
        yz - wx,
        xz - wy,
        yz + wx,
        one - (xx + yy),
    )
}
