//! A rigid body on its lines.

use super::real::{M3, Real, V3};

/// Most lines: two inverted Vs have four.
pub(crate) const MOST_LINES: usize = 4;

/// A line without mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cord<S> {
    /// Upper end, world axes, m.
    pub top_m: V3<S>,
    /// Lower end, hull axes, from the mid-point of the suspension points, m.
    pub point_m: V3<S>,
    /// Length (unstretched, where it is elastic), m.
    pub length_m: S,
}

/// Springs in place of lines of fixed length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Spring<S> {
    /// Tension per stretch of each line, N/m.
    pub stiffness_n_m: S,
    /// Tension per rate of stretch, N s/m.
    pub damping_n_s_m: S,
}

/// The body and what it hangs on.
#[derive(Debug)]
pub(crate) struct Suspended<S: Real> {
    /// Mass, kg.
    pub mass_kg: S,
    /// Inertia about the centre of mass, hull axes, kg m².
    pub inertia_kg_m2: M3<S>,
    /// Centre of mass, hull axes, from the mid-point of the suspension points, m.
    pub cm_m: V3<S>,
    /// The lines.
    pub cords: Vec<Cord<S>>,
    /// Acceleration of free fall, m/s².
    pub gravity_m_s2: S,
    /// Elastic lines.
    pub spring: Option<Spring<S>>,
}

impl<S: Real> Cord<S> {
    /// −1 or 1: on which side along `axis` the line takes hold of the body.
    pub fn side(&self, axis: &V3<S>) -> f64 {
        axis.dot(&self.point_m).value().signum()
    }
}

impl<S: Real> Suspended<S> {
    /// The direction that joins the suspension points, from the first lines to the last.
    pub fn axis(&self) -> V3<S> {
        let half = self.cords.len() / 2;
        let sum = |cords: &[Cord<S>]| {
            cords
                .iter()
                .fold(V3::zeros(), |sum, cord| sum + cord.point_m)
        };
        let along: V3<S> = sum(&self.cords[half..]) - sum(&self.cords[..half]);
        along / along.dot(&along).sqrt()
    }

    /// Mean length of the lines, m.
    pub fn mean_length_m(&self) -> S {
        let sum = self
            .cords
            .iter()
            .fold(S::zero(), |sum, cord| sum + cord.length_m);
        sum.scale(1.0 / self.cords.len() as f64)
    }
}
