//! The lines and the body that hangs on them.

use super::real::{M3, Real, V3};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::{Mat3, Rotation, Vec3};

/// The direction that joins the two suspension points.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SuspensionAxis {
    /// To port: the hull can pitch and surge freely.
    Athwartships,
    /// Forward: the hull can roll and sway freely.
    ForeAndAft,
}

impl SuspensionAxis {
    /// Unit vector along the suspension, hanging axes.
    pub fn unit(self) -> Vec3 {
        match self {
            SuspensionAxis::Athwartships => Vec3::y(),
            SuspensionAxis::ForeAndAft => Vec3::x(),
        }
    }
}

/// How the body hangs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hanging {
    /// On two lines.
    Bifilar(SuspensionAxis),
    /// On two inverted Vs, whose apexes lie on the axis of the swing.
    Compound(SuspensionAxis),
}

impl Hanging {
    /// The direction that joins the suspension points.
    pub fn axis(self) -> SuspensionAxis {
        match self {
            Hanging::Bifilar(axis) | Hanging::Compound(axis) => axis,
        }
    }
}

/// One inextensible line without mass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Upper end, world axes, m.
    pub top_m: Vec3,
    /// Lower end, hanging axes, from the mid-point of the suspension points, m.
    pub hull_point_m: Vec3,
    /// Length, m.
    pub length_m: f64,
}

/// Two lines and the gravity they hang in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rig {
    /// The lines.
    pub lines: [Line; 2],
    /// Acceleration of free fall, m/s².
    pub gravity_m_s2: f64,
}

impl Rig {
    /// Two equal lines; the world's origin is mid-way between the upper ends.
    ///
    /// # Conventions
    /// `spacing_m` and `top_spacing_m` are the whole distances between the lines (the paper's 2d)
    /// at the hull and at the top. Line 0 is on the negative side of the axis, line 1 on the
    /// positive.
    pub fn bifilar(
        axis: SuspensionAxis,
        line_length_m: f64,
        spacing_m: f64,
        top_spacing_m: f64,
        gravity_m_s2: f64,
    ) -> Result<Self> {
        positive("line_length_m", line_length_m)?;
        positive("spacing_m", spacing_m)?;
        positive("top_spacing_m", top_spacing_m)?;
        positive("gravity_m_s2", gravity_m_s2)?;
        if (spacing_m - top_spacing_m).abs() >= 2.0 * line_length_m {
            return Err(Error::argument(
                "line_length_m",
                "lines that reach the hull",
                line_length_m,
            ));
        }
        let line = |side: f64| Line {
            top_m: axis.unit() * (0.5 * side * top_spacing_m),
            hull_point_m: axis.unit() * (0.5 * side * spacing_m),
            length_m: line_length_m,
        };
        Ok(Self {
            lines: [line(-1.0), line(1.0)],
            gravity_m_s2,
        })
    }

    /// Horizontal unit vector from the first line's upper end to the second's, world axes.
    pub fn axis(&self) -> Vec3 {
        let mut along = self.lines[1].top_m - self.lines[0].top_m;
        along.z = 0.0;
        along.try_normalize(0.0).unwrap_or_else(Vec3::y)
    }
}

/// A rigid body: mass, centre of mass and inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidBody<S = f64> {
    /// Mass, kg.
    pub mass_kg: S,
    /// Inertia about the centre of mass, hanging axes, kg m².
    pub inertia_kg_m2: M3<S>,
    /// Centre of mass, hanging axes, from the mid-point of the suspension points, m.
    pub cm_m: V3<S>,
}

impl<S: Real> RigidBody<S> {
    /// The same body turned about the mid-point of the suspension points by a rotation matrix.
    pub fn turned(&self, hanging_from_hull: &M3<S>) -> Self {
        Self {
            mass_kg: self.mass_kg,
            inertia_kg_m2: hanging_from_hull * self.inertia_kg_m2 * hanging_from_hull.transpose(),
            cm_m: hanging_from_hull * self.cm_m,
        }
    }
}

impl RigidBody {
    /// A body whose principal axes are the hull's, by its gyradii about x, y, z.
    pub fn from_gyradii(mass_kg: f64, gyradii_m: [f64; 3], cm_m: Vec3) -> Self {
        let k = Vec3::from(gyradii_m);
        Self {
            mass_kg,
            inertia_kg_m2: Mat3::from_diagonal(&(k.component_mul(&k) * mass_kg)),
            cm_m,
        }
    }

    /// The same body turned about the mid-point of the suspension points, e.g. by
    /// [`gyradius_base::frames::world_from_hull_pitched`].
    pub fn rotated(&self, hanging_from_hull: Rotation) -> Self {
        self.turned(hanging_from_hull.to_rotation_matrix().matrix())
    }

    /// Checks that mass and inertia are those of a body.
    pub(super) fn check(&self) -> Result<()> {
        positive("mass_kg", self.mass_kg)?;
        if self.inertia_kg_m2.cholesky().is_none() || !self.cm_m.iter().all(|x| x.is_finite()) {
            return Err(Error::argument(
                "inertia_kg_m2",
                "a positive definite inertia and a finite centre of mass",
                format!("{}", self.inertia_kg_m2),
            ));
        }
        Ok(())
    }
}

fn positive(name: &str, value: f64) -> Result<()> {
    if value.is_finite() && value > 0.0 {
        Ok(())
    } else {
        Err(Error::argument(name, "a positive number", value))
    }
}
