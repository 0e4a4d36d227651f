//! Lines, what they hang from, and what the tape said of them.

use super::super::cause_id::CauseId;
use super::super::parameter_id::ParameterName;
use super::super::point::{Cause, CauseParameter};
use super::super::unit::UnitName;
use gyradius_mechanics::Real;

use super::{Scales, add, cause, clamped, fixed, logarithm, put, strength};

/// Damping of the heave on elastic lines and of a support's own motion, shares of critical: ropes
/// and steel lie near, most of them within a factor of 2. A line's is fitted: it delays the list
/// that the hull takes with its sway. So does a drag that does not act at the centre of mass, which
/// shows in no other way: what is found is that of both.
const DAMPING: f64 = 0.07;
const DAMPING_U_LN: f64 = 0.7;
/// A light support follows the pull at once; its own frequency is set to this, Hz, some twenty
/// times that of a swing.
const SUPPORT_HZ: f64 = 8.0;

pub fn causes(scales: &Scales) -> Vec<Cause> {
    let mut all: Vec<Cause> = [8.0, 40.0].map(|t| line_creep(scales, t)).to_vec();
    all.extend([
        line_stretch(scales),
        line_torsion(scales, true),
        line_torsion(scales, false),
        nonparallel_lines(scales, true),
        nonparallel_lines(scales, false),
        unequal_lines(scales, true),
        unequal_lines(scales, false),
        off_centre_cm(scales),
        support_compliance(scales),
        stated_length(scales),
        stated_spacing(scales),
    ]);
    all
}

/// The stiffer the support or the line, the longer a simulation takes.
fn stiff_below(stiff_below: f64, parameter: CauseParameter) -> CauseParameter {
    CauseParameter {
        stiff_below,
        ..parameter
    }
}

fn line_creep(scales: &Scales, loaded_before_s: f64) -> Cause {
    let parameters = vec![
        strength(
            ParameterName::CreepMPerDecade,
            UnitName::Metre,
            scales.line_m,
            1e-3,
        ),
        logarithm(
            ParameterName::LoadedBeforeS,
            UnitName::Second,
            loaded_before_s,
            0.8,
        ),
    ];
    let law = put(|q, _, e| {
        add(
            e,
            "line_creep",
            &[
                ("strain_per_decade", q[0]),
                ("loaded_before_s", clamped(q[1], -2.0, 9.0).exp()),
            ],
        )
    });
    Cause {
        one_sided: true,
        ..cause(CauseId::LineCreep, parameters, law)
    }
}

/// The stated length is that of the lines as they carry the hull.
fn line_stretch(scales: &Scales) -> Cause {
    let parameters = vec![
        stiff_below(
            2e-3,
            strength(
                ParameterName::StretchUnderLoadM,
                UnitName::Metre,
                scales.line_m,
                5e-3,
            ),
        ),
        logarithm(
            ParameterName::DampingRatio,
            UnitName::One,
            DAMPING,
            DAMPING_U_LN,
        ),
    ];
    let law = put(|q, _, e| {
        if q[0].value == 0.0 {
            return Ok(());
        }
        let d = &mut e.scene.dimensions;
        d.line_length_m /= q[0] + 1.0;
        // Of unit mass: each line carries g/2 and grows by the share q of its length.
        let stiffness = d.gravity_m_s2 / (q[0] * 2.0 * d.line_length_m);
        let heave_rad_s = (stiffness * 2.0).sqrt();
        let numbers = [
            ("force_per_strain_n", stiffness * d.line_length_m),
            ("delay_s", q[1].exp() * 2.0 / heave_rad_s),
        ];
        add(e, "line_stretch", &numbers)
    });
    Cause {
        alone: true,
        apart: true,
        one_sided: true,
        ..cause(CauseId::LineStretch, parameters, law)
    }
}

/// A spring in yaw: G J of both lines over their length, or of something that does not go with it (a
/// cable, a swivel). Strengths are shares of the lines' own stiffness in yaw.
fn line_torsion(scales: &Scales, by_length: bool) -> Cause {
    let own = scales.gravity_m_s2 * (0.5 * scales.spacing_m).powi(2);
    let (name, unit, per_mass) = if by_length {
        let name = ParameterName::RigidityNM2;
        (name, UnitName::NewtonMetreSquared, own)
    } else {
        let name = ParameterName::StiffnessNMRad;
        (name, UnitName::NewtonMetrePerRadian, own / scales.line_m)
    };
    let parameters = vec![strength(name, unit, per_mass * scales.mass_kg, 0.01)];
    let law = put(move |q, _, e| {
        let line_length_m = e.scene.dimensions.line_length_m;
        let length_m = if by_length { line_length_m } else { fixed(1.0) };
        add(
            e,
            "line_torsion",
            &[("stiffness_n_m_rad", q[0] * per_mass / length_m)],
        )
    });
    Cause {
        one_sided: true,
        ..cause(CauseId::LineTorsion, parameters, law)
    }
}

/// By a share of the spacing, or by one length for all swings.
fn nonparallel_lines(scales: &Scales, by_share: bool) -> Cause {
    let spacing_m = scales.spacing_m;
    let parameters = vec![strength(
        ParameterName::ExcessM,
        UnitName::Metre,
        spacing_m,
        0.02,
    )];
    let law = put(move |q, _, e| {
        let spacing_m = if by_share {
            e.scene.dimensions.top_spacing_m
        } else {
            fixed(spacing_m)
        };
        add(e, "nonparallel_lines", &[("excess_m", q[0] * spacing_m)])
    });
    cause(CauseId::NonparallelLines, parameters, law)
}

fn unequal_lines(scales: &Scales, by_share: bool) -> Cause {
    let line_m = scales.line_m;
    let parameters = vec![strength(
        ParameterName::DifferenceM,
        UnitName::Metre,
        line_m,
        5e-3,
    )];
    let law = put(move |q, _, e| {
        let line_m = if by_share {
            e.scene.dimensions.line_length_m
        } else {
            fixed(line_m)
        };
        add(e, "unequal_lines", &[("difference_m", q[0] * line_m)])
    });
    cause(CauseId::UnequalLines, parameters, law)
}

/// Along the suspension; across it a free hull just hangs aslant.
fn off_centre_cm(scales: &Scales) -> Cause {
    let (spacing_m, pitches) = (scales.spacing_m, scales.pitches);
    let name = if pitches {
        ParameterName::ToPortM
    } else {
        ParameterName::ForwardM
    };
    let parameters = vec![strength(name, UnitName::Metre, spacing_m, 0.02)];
    let law = put(move |q, _, e| add(e, "off_centre_cm", &[(name.name(), q[0] * spacing_m)]));
    cause(CauseId::OffCentreCm, parameters, law)
}

/// Give under the hull's weight pulled sideways, as a share of the lines' length.
fn support_compliance(scales: &Scales) -> Cause {
    let (line_m, gravity) = (scales.line_m, scales.gravity_m_s2);
    let parameters = vec![stiff_below(
        5e-4,
        strength(
            ParameterName::GiveMPerN,
            UnitName::MetrePerNewton,
            line_m / (gravity * scales.mass_kg),
            3e-3,
        ),
    )];
    let law = put(move |q, _, e| {
        if q[0].value == 0.0 {
            return Ok(());
        }
        let stiffness = fixed(gravity) / (q[0] * line_m);
        let own_rad_s = std::f64::consts::TAU * SUPPORT_HZ;
        let damping = stiffness * (2.0 * DAMPING / own_rad_s);
        let numbers = [
            ("mass_kg", stiffness * own_rad_s.powi(-2)),
            ("stiffness_x_n_m", stiffness),
            ("stiffness_y_n_m", stiffness),
            ("damping_x_n_s_m", damping),
            ("damping_y_n_s_m", damping),
        ];
        add(e, "support_compliance", &numbers)
    });
    Cause {
        alone: true,
        apart: true,
        one_sided: true,
        ..cause(CauseId::SupportCompliance, parameters, law)
    }
}

fn stated_length(scales: &Scales) -> Cause {
    let line_m = scales.line_m;
    let parameters = vec![strength(
        ParameterName::ExcessM,
        UnitName::Metre,
        line_m,
        0.01,
    )];
    cause(
        CauseId::StatedLength,
        parameters,
        put(move |q, _, e| add(e, "stated_length", &[("excess_m", q[0] * line_m)])),
    )
}

fn stated_spacing(scales: &Scales) -> Cause {
    let spacing_m = scales.spacing_m;
    let parameters = vec![strength(
        ParameterName::ExcessM,
        UnitName::Metre,
        spacing_m,
        0.01,
    )];
    let law = put(move |q, _, e| add(e, "stated_spacing", &[("excess_m", q[0] * spacing_m)]));
    cause(CauseId::StatedSpacing, parameters, law)
}
