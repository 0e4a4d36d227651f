//! Data that no picture should choke on: none, one point, constant, not a number, infinite,
//! absurdly large.

use gyradius_identification::{AmplitudePoint, Claim, ModeResult, Value};
use gyradius_report::{Curve, Peak, ReportSource, SpectrumFigureData, figures, html, thinned};

use crate::report::samples::keelboat;
use crate::report::well_formed::assert_well_formed;

pub const BAD: [f64; 8] = [
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    0.0,
    -1.0,
    1e300,
    -1e300,
    1e-300,
];

/// No attribute of a drawing may hold anything but finite numbers.
pub fn assert_finite(source: &ReportSource, what: &str) {
    let page = html(source);
    assert_well_formed(&page);
    for figure in figures(source) {
        let lower = figure.svg.to_lowercase();
        assert!(
            !lower.contains("nan") && !lower.contains("inf"),
            "{what}: {} holds {:.400}",
            figure.id,
            figure.svg
        );
        for value in numbers(&figure.svg) {
            assert!(
                value.is_finite() && value.abs() <= 1e5,
                "{what}: {value} in {}",
                figure.id
            );
        }
    }
}

/// Numbers in the attributes that place things.
fn numbers(svg: &str) -> Vec<f64> {
    let keys = [
        "x", "y", "x1", "x2", "y1", "y2", "cx", "cy", "rx", "ry", "width", "height", "points",
        "viewBox",
    ];
    keys.iter()
        .flat_map(|key| {
            svg.split(&format!(" {key}=\""))
                .skip(1)
                .map(str::to_string)
                .collect::<Vec<_>>()
        })
        .flat_map(|rest| {
            rest[..rest.find('"').unwrap_or(0)]
                .split([' ', ','])
                .map(str::to_string)
                .collect::<Vec<_>>()
        })
        .map(|text| text.parse().unwrap_or(f64::NAN))
        .collect()
}

fn with_curve(x: Vec<f64>, y: Vec<f64>) -> ReportSource {
    let mut source = keelboat();
    let curve = Curve { x, y };
    for trace in &mut source.recordings[0].traces {
        (trace.measured, trace.model, trace.residual) =
            (curve.clone(), curve.clone(), curve.clone());
        trace.close_up = Some([curve.clone(), Curve::default()]);
        trace.noise = curve.y.first().copied();
    }
    let peaks = curve
        .x
        .iter()
        .map(|f| Peak {
            freq_hz: *f,
            name: "yaw".into(),
        })
        .collect();
    source.recordings[0].spectrum = Some(SpectrumFigureData {
        amplitude: curve.clone(),
        residual: Some(curve),
        peaks,
        ..Default::default()
    });
    source
}

#[test]
fn curves() {
    assert_finite(&with_curve(vec![], vec![]), "no points");
    assert_finite(&with_curve(vec![1.0, 2.0, 3.0], vec![4.0; 3]), "constant");
    assert_finite(&with_curve(vec![1.0; 3], vec![1.0, 2.0, 3.0]), "one time");
    assert_finite(&with_curve(vec![1.0, 2.0], vec![3.0]), "uneven lengths");
    assert_finite(&with_curve(BAD.to_vec(), BAD.to_vec()), "all bad");
    for bad in BAD {
        assert_finite(&with_curve(vec![bad], vec![bad]), "one bad point");
        assert_finite(
            &with_curve(vec![0.0, 1.0, 2.0], vec![0.5, bad, 0.6]),
            "a bad ordinate",
        );
        assert_finite(
            &with_curve(vec![0.0, bad, 2.0], vec![0.5, 0.55, 0.6]),
            "a bad abscissa",
        );
        let curve = thinned(&[bad, 1.0, bad], &[1.0, bad, bad]);
        assert_finite(&with_curve(curve.x, curve.y), "thinned");
    }
}

#[test]
fn modes_and_windows() {
    for bad in BAD {
        let mut source = keelboat();
        let point = AmplitudePoint {
            t_s: bad,
            amplitude: bad,
            period_s: bad,
            period_se_s: bad,
            decrement: bad,
            decrement_se: bad,
        };
        let mode = &mut source.measurement.swings[0].modes[0];
        mode.against_amplitude.push(point);
        assert_finite(&source, "a bad window");
        let mode = &mut source.measurement.swings[0].modes[0];
        *mode = ModeResult {
            period_s: bad,
            period_se_s: bad,
            period_observed_s: bad,
            decay_time_s: Some(bad),
            decay_time_se_s: Some(bad),
            amplitude: Some(bad),
            relative_db: bad,
            against_amplitude: vec![point; 3],
            ..mode.clone()
        };
        source.measurement.swings[0].rms_over_noise = Some(bad);
        source.measurement.swings[0].span_s = Some([bad, bad]);
        assert_finite(&source, "a bad mode");
    }
}

#[test]
fn quantities_budgets_and_claims() {
    for bad in BAD {
        let mut source = keelboat();
        for quantity in source.measurement.quantities.values_mut() {
            if matches!(quantity.value, Value::Scalar(_)) {
                (quantity.value, quantity.u, quantity.interval_95) =
                    (bad.into(), bad.into(), Some([bad, bad]));
            } else {
                quantity.value = Value::Vector([bad; 3]);
            }
        }
        for lines in source.measurement.budget.values_mut() {
            lines[0].u_contribution = bad;
        }
        let claim = &source.measurement.consistency[0];
        let broken = Claim {
            stated: bad,
            stated_u: bad,
            implied: bad,
            implied_u: bad,
            sigma: bad,
            ..claim.clone()
        };
        source.measurement.consistency.push(broken);
        for verdict in &mut source.measurement.verdicts {
            (
                verdict.limit,
                verdict.guard_band,
                verdict.conformance_probability,
            ) = (bad, bad, bad);
        }
        assert_finite(&source, "bad results");
    }
}

#[test]
fn values_of_another_shape() {
    let mut source = keelboat();
    for shape in [
        Value::Scalar(f64::NAN),
        Value::Scalar(1.0),
        Value::Vector([f64::NAN; 3]),
        Value::Vector([1.0; 3]),
        Value::Matrix([[f64::NAN; 3]; 3]),
        Value::Matrix([[1.0; 3]; 3]),
    ] {
        for quantity in source.measurement.quantities.values_mut() {
            (quantity.value, quantity.u) = (shape, shape);
        }
        assert_finite(&source, "another shape");
    }
}
