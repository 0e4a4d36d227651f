//! What small-oscillation theory says a session should show, for given parameters.

use gyradius_base::error::{Error, Result};
use gyradius_base::frames::{Rotation, Vec3, world_from_hull_heeled};
use gyradius_mechanics::{
    M3, Real, Rig, RigidBody, SmallModes, SuspensionAxis, V3, compound_pendulum_period_s,
    small_modes,
};
use gyradius_recording::{
    Incline, ModeName, Orientation, Quantity, Session, Suspension, SuspensionKind, Swing,
};

use super::parameters::{Layout, SwingIndex};
use super::routes::attachments::{joined, remainder};
use super::routes::yaw::{Lines, yaw_period_s};

/// Everything that hangs, in hull axes: mass, centre of mass from the mid-point of the suspension
/// points, inertia about the centre of mass.
///
/// The hull itself is the same to port and starboard. What rides on it off its middle plane brings
/// the products I_xy and I_yz and a centre of mass off that plane.
pub fn hanging_body<S: Real>(layout: &Layout, x: &[S], log_depth: usize) -> RigidBody<S> {
    let mass = x[layout.mass];
    let mut k2 = layout.log_gyradii.map(|i| x[i].scale(2.0).exp());
    let yaw2 = k2[2];
    k2[0] *= yaw2;
    let mut inertia = M3::from_diagonal(&V3::from(k2)) * mass;
    inertia[(0, 2)] = x[layout.product_xz] * mass;
    inertia[(2, 0)] = inertia[(0, 2)];
    let mut cm_m = V3::new(S::zero(), S::zero(), -x[log_depth].exp());
    // First and second moments about the suspension's mid-point: the hull has y = 0.
    let riding = layout
        .attachment_positions
        .iter()
        .zip(&layout.attachment_masses);
    let (mut first, mut second) = (S::zero(), V3::zeros());
    for (place, m) in riding {
        let at_m = place.map(|k| x[k]);
        first += x[*m] * at_m[1];
        second += V3::from(at_m) * (x[*m] * at_m[1]);
    }
    cm_m.y = first / mass;
    for i in [0, 2] {
        inertia[(i, 1)] = mass * cm_m[i] * cm_m.y - second[i];
        inertia[(1, i)] = inertia[(i, 1)];
    }
    RigidBody {
        mass_kg: mass,
        inertia_kg_m2: inertia,
        cm_m,
    }
}

/// From hull axes to those of the hanging hull: heeled about its own x axis, then pitched.
pub fn world_from_hull(x: &[f64], index: &SwingIndex) -> Rotation {
    let heel_deg = index.roll_deg.map_or(0.0, |i| x[i]);
    world_from_hull_heeled(x[index.pitch_deg].to_radians(), heel_deg.to_radians())
}

/// The same as a matrix.
pub fn world_from_hull_matrix<S: Real>(x: &[S], index: &SwingIndex) -> M3<S> {
    let rad = |degrees: S| degrees.scale(1f64.to_radians());
    let heel = index.roll_deg.map_or(S::zero(), |i| rad(x[i]));
    about_y(-rad(x[index.pitch_deg])) * about_x(heel)
}

fn about_x<S: Real>(angle_rad: S) -> M3<S> {
    let (zero, one) = (S::zero(), S::one());
    let (sin, cos) = (angle_rad.sin(), angle_rad.cos());
    M3::new(one, zero, zero, zero, cos, -sin, zero, sin, cos)
}

fn about_y<S: Real>(angle_rad: S) -> M3<S> {
    let (zero, one) = (S::zero(), S::one());
    let (sin, cos) = (angle_rad.sin(), angle_rad.cos());
    M3::new(cos, zero, sin, zero, one, zero, -sin, zero, cos)
}

/// How much of a length along the hull's z axis is vertical as it hangs.
pub fn upright(x: &[f64], index: &SwingIndex) -> f64 {
    let heel_deg = index.roll_deg.map_or(0.0, |i| x[i]);
    x[index.pitch_deg].to_radians().cos() * heel_deg.to_radians().cos()
}

/// The body of one swing as it hangs: added masses on, pitched and heeled as stated, centre of mass
/// below the suspension.
///
/// Added masses that shift the centre of mass fore and aft tilt a hull that is free to pitch until
/// the centre hangs below the suspension again.
pub fn swing_body<S: Real>(
    layout: &Layout,
    x: &[S],
    swing: &Swing,
    index: &SwingIndex,
) -> Result<RigidBody<S>> {
    let turned = world_from_hull_matrix(x, index);
    // The depth parameter is the vertical one of this hanging: the centre lies straight below.
    let mut body = hanging_body(layout, x, index.log_depth);
    body = RigidBody {
        cm_m: body.cm_m,
        ..body.turned(&turned)
    };
    let masses = &layout.added_masses[index.added_masses];
    for (added, mass) in swing.added_masses.iter().zip(masses) {
        let point = RigidBody {
            mass_kg: x[*mass],
            inertia_kg_m2: M3::zeros(),
            cm_m: turned * V3::from(added.position_m.map(S::constant)),
        };
        body = joined(&body, &point)?;
    }
    Ok(settle(&body, swing.suspension.orientation))
}

fn settle<S: Real>(body: &RigidBody<S>, orientation: Orientation) -> RigidBody<S> {
    let cm = body.cm_m;
    body.turned(&match orientation {
        Orientation::Athwartships => about_y(cm.x.atan2(-cm.z)),
        Orientation::ForeAndAft => about_x(-cm.y.atan2(-cm.z)),
    })
}

/// The lines of a bifilar swing.
pub fn swing_rig(layout: &Layout, x: &[f64], swing: &Swing, index: &SwingIndex) -> Result<Rig> {
    if swing.suspension.kind == SuspensionKind::Trifilar {
        let reason = "three lines are not simulated";
        return Err(Error::no_result(&swing.id, reason));
    }
    let lines = swing_lines(x, swing, index)?;
    Rig::bifilar(
        axis(swing.suspension.orientation),
        lines.length_m,
        2.0 * lines.half_spacing_m,
        2.0 * lines.top_half_spacing_m,
        x[layout.gravity],
    )
}

/// The suspension's direction for the dynamics.
pub fn axis(orientation: Orientation) -> SuspensionAxis {
    match orientation {
        Orientation::Athwartships => SuspensionAxis::Athwartships,
        Orientation::ForeAndAft => SuspensionAxis::ForeAndAft,
    }
}

/// Names of the four small oscillations, slowest first: each name once, even where two modes nearly
/// share a period and with it their shapes. Yaw is what turns most about the vertical, sway what of
/// the rest goes most along the suspension; of the double pendulum in phase is the slower (errata
/// to (16)).
pub fn mode_names(body: &RigidBody, modes: &SmallModes, orientation: Orientation) -> [ModeName; 4] {
    let unit = axis(orientation).unit();
    let most = |energy: &dyn Fn(usize) -> f64, taken: Option<usize>| {
        let open = (0..4).filter(|i| Some(*i) != taken);
        open.max_by(|a, b| energy(*a).total_cmp(&energy(*b)))
            .unwrap_or_default()
    };
    let yaw = most(
        &|i| body.inertia_kg_m2[(2, 2)] * modes.rotation(i).z.powi(2),
        None,
    );
    let sway = most(
        &|i| body.mass_kg * modes.displacement(i).dot(&unit).powi(2),
        Some(yaw),
    );
    let [slow, fast] = match orientation {
        Orientation::Athwartships => [ModeName::PitchInPhase, ModeName::PitchOutOfPhase],
        Orientation::ForeAndAft => [ModeName::RollInPhase, ModeName::RollOutOfPhase],
    };
    let mut names = [fast; 4];
    if let Some(first) = (0..4).find(|i| *i != yaw && *i != sway) {
        names[first] = slow;
    }
    (names[yaw], names[sway]) = (ModeName::Yaw, ModeName::Sway);
    names
}

/// Small-amplitude undamped periods of one swing by mode, s.
pub fn swing_periods(
    layout: &Layout,
    x: &[f64],
    swing: &Swing,
    index: &SwingIndex,
) -> Result<Vec<(ModeName, f64)>> {
    let body = swing_body(layout, x, swing, index)?;
    if let Some(height) = index.axis_height {
        return Ok(vec![(
            ModeName::Compound,
            compound_period_s(&body, swing, x[height], x[layout.gravity]),
        )]);
    }
    if swing.suspension.kind == SuspensionKind::Trifilar {
        return trifilar_periods(layout, x, swing, index, &body);
    }
    let modes = small_modes(&swing_rig(layout, x, swing, index)?, &body)?;
    let names = mode_names(&body, &modes, swing.suspension.orientation);
    Ok((0..4).map(|i| (names[i], modes.period_s(i))).collect())
}

/// The lines of a swing by the stated figures, as the laws of yaw want them.
pub fn swing_lines(x: &[f64], swing: &Swing, index: &SwingIndex) -> Result<Lines> {
    let value = |i: Option<usize>, key: &str| {
        i.map(|i| x[i])
            .ok_or_else(|| Error::no_result(&swing.id, format!("the suspension states no {key}")))
    };
    Ok(Lines {
        length_m: value(index.line_length, "line_length")?,
        half_spacing_m: 0.5 * value(index.spacing, "spacing")?,
        top_half_spacing_m: 0.5 * value(index.top_spacing, "top_spacing")?,
    })
}

/// Whether a suspension has a motion of that name: one that [`swing_periods`] knows the period of.
pub fn has_motion(hung: &Suspension, mode: ModeName) -> bool {
    use ModeName::{
        Compound, PitchInPhase, PitchOutOfPhase, RollInPhase, RollOutOfPhase, Sway, Yaw,
    };
    match (hung.kind, mode) {
        (SuspensionKind::Bifilar, Yaw | Sway) => true,
        (SuspensionKind::Bifilar, PitchInPhase | PitchOutOfPhase) => {
            hung.orientation == Orientation::Athwartships
        }
        (SuspensionKind::Bifilar, RollInPhase | RollOutOfPhase) => {
            hung.orientation == Orientation::ForeAndAft
        }
        (SuspensionKind::Compound, mode) => mode == Compound,
        (SuspensionKind::Trifilar, Yaw) => true,
        (SuspensionKind::Trifilar, Sway) => sways_as_pendulum(hung),
        _ => false,
    }
}

/// Whether the lines are stated as parallel.
pub fn sways_as_pendulum(suspension: &Suspension) -> bool {
    let value = |figure: Option<Quantity>| figure.map(|figure| figure.value);
    let top = value(suspension.top_spacing_m);
    top.is_none() || top == value(suspension.spacing_m)
}

/// Three lines on a circle turn a body as two a diameter apart do, (5); where they are parallel it
/// sways as a pendulum, (7), and does not pitch. The centre of mass lies on the axis.
fn trifilar_periods(
    layout: &Layout,
    x: &[f64],
    swing: &Swing,
    index: &SwingIndex,
    body: &RigidBody,
) -> Result<Vec<(ModeName, f64)>> {
    let lines = swing_lines(x, swing, index)?;
    let k = (body.inertia_kg_m2[(2, 2)] / body.mass_kg).sqrt();
    let gravity = x[layout.gravity];
    let mut periods = vec![(ModeName::Yaw, yaw_period_s(k, &lines, gravity)?)];
    if sways_as_pendulum(&swing.suspension) {
        let sway = std::f64::consts::TAU * (lines.length_m / gravity).sqrt();
        periods.push((ModeName::Sway, sway));
    }
    Ok(periods)
}

/// Eq. (22): the axis lies `axis_height_m` above the suspension points, along the suspension's
/// direction.
pub fn compound_period_s(
    body: &RigidBody,
    swing: &Swing,
    axis_height_m: f64,
    gravity_m_s2: f64,
) -> f64 {
    let unit = axis(swing.suspension.orientation).unit();
    let k2 = unit.dot(&(body.inertia_kg_m2 * unit)) / body.mass_kg;
    compound_pendulum_period_s(k2.sqrt(), axis_height_m - body.cm_m.z, gravity_m_s2)
}

/// The angle an incline weight makes, degrees, eq. (20) solved for the angle.
pub fn incline_angle_deg(layout: &Layout, x: &[f64], incline: &Incline, log_depth: usize) -> f64 {
    let (m, arm, drop) = (
        incline.mass_kg.value,
        incline.arm_m.value,
        incline.depth_m.value,
    );
    (m * arm / (x[layout.mass] * x[log_depth].exp() + m * drop))
        .atan()
        .to_degrees()
}

/// The hull alone: attachments taken off the hanging body.
pub fn hull_alone(
    session: &Session,
    layout: &Layout,
    x: &[f64],
    log_depth: usize,
) -> Result<RigidBody> {
    let body = hanging_body(layout, x, log_depth);
    session
        .attachments
        .iter()
        .zip(
            layout
                .attachment_masses
                .iter()
                .zip(&layout.attachment_positions),
        )
        .try_fold(body, |body, (attachment, (mass, place))| {
            let cm_m = Vec3::from(place.map(|k| x[k]));
            remainder(
                &body,
                &RigidBody::from_gyradii(x[*mass], attachment.gyradii_m, cm_m),
            )
        })
}
