//! The catalogue's table: names, units and the function behind each route.

use super::attachments::{self, AxisBody, RigidBody};
use super::catalogue::{CatalogueEntry, Inputs, Slot};
use super::compound::{self, HeightAndPeriod};
use super::double_pendulum::{self, DepthIs, GyradiusAndDepth, Periods};
use super::guard::{GUARD_95, Limit, Relation, verdict_with_guard};
use super::principal::{self, Principal, Tilt};
use super::yaw::{self, Lines};
use super::{beat, corrections, ellipsoid, finite_amplitude, incline, ratio};
use crate::Result;
use crate::frames::{Mat3, Vec3};
use crate::recording::Quantity;

const XYZ: [&str; 3] = ["x", "y", "z"];

const fn need(name: &'static str, unit: &'static str) -> Slot {
    Slot { name, unit, required: true }
}

const fn may(name: &'static str, unit: &'static str) -> Slot {
    Slot { name, unit, required: false }
}

fn lines(i: &Inputs) -> Result<Lines> {
    let half_spacing_m = i.get("half_spacing_m")?;
    let top_half_spacing_m = i.or("top_half_spacing_m", half_spacing_m);
    Ok(Lines { length_m: i.get("line_length_m")?, half_spacing_m, top_half_spacing_m })
}

fn periods(i: &Inputs) -> Result<Periods> {
    Ok(Periods { in_phase_s: i.get("in_phase_period_s")?, out_of_phase_s: i.get("out_of_phase_period_s")? })
}

fn pendulum_body(i: &Inputs) -> Result<GyradiusAndDepth> {
    Ok(GyradiusAndDepth { gyradius_m: i.get("gyradius_m")?, cm_depth_m: i.get("cm_depth_m")? })
}

fn depth(i: &Inputs) -> Result<DepthIs> {
    Ok(if i.flag("depth_known")? { DepthIs::Known } else { DepthIs::SolvedFor })
}

fn principal_of(i: &Inputs) -> Result<Principal> {
    Ok(Principal { psi_rad: i.get("psi_rad")?, k_px_m: i.get("k_px_m")?, k_pz_m: i.get("k_pz_m")? })
}

fn tilt_fit(i: &Inputs) -> Result<Vec<f64>> {
    let mut tilts = Vec::new();
    for n in 1_u16.. {
        let Some(pitch) = i.optional(&format!("pitch_{n}_rad")) else { break };
        let gyradius =
            Quantity::new(i.get(&format!("gyradius_{n}_m"))?, i.get(&format!("gyradius_u_{n}_m"))?);
        let pitch_rad = Quantity::new(pitch, i.or(&format!("pitch_u_{n}_rad"), 0.0));
        tilts.push(Tilt { pitch_rad, gyradius_m: gyradius });
    }
    for pattern in ["pitch_#_rad", "gyradius_#_m", "gyradius_u_#_m", "pitch_u_#_rad"] {
        i.numbered_up_to(pattern, tilts.len())?;
    }
    let fit = principal::fit_tilts(&tilts, i.or("common_relative_u", 0.0))?;
    let [low, high] = fit.psi_interval_95_rad;
    let p = fit.principal;
    let axes = [p.k_px_m, fit.k_px_u_m, p.k_pz_m, fit.k_pz_u_m];
    let hull = [fit.k_roll_m.value, fit.k_roll_m.u, fit.k_yaw_m.value, fit.k_yaw_m.u, fit.chi_squared];
    Ok([&[p.psi_rad, fit.psi_u_rad, low, high], &axes[..], &hull[..]].concat())
}

fn two_axis_bodies(i: &Inputs) -> Result<(AxisBody, AxisBody)> {
    let one = AxisBody { mass_kg: i.get("mass_1_kg")?, gyradius_m: i.get("gyradius_1_m")? };
    let two = AxisBody { mass_kg: i.get("mass_2_kg")?, gyradius_m: i.get("gyradius_2_m")? };
    Ok((one, two))
}

fn body(i: &Inputs, n: &str) -> Result<RigidBody> {
    let cm: [f64; 3] = i.three(&format!("#_{n}_m"), XYZ)?;
    let [xx, yy, zz] = i.three(&format!("i#_{n}_kg_m2"), ["xx", "yy", "zz"])?;
    let [xy, xz, yz] = i.three(&format!("i#_{n}_kg_m2"), ["xy", "xz", "yz"])?;
    let inertia_kg_m2 = Mat3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    Ok(RigidBody { mass_kg: i.get(&format!("mass_{n}_kg"))?, cm_m: Vec3::from(cm), inertia_kg_m2 })
}

fn numbers_of(body: &RigidBody) -> Vec<f64> {
    let j = &body.inertia_kg_m2;
    let [x, y, z] = [body.cm_m.x, body.cm_m.y, body.cm_m.z];
    vec![body.mass_kg, x, y, z, j.m11, j.m22, j.m33, j.m12, j.m13, j.m23]
}

fn guard_band(i: &Inputs) -> Result<Vec<f64>> {
    let relation = if i.flag("at_least")? { Relation::AtLeast } else { Relation::AtMost };
    let limit = Limit { quantity: "value".into(), relation, limit: i.get("limit")? };
    let value = Quantity::new(i.get("value")?, i.get("u")?);
    let v = verdict_with_guard(value, &limit, i.or("guard_factor", GUARD_95))?;
    let sign = match v.verdict.as_str() {
        "pass" => 1.0,
        "fail" => -1.0,
        _ => 0.0,
    };
    Ok(vec![v.conformance_probability, v.guard_band, sign])
}

pub(super) const ROUTES: &[CatalogueEntry] = &[
    CatalogueEntry {
        name: "moment",
        equation: "(1)",
        summary: "Moment of inertia from mass and gyradius.",
        inputs: &[need("mass_kg", "kg"), need("gyradius_m", "m")],
        outputs: &[need("moment_kg_m2", "kg·m²")],
        function: |i| {
            Ok(vec![
                AxisBody { mass_kg: i.get("mass_kg")?, gyradius_m: i.get("gyradius_m")? }.moment_kg_m2()?,
            ])
        },
    },
    CatalogueEntry {
        name: "principal_to_hull",
        equation: "(3)",
        summary: "Roll and yaw gyradii in hull axes from the principal ones; ψ bow up.",
        inputs: &[need("k_px_m", "m"), need("k_pz_m", "m"), need("psi_rad", "rad")],
        outputs: &[need("k_roll_m", "m"), need("k_yaw_m", "m"), need("xz_m2", "m²")],
        function: |i| {
            let p = principal::centre_plane(&principal_of(i)?)?;
            Ok(vec![p.xx_m2.sqrt(), p.zz_m2.sqrt(), p.xz_m2])
        },
    },
    CatalogueEntry {
        name: "tilted_gyradius",
        equation: "(3)",
        summary: "Gyradius about the vertical of a hull pitched bow up.",
        inputs: &[need("k_px_m", "m"), need("k_pz_m", "m"), need("psi_rad", "rad"), need("pitch_rad", "rad")],
        outputs: &[need("gyradius_m", "m")],
        function: |i| Ok(vec![principal::tilted_gyradius_m(&principal_of(i)?, i.get("pitch_rad")?)?]),
    },
    CatalogueEntry {
        name: "principal_from_one_tilt",
        equation: "(4)",
        summary: "ψ (bow up) and principal gyradii from roll, yaw and one tilted yaw; pitch bow up.",
        inputs: &[
            need("k_roll_m", "m"),
            need("k_yaw_m", "m"),
            need("k_tilted_m", "m"),
            need("pitch_rad", "rad"),
        ],
        outputs: &[need("psi_rad", "rad"), need("k_px_m", "m"), need("k_pz_m", "m")],
        function: |i| {
            let p = principal::from_one_tilt(
                i.get("k_roll_m")?,
                i.get("k_yaw_m")?,
                i.get("k_tilted_m")?,
                i.get("pitch_rad")?,
            )?;
            Ok(vec![p.psi_rad, p.k_px_m, p.k_pz_m])
        },
    },
    CatalogueEntry {
        name: "yaw_period",
        equation: "(5)",
        summary: "Small-amplitude yaw period; top spacing = spacing unless given.",
        inputs: &[
            need("gyradius_m", "m"),
            need("line_length_m", "m"),
            need("half_spacing_m", "m"),
            may("top_half_spacing_m", "m"),
            need("gravity_m_s2", "m/s²"),
        ],
        outputs: &[need("yaw_period_s", "s")],
        function: |i| Ok(vec![yaw::yaw_period_s(i.get("gyradius_m")?, &lines(i)?, i.get("gravity_m_s2")?)?]),
    },
    CatalogueEntry {
        name: "yaw_gyradius",
        equation: "(6)",
        summary: "Yaw gyradius from the yaw period; top spacing = spacing unless given.",
        inputs: &[
            need("yaw_period_s", "s"),
            need("line_length_m", "m"),
            need("half_spacing_m", "m"),
            may("top_half_spacing_m", "m"),
            need("gravity_m_s2", "m/s²"),
        ],
        outputs: &[need("gyradius_m", "m")],
        function: |i| {
            Ok(vec![yaw::yaw_gyradius_m(i.get("yaw_period_s")?, &lines(i)?, i.get("gravity_m_s2")?)?])
        },
    },
    CatalogueEntry {
        name: "sway_period",
        equation: "(7)",
        summary: "Small-amplitude sway period.",
        inputs: &[need("line_length_m", "m"), need("gravity_m_s2", "m/s²")],
        outputs: &[need("sway_period_s", "s")],
        function: |i| Ok(vec![ratio::sway_period_s(i.get("line_length_m")?, i.get("gravity_m_s2")?)?]),
    },
    CatalogueEntry {
        name: "line_length_from_sway",
        equation: "(7)",
        summary: "Line length that a sway period implies.",
        inputs: &[need("sway_period_s", "s"), need("gravity_m_s2", "m/s²")],
        outputs: &[need("line_length_m", "m")],
        function: |i| Ok(vec![ratio::line_length_m(i.get("sway_period_s")?, i.get("gravity_m_s2")?)?]),
    },
    CatalogueEntry {
        name: "ratio_gyradius",
        equation: "(8)",
        summary: "Yaw gyradius from the ratio of yaw and sway periods.",
        inputs: &[need("yaw_period_s", "s"), need("sway_period_s", "s"), need("half_spacing_m", "m")],
        outputs: &[need("gyradius_m", "m")],
        function: |i| {
            Ok(vec![ratio::yaw_gyradius_m(
                i.get("yaw_period_s")?,
                i.get("sway_period_s")?,
                i.get("half_spacing_m")?,
            )?])
        },
    },
    CatalogueEntry {
        name: "beat",
        equation: "(9)–(12)",
        summary: "Average period, beat period and oscillations per beat of two oscillations.",
        inputs: &[need("yaw_period_s", "s"), need("sway_period_s", "s")],
        outputs: &[
            need("average_period_s", "s"),
            need("beat_period_s", "s"),
            need("oscillations_per_beat", "1"),
        ],
        function: |i| {
            let (y, s) = (i.get("yaw_period_s")?, i.get("sway_period_s")?);
            Ok(vec![
                beat::average_period_s(y, s)?,
                beat::beat_period_s(y, s)?,
                beat::oscillations_per_beat(y, s)?,
            ])
        },
    },
    CatalogueEntry {
        name: "beat_gyradius",
        equation: "(13)",
        summary: "Period ratio and yaw gyradius from the oscillations counted per beat; yaw_is_slower 1 where k > d.",
        inputs: &[
            need("oscillations_per_beat", "1"),
            need("half_spacing_m", "m"),
            need("yaw_is_slower", "1"),
        ],
        outputs: &[need("period_ratio", "1"), need("gyradius_m", "m")],
        function: |i| {
            let (n, slower) = (i.get("oscillations_per_beat")?, i.flag("yaw_is_slower")?);
            Ok(vec![
                beat::period_ratio(n, slower)?,
                beat::yaw_gyradius_m(n, i.get("half_spacing_m")?, slower)?,
            ])
        },
    },
    CatalogueEntry {
        name: "double_pendulum_periods",
        equation: "(16)",
        summary: "In-phase (long) and out-of-phase (short) periods.",
        inputs: &[
            need("gyradius_m", "m"),
            need("cm_depth_m", "m"),
            need("line_length_m", "m"),
            need("gravity_m_s2", "m/s²"),
        ],
        outputs: &[need("in_phase_period_s", "s"), need("out_of_phase_period_s", "s")],
        function: |i| {
            let p = double_pendulum::periods_s(
                &pendulum_body(i)?,
                i.get("line_length_m")?,
                i.get("gravity_m_s2")?,
            )?;
            Ok(vec![p.in_phase_s, p.out_of_phase_s])
        },
    },
    CatalogueEntry {
        name: "double_pendulum",
        equation: "(17), (18)",
        summary: "Gyradius and depth from both periods and the sway period.",
        inputs: &[
            need("in_phase_period_s", "s"),
            need("out_of_phase_period_s", "s"),
            need("sway_period_s", "s"),
            need("gravity_m_s2", "m/s²"),
        ],
        outputs: &[need("gyradius_m", "m"), need("cm_depth_m", "m")],
        function: |i| {
            let b = double_pendulum::from_sway_period(
                &periods(i)?,
                i.get("sway_period_s")?,
                i.get("gravity_m_s2")?,
            )?;
            Ok(vec![b.gyradius_m, b.cm_depth_m])
        },
    },
    CatalogueEntry {
        name: "double_pendulum_from_length",
        equation: "(7), (17), (18)",
        summary: "Gyradius and depth from both periods and the line length.",
        inputs: &[
            need("in_phase_period_s", "s"),
            need("out_of_phase_period_s", "s"),
            need("line_length_m", "m"),
            need("gravity_m_s2", "m/s²"),
        ],
        outputs: &[need("gyradius_m", "m"), need("cm_depth_m", "m")],
        function: |i| {
            let b = double_pendulum::from_line_length(
                &periods(i)?,
                i.get("line_length_m")?,
                i.get("gravity_m_s2")?,
            )?;
            Ok(vec![b.gyradius_m, b.cm_depth_m])
        },
    },
    CatalogueEntry {
        name: "double_pendulum_dimensionless",
        equation: "(19)",
        summary: "Periods times √(g/l2) from k/l2 and l1/l2.",
        inputs: &[need("k_over_l2", "1"), need("l1_over_l2", "1")],
        outputs: &[need("in_phase", "1"), need("out_of_phase", "1")],
        function: |i| {
            let p = double_pendulum::dimensionless_periods(i.get("k_over_l2")?, i.get("l1_over_l2")?)?;
            Ok(vec![p.in_phase_s, p.out_of_phase_s])
        },
    },
    CatalogueEntry {
        name: "double_pendulum_sensitivity",
        equation: "Fig. 16",
        summary: "Error of the gyradius for the same error of both periods; depth_known 1: l2 held fixed (the paper), 0: solved for.",
        inputs: &[
            need("gyradius_m", "m"),
            need("cm_depth_m", "m"),
            need("line_length_m", "m"),
            need("gravity_m_s2", "m/s²"),
            need("depth_known", "1"),
        ],
        outputs: &[need("sensitivity_m_s", "m/s")],
        function: |i| {
            Ok(vec![double_pendulum::sensitivity_m_s(
                &pendulum_body(i)?,
                i.get("line_length_m")?,
                i.get("gravity_m_s2")?,
                depth(i)?,
            )?])
        },
    },
    CatalogueEntry {
        name: "double_pendulum_best_length",
        equation: "Fig. 17",
        summary: "Line length of the least such error; depth_known as in double_pendulum_sensitivity.",
        inputs: &[
            need("gyradius_m", "m"),
            need("cm_depth_m", "m"),
            need("gravity_m_s2", "m/s²"),
            need("depth_known", "1"),
        ],
        outputs: &[need("line_length_m", "m")],
        function: |i| {
            Ok(vec![double_pendulum::best_line_length_m(
                &pendulum_body(i)?,
                i.get("gravity_m_s2")?,
                depth(i)?,
            )?])
        },
    },
    CatalogueEntry {
        name: "incline_one_end",
        equation: "(20)",
        summary: "Depth of the centre of mass from a weight at one end; mass_ratio = weight over hull.",
        inputs: &[
            need("mass_ratio", "1"),
            need("arm_m", "m"),
            need("depth_m", "m"),
            need("angle_rad", "rad"),
        ],
        outputs: &[need("cm_depth_m", "m")],
        function: |i| {
            let w = incline::Weight {
                mass_ratio: i.get("mass_ratio")?,
                arm_m: i.get("arm_m")?,
                depth_m: i.get("depth_m")?,
                angle_rad: i.get("angle_rad")?,
            };
            Ok(vec![incline::cm_depth_m(&w)?])
        },
    },
    CatalogueEntry {
        name: "incline_both_ends",
        equation: "(21)",
        summary: "Depth of the centre of mass from a weight at each end in turn.",
        inputs: &[
            need("mass_ratio", "1"),
            need("length_m", "m"),
            need("bow_depth_m", "m"),
            need("stern_depth_m", "m"),
            need("bow_angle_rad", "rad"),
            need("stern_angle_rad", "rad"),
        ],
        outputs: &[need("cm_depth_m", "m")],
        function: |i| {
            let t = incline::BothEnds {
                mass_ratio: i.get("mass_ratio")?,
                length_m: i.get("length_m")?,
                bow_depth_m: i.get("bow_depth_m")?,
                stern_depth_m: i.get("stern_depth_m")?,
                bow_angle_rad: i.get("bow_angle_rad")?,
                stern_angle_rad: i.get("stern_angle_rad")?,
            };
            Ok(vec![incline::cm_depth_from_both_ends_m(&t)?])
        },
    },
    CatalogueEntry {
        name: "suspension_shift",
        equation: "after (26)",
        summary: "Depth from moving the suspension points and the tilt that follows, Δ/tan φ.",
        inputs: &[need("shift_m", "m"), need("angle_rad", "rad")],
        outputs: &[need("cm_depth_m", "m")],
        function: |i| Ok(vec![incline::cm_depth_from_shift_m(i.get("shift_m")?, i.get("angle_rad")?)?]),
    },
    CatalogueEntry {
        name: "tilt_from_gravity",
        equation: "angle of two vectors",
        summary: "Angle between two directions of gravity as one sensor saw them.",
        inputs: &[
            need("before_x", "1"),
            need("before_y", "1"),
            need("before_z", "1"),
            need("after_x", "1"),
            need("after_y", "1"),
            need("after_z", "1"),
        ],
        outputs: &[need("angle_rad", "rad")],
        function: |i| {
            let (a, b) = (i.three("before_#", XYZ)?, i.three("after_#", XYZ)?);
            Ok(vec![incline::tilt_rad(&a.into(), &b.into())?])
        },
    },
    CatalogueEntry {
        name: "compound_period",
        equation: "(22)",
        summary: "Period on a fixed axis, a above the centre of mass.",
        inputs: &[need("gyradius_m", "m"), need("axis_to_cm_m", "m"), need("gravity_m_s2", "m/s²")],
        outputs: &[need("period_s", "s")],
        function: |i| {
            Ok(vec![compound::period_s(
                i.get("gyradius_m")?,
                i.get("axis_to_cm_m")?,
                i.get("gravity_m_s2")?,
            )?])
        },
    },
    CatalogueEntry {
        name: "compound_gyradius",
        equation: "(23)",
        summary: "Gyradius from the period on a fixed axis, a above the centre of mass.",
        inputs: &[need("period_s", "s"), need("axis_to_cm_m", "m"), need("gravity_m_s2", "m/s²")],
        outputs: &[need("gyradius_m", "m")],
        function: |i| {
            Ok(vec![compound::gyradius_m(
                i.get("period_s")?,
                i.get("axis_to_cm_m")?,
                i.get("gravity_m_s2")?,
            )?])
        },
    },
    CatalogueEntry {
        name: "compound_slopes",
        equation: "(24)",
        summary: "∂k/∂a and ∂k/∂T of (23).",
        inputs: &[need("gyradius_m", "m"), need("axis_to_cm_m", "m"), need("gravity_m_s2", "m/s²")],
        outputs: &[need("by_axis_to_cm", "1"), need("by_period_m_s", "m/s")],
        function: |i| {
            let s = compound::slopes(i.get("gyradius_m")?, i.get("axis_to_cm_m")?, i.get("gravity_m_s2")?)?;
            Ok(vec![s.by_axis_to_cm, s.by_period_m_s])
        },
    },
    CatalogueEntry {
        name: "lamboley",
        equation: "(22), (23)",
        summary: "Gyradius and depth from the periods about two axes at known heights.",
        inputs: &[
            need("axis_height_1_m", "m"),
            need("period_1_s", "s"),
            need("axis_height_2_m", "m"),
            need("period_2_s", "s"),
            need("gravity_m_s2", "m/s²"),
        ],
        outputs: &[need("gyradius_m", "m"), need("cm_depth_m", "m")],
        function: |i| {
            let at = |n: [&str; 2]| {
                Ok::<_, crate::Error>(HeightAndPeriod { axis_height_m: i.get(n[0])?, period_s: i.get(n[1])? })
            };
            let r = compound::lamboley(
                at(["axis_height_1_m", "period_1_s"])?,
                at(["axis_height_2_m", "period_2_s"])?,
                i.get("gravity_m_s2")?,
            )?;
            Ok(vec![r.gyradius_m, r.cm_depth_m])
        },
    },
    CatalogueEntry {
        name: "roll_from_tilts",
        equation: "(25)",
        summary: "Roll gyradius from yaw level and at two tilts.",
        inputs: &[
            need("k_yaw_m", "m"),
            need("k_a_m", "m"),
            need("pitch_a_rad", "rad"),
            need("k_b_m", "m"),
            need("pitch_b_rad", "rad"),
        ],
        outputs: &[need("k_roll_m", "m")],
        function: |i| {
            let (a, b) = ((i.get("k_a_m")?, i.get("pitch_a_rad")?), (i.get("k_b_m")?, i.get("pitch_b_rad")?));
            Ok(vec![principal::roll_gyradius_m(i.get("k_yaw_m")?, a, b)?])
        },
    },
    CatalogueEntry {
        name: "roll_from_right_angle",
        equation: "(26)",
        summary: "(25) with the tilts a right angle apart.",
        inputs: &[need("k_yaw_m", "m"), need("k_a_m", "m"), need("k_b_m", "m")],
        outputs: &[need("k_roll_m", "m")],
        function: |i| {
            Ok(vec![principal::roll_gyradius_right_angle_m(
                i.get("k_yaw_m")?,
                i.get("k_a_m")?,
                i.get("k_b_m")?,
            )?])
        },
    },
    CatalogueEntry {
        name: "tilt_fit",
        equation: "(3), (4) by least squares",
        summary: "ψ with its 95 % interval, principal, roll and yaw gyradii with u from three or more tilts (roll: π/2). pitch_u 0 and common_relative_u 0 unless given.",
        inputs: &[
            need("pitch_#_rad", "rad"),
            may("pitch_u_#_rad", "rad"),
            need("gyradius_#_m", "m"),
            need("gyradius_u_#_m", "m"),
            may("common_relative_u", "1"),
        ],
        outputs: &[
            need("psi_rad", "rad"),
            need("psi_u_rad", "rad"),
            need("psi_low_rad", "rad"),
            need("psi_high_rad", "rad"),
            need("k_px_m", "m"),
            need("k_px_u_m", "m"),
            need("k_pz_m", "m"),
            need("k_pz_u_m", "m"),
            need("k_roll_m", "m"),
            need("k_roll_u_m", "m"),
            need("k_yaw_m", "m"),
            need("k_yaw_u_m", "m"),
            need("chi_squared", "1"),
        ],
        function: tilt_fit,
    },
    CatalogueEntry {
        name: "square_frame",
        equation: "(27)",
        summary: "Gyradii of a light square frame of side 2d about the centre of mass of the hull.",
        inputs: &[need("half_spacing_m", "m"), need("cm_depth_m", "m")],
        outputs: &[need("k_roll_m", "m"), need("k_pitch_m", "m"), need("k_yaw_m", "m")],
        function: |i| {
            Ok(attachments::square_frame_gyradii_m(i.get("half_spacing_m")?, i.get("cm_depth_m")?)?.to_vec())
        },
    },
    CatalogueEntry {
        name: "end_masses",
        equation: "Fig. 7",
        summary: "Yaw gyradius with the same mass added at the bow and at the stern.",
        inputs: &[
            need("mass_kg", "kg"),
            need("gyradius_m", "m"),
            need("added_kg", "kg"),
            need("fore_m", "m"),
            need("aft_m", "m"),
        ],
        outputs: &[need("gyradius_m", "m")],
        function: |i| {
            Ok(vec![attachments::gyradius_with_end_masses_m(
                i.get("mass_kg")?,
                i.get("gyradius_m")?,
                i.get("added_kg")?,
                i.get("fore_m")?,
                i.get("aft_m")?,
            )?])
        },
    },
    CatalogueEntry {
        name: "offset_moment",
        equation: "parallel axes",
        summary: "Moment that the distance of two centres of mass adds.",
        inputs: &[need("mass_1_kg", "kg"), need("mass_2_kg", "kg"), need("distance_m", "m")],
        outputs: &[need("moment_kg_m2", "kg·m²")],
        function: |i| {
            Ok(vec![attachments::offset_moment_kg_m2(
                i.get("mass_1_kg")?,
                i.get("mass_2_kg")?,
                i.get("distance_m")?,
            )?])
        },
    },
    CatalogueEntry {
        name: "joined_gyradius",
        equation: "parallel axes",
        summary: "Gyradius of two bodies joined, about one direction; distance across it.",
        inputs: &[
            need("mass_1_kg", "kg"),
            need("gyradius_1_m", "m"),
            need("mass_2_kg", "kg"),
            need("gyradius_2_m", "m"),
            need("distance_m", "m"),
        ],
        outputs: &[need("gyradius_m", "m")],
        function: |i| {
            let (a, b) = two_axis_bodies(i)?;
            Ok(vec![attachments::joined_gyradius_m(&a, &b, i.get("distance_m")?)?])
        },
    },
    CatalogueEntry {
        name: "rest_gyradius",
        equation: "parallel axes",
        summary: "Gyradius of body 1 when its part, body 2, is taken off; distance between the centres of the part and of the rest.",
        inputs: &[
            need("mass_1_kg", "kg"),
            need("gyradius_1_m", "m"),
            need("mass_2_kg", "kg"),
            need("gyradius_2_m", "m"),
            need("distance_m", "m"),
        ],
        outputs: &[need("gyradius_m", "m")],
        function: |i| {
            let (whole, part) = two_axis_bodies(i)?;
            Ok(vec![attachments::rest_gyradius_m(&whole, &part, i.get("distance_m")?)?])
        },
    },
    CatalogueEntry {
        name: "body_joined",
        equation: "parallel axes",
        summary: "Two rigid bodies as one: mass, centre, full tensor about it (elements as they stand in the tensor).",
        inputs: &[
            need("mass_1_kg", "kg"),
            need("x_1_m", "m"),
            need("y_1_m", "m"),
            need("z_1_m", "m"),
            need("ixx_1_kg_m2", "kg·m²"),
            need("iyy_1_kg_m2", "kg·m²"),
            need("izz_1_kg_m2", "kg·m²"),
            need("ixy_1_kg_m2", "kg·m²"),
            need("ixz_1_kg_m2", "kg·m²"),
            need("iyz_1_kg_m2", "kg·m²"),
            need("mass_2_kg", "kg"),
            need("x_2_m", "m"),
            need("y_2_m", "m"),
            need("z_2_m", "m"),
            need("ixx_2_kg_m2", "kg·m²"),
            need("iyy_2_kg_m2", "kg·m²"),
            need("izz_2_kg_m2", "kg·m²"),
            need("ixy_2_kg_m2", "kg·m²"),
            need("ixz_2_kg_m2", "kg·m²"),
            need("iyz_2_kg_m2", "kg·m²"),
        ],
        outputs: &[
            need("mass_kg", "kg"),
            need("x_m", "m"),
            need("y_m", "m"),
            need("z_m", "m"),
            need("ixx_kg_m2", "kg·m²"),
            need("iyy_kg_m2", "kg·m²"),
            need("izz_kg_m2", "kg·m²"),
            need("ixy_kg_m2", "kg·m²"),
            need("ixz_kg_m2", "kg·m²"),
            need("iyz_kg_m2", "kg·m²"),
        ],
        function: |i| Ok(numbers_of(&body(i, "1")?.joined(&body(i, "2")?)?)),
    },
    CatalogueEntry {
        name: "body_without",
        equation: "parallel axes",
        summary: "Rigid body 1 when its part, body 2, is taken off.",
        inputs: &[
            need("mass_1_kg", "kg"),
            need("x_1_m", "m"),
            need("y_1_m", "m"),
            need("z_1_m", "m"),
            need("ixx_1_kg_m2", "kg·m²"),
            need("iyy_1_kg_m2", "kg·m²"),
            need("izz_1_kg_m2", "kg·m²"),
            need("ixy_1_kg_m2", "kg·m²"),
            need("ixz_1_kg_m2", "kg·m²"),
            need("iyz_1_kg_m2", "kg·m²"),
            need("mass_2_kg", "kg"),
            need("x_2_m", "m"),
            need("y_2_m", "m"),
            need("z_2_m", "m"),
            need("ixx_2_kg_m2", "kg·m²"),
            need("iyy_2_kg_m2", "kg·m²"),
            need("izz_2_kg_m2", "kg·m²"),
            need("ixy_2_kg_m2", "kg·m²"),
            need("ixz_2_kg_m2", "kg·m²"),
            need("iyz_2_kg_m2", "kg·m²"),
        ],
        outputs: &[
            need("mass_kg", "kg"),
            need("x_m", "m"),
            need("y_m", "m"),
            need("z_m", "m"),
            need("ixx_kg_m2", "kg·m²"),
            need("iyy_kg_m2", "kg·m²"),
            need("izz_kg_m2", "kg·m²"),
            need("ixy_kg_m2", "kg·m²"),
            need("ixz_kg_m2", "kg·m²"),
            need("iyz_kg_m2", "kg·m²"),
        ],
        function: |i| Ok(numbers_of(&body(i, "1")?.without(&body(i, "2")?)?)),
    },
    CatalogueEntry {
        name: "levelling",
        equation: "(28)",
        summary: "Gyradius about the vertical at angles of pitch and roll from the principal axes.",
        inputs: &[
            need("k_px_m", "m"),
            need("k_py_m", "m"),
            need("k_pz_m", "m"),
            need("pitch_rad", "rad"),
            need("roll_rad", "rad"),
        ],
        outputs: &[need("gyradius_m", "m")],
        function: |i| {
            let k = i.three("k_p#_m", XYZ)?;
            Ok(vec![corrections::tilted_gyradius_m(k, i.get("pitch_rad")?, i.get("roll_rad")?)?])
        },
    },
    CatalogueEntry {
        name: "buoyant_gravity",
        equation: "air damping and added mass",
        summary: "Gravity less the lift of the air.",
        inputs: &[
            need("gravity_m_s2", "m/s²"),
            need("air_density_kg_m3", "kg/m³"),
            need("density_kg_m3", "kg/m³"),
        ],
        outputs: &[need("gravity_m_s2", "m/s²")],
        function: |i| {
            Ok(vec![corrections::buoyant_gravity_m_s2(
                i.get("gravity_m_s2")?,
                i.get("air_density_kg_m3")?,
                i.get("density_kg_m3")?,
            )?])
        },
    },
    CatalogueEntry {
        name: "normal_gravity",
        equation: "WGS 84, TR8350.2 (4-1), (4-3)",
        summary: "Normal gravity from latitude and altitude.",
        inputs: &[need("latitude_deg", "deg"), need("altitude_m", "m")],
        outputs: &[need("gravity_m_s2", "m/s²")],
        function: |i| {
            Ok(vec![corrections::normal_gravity_m_s2(i.get("latitude_deg")?, i.get("altitude_m")?)?])
        },
    },
    CatalogueEntry {
        name: "undamped_period",
        equation: "air damping and added mass",
        summary: "Undamped period from the observed one and the decay time of the amplitude.",
        inputs: &[need("period_s", "s"), need("decay_time_s", "s")],
        outputs: &[need("period_s", "s")],
        function: |i| Ok(vec![corrections::undamped_period_s(i.get("period_s")?, i.get("decay_time_s")?)?]),
    },
    CatalogueEntry {
        name: "pendulum_period_ratio",
        equation: "exact pendulum",
        summary: "Period at amplitude over the small-amplitude period: 2K(sin A/2)/π.",
        inputs: &[need("amplitude_rad", "rad")],
        outputs: &[need("period_ratio", "1")],
        function: |i| Ok(vec![finite_amplitude::pendulum_period_ratio(i.get("amplitude_rad")?)?]),
    },
    CatalogueEntry {
        name: "pendulum_small_period",
        equation: "exact pendulum",
        summary: "Small-amplitude period of a pendulum (sway, compound) from the period at amplitude.",
        inputs: &[need("period_s", "s"), need("amplitude_rad", "rad")],
        outputs: &[need("period_s", "s")],
        function: |i| {
            Ok(vec![finite_amplitude::pendulum_small_period_s(i.get("period_s")?, i.get("amplitude_rad")?)?])
        },
    },
    CatalogueEntry {
        name: "yaw_period_at_amplitude",
        equation: "exact pure yaw, heave included",
        summary: "Yaw period at amplitude.",
        inputs: &[
            need("gyradius_m", "m"),
            need("amplitude_rad", "rad"),
            need("line_length_m", "m"),
            need("half_spacing_m", "m"),
            may("top_half_spacing_m", "m"),
            need("gravity_m_s2", "m/s²"),
        ],
        outputs: &[need("yaw_period_s", "s")],
        function: |i| {
            Ok(vec![finite_amplitude::yaw_period_at_amplitude_s(
                i.get("gyradius_m")?,
                &lines(i)?,
                i.get("gravity_m_s2")?,
                i.get("amplitude_rad")?,
            )?])
        },
    },
    CatalogueEntry {
        name: "yaw_small_period",
        equation: "exact pure yaw, heave included",
        summary: "Small-amplitude yaw period and gyradius from the period at amplitude.",
        inputs: &[
            need("yaw_period_s", "s"),
            need("amplitude_rad", "rad"),
            need("line_length_m", "m"),
            need("half_spacing_m", "m"),
            may("top_half_spacing_m", "m"),
            need("gravity_m_s2", "m/s²"),
        ],
        outputs: &[need("yaw_period_s", "s"), need("gyradius_m", "m")],
        function: |i| {
            let k = finite_amplitude::yaw_gyradius_at_amplitude_m(
                i.get("yaw_period_s")?,
                &lines(i)?,
                i.get("gravity_m_s2")?,
                i.get("amplitude_rad")?,
            )?;
            Ok(vec![yaw::yaw_period_s(k, &lines(i)?, i.get("gravity_m_s2")?)?, k])
        },
    },
    CatalogueEntry {
        name: "equivalent_ellipsoid",
        equation: "Fig. 1",
        summary: "Semi-axes of the homogeneous ellipsoid of the same gyradii.",
        inputs: &[need("k_px_m", "m"), need("k_py_m", "m"), need("k_pz_m", "m")],
        outputs: &[need("a_m", "m"), need("b_m", "m"), need("c_m", "m")],
        function: |i| Ok(ellipsoid::equivalent_semi_axes_m(i.three("k_p#_m", XYZ)?)?.to_vec()),
    },
    CatalogueEntry {
        name: "inertia_ellipsoid",
        equation: "Fig. 1",
        summary: "Semi-axes 1/√I of the inertia ellipsoid.",
        inputs: &[need("mass_kg", "kg"), need("k_px_m", "m"), need("k_py_m", "m"), need("k_pz_m", "m")],
        outputs: &[need("a", "kg^(-1/2)/m"), need("b", "kg^(-1/2)/m"), need("c", "kg^(-1/2)/m")],
        function: |i| {
            Ok(ellipsoid::inertia_ellipsoid_semi_axes(i.get("mass_kg")?, i.three("k_p#_m", XYZ)?)?.to_vec())
        },
    },
    CatalogueEntry {
        name: "guard_band",
        equation: "JCGM 106, 7 and 8",
        summary: "Verdict against a limit: 1 pass, 0 undecided, −1 fail. at_least 1: the value must reach the limit, 0: must not exceed it. Guard factor 1.645 (95 %) unless given.",
        inputs: &[
            need("value", "1"),
            need("u", "1"),
            need("limit", "1"),
            need("at_least", "1"),
            may("guard_factor", "1"),
        ],
        outputs: &[need("conformance_probability", "1"), need("guard_band", "1"), need("verdict", "1")],
        function: guard_band,
    },
];
