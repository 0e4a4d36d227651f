//! The body that swings, from what is true of the hull.

use gyradius_base::frames::{Mat3, Rotation, Vec3, world_from_hull_heeled};
use gyradius_mechanics::{Body, RigidBody};
use gyradius_recording::{AddedMass, Attachment};

/// What is true of the hull without its attachments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Hull {
    pub mass_kg: f64,
    /// About the hull's x, y, z through its centre of mass.
    pub gyradii_m: [f64; 3],
    pub psi_rad: f64,
    /// Of the centre of mass below the suspension points, level.
    pub cm_depth_m: f64,
}

impl Hull {
    /// The hull and what rides on it, hung so that the centre of mass of all lies straight below.
    pub fn with(&self, attachments: &[Attachment]) -> RigidBody {
        let moment: Vec3 = attachments
            .iter()
            .map(|a| Vec3::from(a.position_m) * a.mass_kg.value)
            .sum();
        let mut cm_m = -moment / self.mass_kg;
        cm_m.z = -self.cm_depth_m;
        let hull = RigidBody {
            mass_kg: self.mass_kg,
            inertia_kg_m2: self.inertia(),
            cm_m,
        };
        let body = |a: &Attachment| {
            RigidBody::from_gyradii(a.mass_kg.value, a.gyradii_m, Vec3::from(a.position_m))
        };
        joined(std::iter::once(hull).chain(attachments.iter().map(body)))
    }

    /// tan 2ψ = 2 I_xz / (I_xx − I_zz), eqs. (3) and (4) in tensor form.
    fn inertia(&self) -> Mat3 {
        let squares = Vec3::from(self.gyradii_m.map(|k| k * k));
        let mut tensor = Mat3::from_diagonal(&squares);
        tensor[(0, 2)] = 0.5 * (squares.x - squares.z) * (2.0 * self.psi_rad).tan();
        tensor[(2, 0)] = tensor[(0, 2)];
        tensor * self.mass_kg
    }
}

/// One body of several (parallel-axis theorem).
fn joined(parts: impl Iterator<Item = RigidBody> + Clone) -> RigidBody {
    let mass_kg: f64 = parts.clone().map(|part| part.mass_kg).sum();
    let cm_m = parts
        .clone()
        .map(|part| part.cm_m * part.mass_kg)
        .sum::<Vec3>()
        / mass_kg;
    let about = |part: RigidBody| {
        let arm = part.cm_m - cm_m;
        part.inertia_kg_m2
            + (Mat3::identity() * arm.norm_squared() - arm * arm.transpose()) * part.mass_kg
    };
    RigidBody {
        mass_kg,
        inertia_kg_m2: parts.map(about).sum(),
        cm_m,
    }
}

/// A body hung at an angle, in hanging axes.
pub struct Hung {
    pub hanging_from_hull: Rotation,
    pub body: RigidBody,
    /// Where the hull's origin (mid-way between the points of a level hanging) lies.
    pub origin_m: Vec3,
}

/// The body pitched bow up, the suspension points moved along the deck until they are above the
/// centre of mass as they were when level; then what is added for the swing.
pub fn hung(level: &RigidBody, [bow_up_rad, heel_rad]: [f64; 2], added: &[AddedMass]) -> Hung {
    let hanging_from_hull = world_from_hull_heeled(bow_up_rad, heel_rad);
    let cm_m = Vec3::new(
        level.cm_m.x,
        level.cm_m.y,
        level.cm_m.z / (bow_up_rad.cos() * heel_rad.cos()),
    );
    let tilted = RigidBody {
        cm_m,
        ..level.rotated(hanging_from_hull)
    };
    let point = |one: &AddedMass| {
        RigidBody::from_gyradii(
            one.mass_kg.value,
            [0.0; 3],
            hanging_from_hull * Vec3::from(one.position_m),
        )
    };
    let body = joined(std::iter::once(tilted).chain(added.iter().map(point)));
    Hung {
        hanging_from_hull,
        body,
        origin_m: cm_m - hanging_from_hull * level.cm_m,
    }
}

/// The named numbers of a body.
pub fn numbers(body: &RigidBody) -> Body {
    Body::new(body.mass_kg, &body.inertia_kg_m2, &body.cm_m)
}

/// The body of named numbers.
pub fn rigid(body: &Body) -> RigidBody {
    RigidBody {
        mass_kg: body.mass_kg,
        inertia_kg_m2: body.inertia(),
        cm_m: body.cm(),
    }
}
