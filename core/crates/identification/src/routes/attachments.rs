//! Bodies joined and taken apart by the parallel-axis rule: frame (27), phone and other
//! attachments, added masses (Figs. 7, 18), hull and keel (second Table 4).
//!
//! # Conventions
//! Hull axes. An inertia tensor is about the body's own centre of mass, in kg m², with the products
//! as they stand in the tensor (I_xz = −Σ m x z).

use super::domain::{finite, not_negative, positive, result, root};
use gyradius_base::{Error, Result};
use gyradius_mechanics::{M3, Real, RigidBody, V3};

/// Two bodies as one, centres counted from one mark.
pub fn joined<S: Real>(one: &RigidBody<S>, other: &RigidBody<S>) -> Result<RigidBody<S>> {
    let (a, b) = (one.mass_kg, other.mass_kg);
    positive("mass_kg", a.value())?;
    not_negative("mass_kg", b.value())?;
    let mass_kg = a + b;
    let offset = other.cm_m - one.cm_m;
    Ok(RigidBody {
        mass_kg,
        cm_m: one.cm_m + offset * (b / mass_kg),
        inertia_kg_m2: one.inertia_kg_m2
            + other.inertia_kg_m2
            + of_point_mass(a * b / mass_kg, &offset),
    })
}

/// What is left of a body when a part of it is taken off; it must be the inertia of a body.
pub fn without(whole: &RigidBody, part: &RigidBody) -> Result<RigidBody> {
    let rest = remainder(whole, part)?;
    must_be_possible(&rest)?;
    Ok(rest)
}

/// [`without`] where the whole is an estimate, some of whose moments nobody measured: they may come
/// out impossible and are not judged.
pub fn remainder(whole: &RigidBody, part: &RigidBody) -> Result<RigidBody> {
    let (total, off) = (
        positive("mass_kg", whole.mass_kg)?,
        not_negative("mass_kg", part.mass_kg)?,
    );
    let mass_kg = total - off;
    if mass_kg <= 0.0 {
        return Err(Error::no_result(
            "body without its part",
            format!("a part of {off} kg exceeds the {total} kg of the whole"),
        ));
    }
    let cm_m = (whole.cm_m * total - part.cm_m * off) / mass_kg;
    let between = of_point_mass(mass_kg * off / total, &(part.cm_m - cm_m));
    Ok(RigidBody {
        mass_kg,
        cm_m,
        inertia_kg_m2: whole.inertia_kg_m2 - part.inertia_kg_m2 - between,
    })
}

/// No body has a negative principal moment, nor one greater than the sum of the other two.
pub fn must_be_possible(body: &RigidBody) -> Result<()> {
    let moments = body.inertia_kg_m2.symmetric_eigenvalues();
    let slack = 1e-9 * moments.amax();
    let sum = moments.sum();
    if moments
        .iter()
        .all(|&m| m.is_finite() && m >= -slack && 2.0 * m <= sum + slack)
    {
        return Ok(());
    }
    let reason = format!(
        "principal moments {:?} kg m² belong to no body",
        moments.as_slice()
    );
    Err(Error::no_result("inertia", reason))
}

/// Inertia of a point mass at r, m (r² 1 − r rᵀ): the parallel-axis rule.
fn of_point_mass<S: Real>(mass_kg: S, r: &V3<S>) -> M3<S> {
    (M3::identity() * r.dot(r) - r * r.transpose()) * mass_kg
}

/// Gyradii about the hull's centre of mass of a light square frame of side 2d in the plane of the
/// suspension points: roll, pitch, yaw, m.
pub fn square_frame_gyradii_m(half_spacing_m: f64, cm_depth_m: f64) -> Result<[f64; 3]> {
    let d = positive("half_spacing_m", half_spacing_m)?;
    let level = (finite("cm_depth_m", cm_depth_m)?.powi(2) + 2.0 * d * d / 3.0).sqrt(); // (27)
    Ok([level, level, 2.0 * d / 3.0_f64.sqrt()]) // (27)
}

/// Yaw gyradius with a mass added at each end, m, as the paper draws it in Fig. 7: the shift of the
/// centre of mass is left out. [`joined`] keeps it.
pub fn gyradius_with_end_masses_m(
    mass_kg: f64,
    gyradius_m: f64,
    added_kg: f64,
    fore_m: f64,
    aft_m: f64,
) -> Result<f64> {
    let hull = positive("mass_kg", mass_kg)?;
    let added = not_negative("added_kg", added_kg)?;
    let ends = finite("fore_m", fore_m)?.powi(2) + finite("aft_m", aft_m)?.powi(2);
    let moment = hull * positive("gyradius_m", gyradius_m)?.powi(2) + added * ends;
    root("gyradius", moment / (hull + 2.0 * added)) // Fig. 7
}

/// A body about one axis: mass, and gyradius about the axis through its own centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AxisBody {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Gyradius, m.
    pub gyradius_m: f64,
}

impl AxisBody {
    /// Moment about the axis through the body's own centre, kg m².
    pub fn moment_kg_m2(&self) -> Result<f64> {
        Ok(positive("mass_kg", self.mass_kg)?
            * not_negative("gyradius_m", self.gyradius_m)?.powi(2)) // (1)
    }
}

/// Moment that the distance of two centres adds, kg m², the distance being counted across the axis.
pub fn offset_moment_kg_m2(first_kg: f64, second_kg: f64, distance_m: f64) -> Result<f64> {
    let (a, b) = (
        positive("first_kg", first_kg)?,
        positive("second_kg", second_kg)?,
    );
    result(
        "offset moment",
        a * b / (a + b) * finite("distance_m", distance_m)?.powi(2),
    )
}

/// Gyradius of two bodies joined, m.
pub fn joined_gyradius_m(first: &AxisBody, second: &AxisBody, distance_m: f64) -> Result<f64> {
    let moment = first.moment_kg_m2()?
        + second.moment_kg_m2()?
        + offset_moment_kg_m2(first.mass_kg, second.mass_kg, distance_m)?;
    root("gyradius", moment / (first.mass_kg + second.mass_kg))
}

/// Gyradius of what is left when a part is taken off, m; `distance_m` from the part's centre to the
/// rest's.
pub fn rest_gyradius_m(whole: &AxisBody, part: &AxisBody, distance_m: f64) -> Result<f64> {
    let rest_kg = whole.mass_kg - part.mass_kg;
    let rest = positive("whole minus part, kg", rest_kg)?;
    let moment = whole.moment_kg_m2()?
        - part.moment_kg_m2()?
        - offset_moment_kg_m2(rest, part.mass_kg, distance_m)?;
    root("gyradius", moment / rest)
}
