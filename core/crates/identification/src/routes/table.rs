//! The catalogue's table: names, equations and the function behind each route.
//!
//! A row reads `route!(name, equation, summary; inputs [= default] => outputs; values)`: in the
//! values the inputs are variables of their names. Units follow from the names ([`unit_of`]).

use super::attachments::{self, AxisBody};
use super::compound::{self, HeightAndPeriod};
use super::double_pendulum::{self, DepthIs, GyradiusAndDepth, Periods};
use super::entry::{CatalogueEntry, Inputs, Slot};
use super::guard::{GUARD_95, Relation, judge};
use super::principal::{self, Principal, Tilt};
use super::yaw::{self, Lines};
use super::{beat, corrections, ellipsoid, finite_amplitude, incline, ratio};
use crate::names::Decision;
use gyradius_base::frames::{Mat3, Vec3};
use gyradius_base::{Error, Result};
use gyradius_mechanics::RigidBody;
use gyradius_recording::Quantity;
use gyradius_recording::import::{from_core_motion, stamp_from_core_motion};

const fn need(name: &'static str) -> Slot {
    Slot {
        name,
        unit: unit_of(name),
        required: true,
    }
}

const fn may(name: &'static str) -> Slot {
    Slot {
        name,
        unit: unit_of(name),
        required: false,
    }
}

const fn in_root_moment(name: &'static str) -> Slot {
    Slot {
        name,
        unit: "kg^(-1/2)/m",
        required: true,
    }
}

/// Unit that the end of a name tells, `1` for a plain number.
const fn unit_of(name: &str) -> &'static str {
    const ENDINGS: [(&str, &str); 13] = [
        ("_kg_m2", "kg·m²"),
        ("_kg_m3", "kg/m³"),
        ("_m_s2", "m/s²"),
        ("_m_s", "m/s"),
        ("_m2", "m²"),
        ("_kg", "kg"),
        ("_m", "m"),
        ("_ns", "ns"),
        ("_s", "s"),
        ("_rad", "rad"),
        ("_deg", "deg"),
        ("_g", "g"),
        ("", "1"),
    ];
    let mut i = 0;
    while !ends_with(name.as_bytes(), ENDINGS[i].0.as_bytes()) {
        i += 1;
    }
    ENDINGS[i].1
}

const fn ends_with(text: &[u8], ending: &[u8]) -> bool {
    let mut left = ending.len();
    while left > 0 && left <= text.len() && text[text.len() - left] == ending[ending.len() - left] {
        left -= 1;
    }
    left == 0
}

macro_rules! route {
    ($name:ident, $equation:literal, $summary:literal;
     $($input:ident $(= $default:expr)?),+ => $($output:ident),+; $values:expr) => {
        CatalogueEntry {
            name: stringify!($name),
            equation: $equation,
            summary: $summary,
            inputs: &[$(route!(@slot $input $($default)?)),+],
            outputs: &[$(need(stringify!($output))),+],
            function: |inputs| {
                $(let $input = route!(@value inputs, $input $($default)?);)+
                Ok(Vec::from($values))
            },
        }
    };
    (@slot $input:ident) => { need(stringify!($input)) };
    (@slot $input:ident $default:expr) => { may(stringify!($input)) };
    (@value $inputs:ident, $input:ident) => { $inputs.get(stringify!($input))? };
    (@value $inputs:ident, $input:ident $default:expr) => { $inputs.or(stringify!($input), $default) };
}

/// True for 1, false for 0.
fn yes(name: &str, value: f64) -> Result<bool> {
    match value {
        1.0 => Ok(true),
        0.0 => Ok(false),
        other => Err(Error::argument(name, "0 (no) or 1 (yes)", other)),
    }
}

fn depth(known: f64) -> Result<DepthIs> {
    Ok(if yes("depth_known", known)? {
        DepthIs::Known
    } else {
        DepthIs::SolvedFor
    })
}

fn tilt_fit(i: &Inputs) -> Result<Vec<f64>> {
    let mut tilts = Vec::new();
    for n in 1_u16.. {
        let Some(pitch) = i.optional(&format!("pitch_{n}_rad")) else {
            break;
        };
        let gyradius = Quantity::new(
            i.get(&format!("gyradius_{n}_m"))?,
            i.get(&format!("gyradius_u_{n}_m"))?,
        );
        let pitch_rad = Quantity::new(pitch, i.or(&format!("pitch_u_{n}_rad"), 0.0));
        tilts.push(Tilt {
            pitch_rad,
            gyradius_m: gyradius,
        });
    }
    for pattern in [
        "pitch_#_rad",
        "gyradius_#_m",
        "gyradius_u_#_m",
        "pitch_u_#_rad",
    ] {
        i.numbered_up_to(pattern, tilts.len())?;
    }
    let fit = principal::fit_tilts(&tilts, i.or("common_relative_u", 0.0))?;
    let [low, high] = fit.psi_interval_95_rad;
    let p = fit.principal;
    let axes = [p.k_px_m, fit.k_px_u_m, p.k_pz_m, fit.k_pz_u_m];
    let hull = [
        fit.k_roll_m.value,
        fit.k_roll_m.u,
        fit.k_yaw_m.value,
        fit.k_yaw_m.u,
        fit.chi_squared,
    ];
    Ok([&[p.psi_rad, fit.psi_u_rad, low, high], &axes[..], &hull[..]].concat())
}

fn body(i: &Inputs, n: &str) -> Result<RigidBody> {
    let cm: [f64; 3] = i.three(&format!("#_{n}_m"), ["x", "y", "z"])?;
    let [xx, yy, zz] = i.three(&format!("i#_{n}_kg_m2"), ["xx", "yy", "zz"])?;
    let [xy, xz, yz] = i.three(&format!("i#_{n}_kg_m2"), ["xy", "xz", "yz"])?;
    let inertia_kg_m2 = Mat3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz);
    Ok(RigidBody {
        mass_kg: i.get(&format!("mass_{n}_kg"))?,
        cm_m: Vec3::from(cm),
        inertia_kg_m2,
    })
}

fn numbers_of(body: &RigidBody) -> Vec<f64> {
    let j = &body.inertia_kg_m2;
    let [x, y, z] = [body.cm_m.x, body.cm_m.y, body.cm_m.z];
    vec![
        body.mass_kg,
        x,
        y,
        z,
        j.m11,
        j.m22,
        j.m33,
        j.m12,
        j.m13,
        j.m23,
    ]
}

fn guard_band(value: Quantity, bound: f64, at_least: f64, factor: f64) -> Result<[f64; 3]> {
    let relation = if yes("at_least", at_least)? {
        Relation::AtLeast
    } else {
        Relation::AtMost
    };
    let judged = judge(value, (relation, bound), factor)?;
    let sign = match judged.decision {
        Decision::Pass => 1.0,
        Decision::Fail => -1.0,
        Decision::Undecided => 0.0,
    };
    Ok([judged.conformance_probability, judged.guard_band, sign])
}

/// Two rigid bodies: mass, centre, elements as they stand in the tensor.
#[rustfmt::skip]
const TWO_BODIES: &[Slot] = &[
    need("mass_1_kg"), need("x_1_m"), need("y_1_m"), need("z_1_m"),
    need("ixx_1_kg_m2"), need("iyy_1_kg_m2"), need("izz_1_kg_m2"),
    need("ixy_1_kg_m2"), need("ixz_1_kg_m2"), need("iyz_1_kg_m2"),
    need("mass_2_kg"), need("x_2_m"), need("y_2_m"), need("z_2_m"),
    need("ixx_2_kg_m2"), need("iyy_2_kg_m2"), need("izz_2_kg_m2"),
    need("ixy_2_kg_m2"), need("ixz_2_kg_m2"), need("iyz_2_kg_m2"),
];
#[rustfmt::skip]
const ONE_BODY: &[Slot] = &[
    need("mass_kg"), need("x_m"), need("y_m"), need("z_m"),
    need("ixx_kg_m2"), need("iyy_kg_m2"), need("izz_kg_m2"),
    need("ixy_kg_m2"), need("ixz_kg_m2"), need("iyz_kg_m2"),
];

pub(super) const ROUTES: &[CatalogueEntry] = &[
    route!(moment, "(1)", "Moment of inertia from mass and gyradius.";
        mass_kg, gyradius_m => moment_kg_m2;
        [AxisBody { mass_kg, gyradius_m }.moment_kg_m2()?]),
    route!(principal_to_hull, "(3)", "Roll and yaw gyradii in hull axes from the principal ones; ψ bow up.";
    k_px_m, k_pz_m, psi_rad => k_roll_m, k_yaw_m, xz_m2; {
        let p = principal::centre_plane(&Principal { psi_rad, k_px_m, k_pz_m })?;
        [p.xx_m2.sqrt(), p.zz_m2.sqrt(), p.xz_m2]
    }),
    route!(tilted_gyradius, "(3)", "Gyradius about the vertical of a hull pitched bow up.";
        k_px_m, k_pz_m, psi_rad, pitch_rad => gyradius_m;
        [principal::tilted_gyradius_m(&Principal { psi_rad, k_px_m, k_pz_m }, pitch_rad)?]),
    route!(principal_from_one_tilt, "(4)",
    "ψ (bow up) and principal gyradii from roll, yaw and one tilted yaw; pitch bow up.";
    k_roll_m, k_yaw_m, k_tilted_m, pitch_rad => psi_rad, k_px_m, k_pz_m; {
        let p = principal::from_one_tilt(k_roll_m, k_yaw_m, k_tilted_m, pitch_rad)?;
        [p.psi_rad, p.k_px_m, p.k_pz_m]
    }),
    route!(yaw_period, "(5)", "Small-amplitude yaw period; top spacing = spacing unless given.";
    gyradius_m, line_length_m, half_spacing_m, top_half_spacing_m = half_spacing_m, gravity_m_s2 => yaw_period_s; {
        let lines = Lines { length_m: line_length_m, half_spacing_m, top_half_spacing_m };
        [yaw::yaw_period_s(gyradius_m, &lines, gravity_m_s2)?]
    }),
    route!(yaw_gyradius, "(6)", "Yaw gyradius from the yaw period; top spacing = spacing unless given.";
    yaw_period_s, line_length_m, half_spacing_m, top_half_spacing_m = half_spacing_m, gravity_m_s2 => gyradius_m; {
        let lines = Lines { length_m: line_length_m, half_spacing_m, top_half_spacing_m };
        [yaw::yaw_gyradius_m(yaw_period_s, &lines, gravity_m_s2)?]
    }),
    route!(sway_period, "(7)", "Small-amplitude sway period.";
        line_length_m, gravity_m_s2 => sway_period_s;
        [ratio::sway_period_s(line_length_m, gravity_m_s2)?]),
    route!(line_length_from_sway, "(7)", "Line length that a sway period implies.";
        sway_period_s, gravity_m_s2 => line_length_m;
        [ratio::line_length_m(sway_period_s, gravity_m_s2)?]),
    route!(ratio_gyradius, "(8)", "Yaw gyradius from the ratio of yaw and sway periods.";
        yaw_period_s, sway_period_s, half_spacing_m => gyradius_m;
        [ratio::yaw_gyradius_m(yaw_period_s, sway_period_s, half_spacing_m)?]),
    route!(beat, "(9)–(12)", "Average period, beat period and oscillations per beat of two oscillations.";
    yaw_period_s, sway_period_s => average_period_s, beat_period_s, oscillations_per_beat; [
        beat::average_period_s(yaw_period_s, sway_period_s)?,
        beat::beat_period_s(yaw_period_s, sway_period_s)?,
        beat::oscillations_per_beat(yaw_period_s, sway_period_s)?,
    ]),
    route!(beat_gyradius, "(13)",
    "Period ratio and yaw gyradius from the oscillations counted per beat; yaw_is_slower 1 where k > d.";
    oscillations_per_beat, half_spacing_m, yaw_is_slower => period_ratio, gyradius_m; {
        let slower = yes("yaw_is_slower", yaw_is_slower)?;
        let ratio = beat::period_ratio(oscillations_per_beat, slower)?;
        [ratio, beat::yaw_gyradius_m(oscillations_per_beat, half_spacing_m, slower)?]
    }),
    route!(double_pendulum_periods, "(16)", "In-phase (long) and out-of-phase (short) periods.";
    gyradius_m, cm_depth_m, line_length_m, gravity_m_s2 => in_phase_period_s, out_of_phase_period_s; {
        let body = GyradiusAndDepth { gyradius_m, cm_depth_m };
        let p = double_pendulum::periods_s(&body, line_length_m, gravity_m_s2)?;
        [p.in_phase_s, p.out_of_phase_s]
    }),
    route!(double_pendulum, "(17), (18)", "Gyradius and depth from both periods and the sway period.";
    in_phase_period_s, out_of_phase_period_s, sway_period_s, gravity_m_s2 => gyradius_m, cm_depth_m; {
        let periods = Periods { in_phase_s: in_phase_period_s, out_of_phase_s: out_of_phase_period_s };
        let b = double_pendulum::from_sway_period(&periods, sway_period_s, gravity_m_s2)?;
        [b.gyradius_m, b.cm_depth_m]
    }),
    route!(double_pendulum_from_length, "(7), (17), (18)", "Gyradius and depth from both periods and the line length.";
    in_phase_period_s, out_of_phase_period_s, line_length_m, gravity_m_s2 => gyradius_m, cm_depth_m; {
        let periods = Periods { in_phase_s: in_phase_period_s, out_of_phase_s: out_of_phase_period_s };
        let b = double_pendulum::from_line_length(&periods, line_length_m, gravity_m_s2)?;
        [b.gyradius_m, b.cm_depth_m]
    }),
    route!(double_pendulum_dimensionless, "(19)", "Periods times √(g/l2) from k/l2 and l1/l2.";
    k_over_l2, l1_over_l2 => in_phase, out_of_phase; {
        let p = double_pendulum::dimensionless_periods(k_over_l2, l1_over_l2)?;
        [p.in_phase_s, p.out_of_phase_s]
    }),
    route!(double_pendulum_sensitivity, "Fig. 16",
    "Error of the gyradius for the same error of both periods; depth_known 1: l2 held fixed (the paper), 0: solved for.";
    gyradius_m, cm_depth_m, line_length_m, gravity_m_s2, depth_known => sensitivity_m_s; {
        let body = GyradiusAndDepth { gyradius_m, cm_depth_m };
        [double_pendulum::sensitivity_m_s(&body, line_length_m, gravity_m_s2, depth(depth_known)?)?]
    }),
    route!(double_pendulum_best_length, "Fig. 17",
    "Line length of the least such error; depth_known as in double_pendulum_sensitivity.";
    gyradius_m, cm_depth_m, gravity_m_s2, depth_known => line_length_m; {
        let body = GyradiusAndDepth { gyradius_m, cm_depth_m };
        [double_pendulum::best_line_length_m(&body, gravity_m_s2, depth(depth_known)?)?]
    }),
    route!(incline_one_end, "(20)",
        "Depth of the centre of mass from a weight at one end; mass_ratio = weight over hull.";
        mass_ratio, arm_m, depth_m, angle_rad => cm_depth_m;
        [incline::cm_depth_m(&incline::Weight { mass_ratio, arm_m, depth_m, angle_rad })?]),
    route!(incline_both_ends, "(21)", "Depth of the centre of mass from a weight at each end in turn.";
        mass_ratio, length_m, bow_depth_m, stern_depth_m, bow_angle_rad, stern_angle_rad => cm_depth_m;
        [incline::cm_depth_from_both_ends_m(&incline::BothEnds {
            mass_ratio, length_m, bow_depth_m, stern_depth_m, bow_angle_rad, stern_angle_rad,
        })?]),
    route!(suspension_shift, "after (26)",
        "Depth from moving the suspension points and the tilt that follows, Δ/tan φ.";
        shift_m, angle_rad => cm_depth_m;
        [incline::cm_depth_from_shift_m(shift_m, angle_rad)?]),
    route!(tilt_from_gravity, "angle of two vectors",
    "Angle between two directions of gravity as one sensor saw them.";
    before_x, before_y, before_z, after_x, after_y, after_z => angle_rad; {
        let before = Vec3::new(before_x, before_y, before_z);
        [incline::tilt_rad(&before, &Vec3::new(after_x, after_y, after_z))?]
    }),
    route!(compound_period, "(22)", "Period on a fixed axis, a above the centre of mass.";
        gyradius_m, axis_to_cm_m, gravity_m_s2 => period_s;
        [compound::period_s(gyradius_m, axis_to_cm_m, gravity_m_s2)?]),
    route!(compound_gyradius, "(23)", "Gyradius from the period on a fixed axis, a above the centre of mass.";
        period_s, axis_to_cm_m, gravity_m_s2 => gyradius_m;
        [compound::gyradius_m(period_s, axis_to_cm_m, gravity_m_s2)?]),
    route!(compound_slopes, "(24)", "∂k/∂a and ∂k/∂T of (23).";
    gyradius_m, axis_to_cm_m, gravity_m_s2 => by_axis_to_cm, by_period_m_s; {
        let s = compound::slopes(gyradius_m, axis_to_cm_m, gravity_m_s2)?;
        [s.by_axis_to_cm, s.by_period_m_s]
    }),
    route!(lamboley, "(22), (23)", "Gyradius and depth from the periods about two axes at known heights.";
    axis_height_1_m, period_1_s, axis_height_2_m, period_2_s, gravity_m_s2 => gyradius_m, cm_depth_m; {
        let first = HeightAndPeriod { axis_height_m: axis_height_1_m, period_s: period_1_s };
        let second = HeightAndPeriod { axis_height_m: axis_height_2_m, period_s: period_2_s };
        let r = compound::lamboley(first, second, gravity_m_s2)?;
        [r.gyradius_m, r.cm_depth_m]
    }),
    route!(roll_from_tilts, "(25)", "Roll gyradius from yaw level and at two tilts.";
        k_yaw_m, k_a_m, pitch_a_rad, k_b_m, pitch_b_rad => k_roll_m;
        [principal::roll_gyradius_m(k_yaw_m, (k_a_m, pitch_a_rad), (k_b_m, pitch_b_rad))?]),
    route!(roll_from_right_angle, "(26)", "(25) with the tilts a right angle apart.";
        k_yaw_m, k_a_m, k_b_m => k_roll_m;
        [principal::roll_gyradius_right_angle_m(k_yaw_m, k_a_m, k_b_m)?]),
    CatalogueEntry {
        name: "tilt_fit",
        equation: "(3), (4) by least squares",
        summary: "ψ with its 95 % interval, principal, roll and yaw gyradii with u from three or more tilts (roll: π/2). pitch_u 0 and common_relative_u 0 unless given.",
        inputs: &[
            need("pitch_#_rad"),
            may("pitch_u_#_rad"),
            need("gyradius_#_m"),
            need("gyradius_u_#_m"),
            may("common_relative_u"),
        ],
        outputs: &[
            need("psi_rad"),
            need("psi_u_rad"),
            need("psi_low_rad"),
            need("psi_high_rad"),
            need("k_px_m"),
            need("k_px_u_m"),
            need("k_pz_m"),
            need("k_pz_u_m"),
            need("k_roll_m"),
            need("k_roll_u_m"),
            need("k_yaw_m"),
            need("k_yaw_u_m"),
            need("chi_squared"),
        ],
        function: tilt_fit,
    },
    route!(square_frame, "(27)", "Gyradii of a light square frame of side 2d about the centre of mass of the hull.";
        half_spacing_m, cm_depth_m => k_roll_m, k_pitch_m, k_yaw_m;
        attachments::square_frame_gyradii_m(half_spacing_m, cm_depth_m)?),
    route!(end_masses, "Fig. 7", "Yaw gyradius with the same mass added at the bow and at the stern.";
        mass_kg, gyradius_m, added_kg, fore_m, aft_m => gyradius_m;
        [attachments::gyradius_with_end_masses_m(mass_kg, gyradius_m, added_kg, fore_m, aft_m)?]),
    route!(offset_moment, "parallel axes", "Moment that the distance of two centres of mass adds.";
        mass_1_kg, mass_2_kg, distance_m => moment_kg_m2;
        [attachments::offset_moment_kg_m2(mass_1_kg, mass_2_kg, distance_m)?]),
    route!(joined_gyradius, "parallel axes",
    "Gyradius of two bodies joined, about one direction; distance across it.";
    mass_1_kg, gyradius_1_m, mass_2_kg, gyradius_2_m, distance_m => gyradius_m; {
        let one = AxisBody { mass_kg: mass_1_kg, gyradius_m: gyradius_1_m };
        let two = AxisBody { mass_kg: mass_2_kg, gyradius_m: gyradius_2_m };
        [attachments::joined_gyradius_m(&one, &two, distance_m)?]
    }),
    route!(rest_gyradius, "parallel axes",
    "Gyradius of body 1 when its part, body 2, is taken off; distance between the centres of the part and of the rest.";
    mass_1_kg, gyradius_1_m, mass_2_kg, gyradius_2_m, distance_m => gyradius_m; {
        let whole = AxisBody { mass_kg: mass_1_kg, gyradius_m: gyradius_1_m };
        let part = AxisBody { mass_kg: mass_2_kg, gyradius_m: gyradius_2_m };
        [attachments::rest_gyradius_m(&whole, &part, distance_m)?]
    }),
    CatalogueEntry {
        name: "body_joined",
        equation: "parallel axes",
        summary: "Two rigid bodies as one: mass, centre, full tensor about it (elements as they stand in the tensor).",
        inputs: TWO_BODIES,
        outputs: ONE_BODY,
        function: |i| {
            Ok(numbers_of(&attachments::joined(
                &body(i, "1")?,
                &body(i, "2")?,
            )?))
        },
    },
    CatalogueEntry {
        name: "body_without",
        equation: "parallel axes",
        summary: "Rigid body 1 when its part, body 2, is taken off.",
        inputs: TWO_BODIES,
        outputs: ONE_BODY,
        function: |i| {
            Ok(numbers_of(&attachments::without(
                &body(i, "1")?,
                &body(i, "2")?,
            )?))
        },
    },
    route!(levelling, "(28)",
        "Gyradius about the vertical at angles of pitch and roll from the principal axes.";
        k_px_m, k_py_m, k_pz_m, pitch_rad, roll_rad => gyradius_m;
        [corrections::tilted_gyradius_m([k_px_m, k_py_m, k_pz_m], pitch_rad, roll_rad)?]),
    route!(buoyant_gravity, "air damping and added mass", "Gravity less the lift of the air.";
        gravity_m_s2, air_density_kg_m3, density_kg_m3 => gravity_m_s2;
        [corrections::buoyant_gravity_m_s2(gravity_m_s2, air_density_kg_m3, density_kg_m3)?]),
    route!(normal_gravity, "WGS 84, TR8350.2 (4-1), (4-3)", "Normal gravity from latitude and altitude.";
        latitude_deg, altitude_m => gravity_m_s2;
        [corrections::normal_gravity_m_s2(latitude_deg, altitude_m)?]),
    route!(undamped_period, "air damping and added mass",
        "Undamped period from the observed one and the decay time of the amplitude.";
        period_s, decay_time_s => period_s;
        [corrections::undamped_period_s(period_s, decay_time_s)?]),
    route!(pendulum_period_ratio, "exact pendulum",
        "Period at amplitude over the small-amplitude period: 2K(sin A/2)/π.";
        amplitude_rad => period_ratio;
        [finite_amplitude::pendulum_period_ratio(amplitude_rad)?]),
    route!(pendulum_small_period, "exact pendulum",
        "Small-amplitude period of a pendulum (sway, compound) from the period at amplitude.";
        period_s, amplitude_rad => period_s;
        [finite_amplitude::pendulum_small_period_s(period_s, amplitude_rad)?]),
    route!(yaw_period_at_amplitude, "exact pure yaw, heave included", "Yaw period at amplitude.";
    gyradius_m, amplitude_rad, line_length_m, half_spacing_m, top_half_spacing_m = half_spacing_m, gravity_m_s2
    => yaw_period_s; {
        let lines = Lines { length_m: line_length_m, half_spacing_m, top_half_spacing_m };
        [finite_amplitude::yaw_period_at_amplitude_s(gyradius_m, &lines, gravity_m_s2, amplitude_rad)?]
    }),
    route!(yaw_small_period, "exact pure yaw, heave included",
    "Small-amplitude yaw period and gyradius from the period at amplitude.";
    yaw_period_s, amplitude_rad, line_length_m, half_spacing_m, top_half_spacing_m = half_spacing_m, gravity_m_s2
    => yaw_period_s, gyradius_m; {
        let lines = Lines { length_m: line_length_m, half_spacing_m, top_half_spacing_m };
        let k = finite_amplitude::yaw_gyradius_at_amplitude_m(yaw_period_s, &lines, gravity_m_s2, amplitude_rad)?;
        [yaw::yaw_period_s(k, &lines, gravity_m_s2)?, k]
    }),
    route!(equivalent_ellipsoid, "Fig. 1", "Semi-axes of the homogeneous ellipsoid of the same gyradii.";
        k_px_m, k_py_m, k_pz_m => a_m, b_m, c_m;
        ellipsoid::equivalent_semi_axes_m([k_px_m, k_py_m, k_pz_m])?),
    CatalogueEntry {
        outputs: &[
            in_root_moment("a"),
            in_root_moment("b"),
            in_root_moment("c"),
        ],
        ..route!(inertia_ellipsoid, "Fig. 1", "Semi-axes 1/√I of the inertia ellipsoid.";
            mass_kg, k_px_m, k_py_m, k_pz_m => a, b, c;
            ellipsoid::inertia_ellipsoid_semi_axes(mass_kg, [k_px_m, k_py_m, k_pz_m])?)
    },
    route!(guard_band, "JCGM 106, 7 and 8",
        "Verdict against a limit: 1 pass, 0 undecided, −1 fail. at_least 1: the value must reach the limit, 0: must not exceed it. Guard factor 1.645 (95 %) unless given.";
        value, u, limit, at_least, guard_factor = GUARD_95 => conformance_probability, guard_band, verdict;
        guard_band(Quantity::new(value, u), limit, at_least, guard_factor)?),
    route!(core_motion, "Core Motion",
    "What iOS gives as specific force (the other sign, m/s²) and as a stamp in ns.";
    acceleration_x_g, acceleration_y_g, acceleration_z_g, timestamp_s
    => force_x_m_s2, force_y_m_s2, force_z_m_s2, stamp_ns; {
        let [x, y, z] = from_core_motion([acceleration_x_g, acceleration_y_g, acceleration_z_g]);
        [x, y, z, stamp_from_core_motion(timestamp_s)? as f64]
    }),
];
