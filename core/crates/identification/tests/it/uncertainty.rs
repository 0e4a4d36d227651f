//! The stated uncertainty against Monte Carlo (JCGM 101): inputs and periods drawn from what is
//! stated of them, the whole estimate run for each draw; and the guard band's promise (JCGM 106)
//! counted.
#![allow(clippy::unwrap_used)]

use std::f64::consts::TAU;

use gyradius_identification::{MeasureOptions, Measurement, measure, routes::guard};
use gyradius_recording::{LoadedData, LoadedSession, LoadedSwing, Quantity, Swing, read_session};
use gyradius_test_support::rng;
use rand::RngExt;
use rand_distr::StandardNormal;

const DRAWS: usize = 1200;
const QUANTITIES: [&str; 4] = ["k_yaw_m", "k_pitch_m", "k_roll_m", "cm_depth_m"];
/// A correct program exceeds this in one of the test's 11 comparisons less than once in 10 000
/// runs.
const BOUND: f64 = 4.5;

/// The hull of Fig. 15 with the roll gyradius of Table 3: roll, pitch, yaw gyradius and depth, m.
const HULL: [f64; 4] = [0.204, 0.352, 0.303, 0.253];
const GRAVITY: f64 = 9.80665;

/// Both periods of the double pendulum by (16).
fn double_pendulum(k: f64, l1: f64) -> [f64; 2] {
    let (l2, k2) = (HULL[3], k * k);
    let sum = l1 * l2 + l2 * l2 + k2;
    let root = (sum * sum - 4.0 * l1 * l2 * k2).sqrt();
    [-1.0, 1.0].map(|sign| TAU / (GRAVITY * (sum + sign * root) / (2.0 * l1 * k2)).sqrt())
}

/// What somebody wrote down: name and value with u, in the order of [`session`].
fn stated() -> Vec<Quantity> {
    let (l1, d, roll_l1, roll_d) = (1.006, 0.28, 0.8, 0.15);
    let [pitch_in, pitch_out] = double_pendulum(HULL[1], l1);
    let [roll_in, roll_out] = double_pendulum(HULL[0], roll_l1);
    let yaw = TAU * HULL[2] / d * (l1 / GRAVITY).sqrt(); // (5)
    let sway = TAU * (l1 / GRAVITY).sqrt(); // (7)
    let q = Quantity::new;
    vec![
        q(GRAVITY, 5e-4),
        q(l1, 0.002),
        q(2.0 * d, 0.001),
        q(roll_l1, 0.002),
        q(2.0 * roll_d, 0.001),
        q(yaw, 0.004),
        q(sway, 0.004),
        q(pitch_in, 0.004),
        q(pitch_out, 0.002),
        q(roll_in, 0.004),
        q(roll_out, 0.002),
    ]
}

/// The session that states these values, with the uncertainties of [`stated`].
fn session(values: &[f64]) -> LoadedSession {
    let figures = stated();
    let s: Vec<String> = values
        .iter()
        .zip(&figures)
        .map(|(value, q)| format!("{{ value = {value:?}, u = {:?} }}", q.u))
        .collect();
    let suspension = |orientation: &str, length: &str, spacing: &str| {
        format!(
            "[swing.suspension]\nkind = \"bifilar\"\norientation = \"{orientation}\"\nline_length = {length}\n\
             spacing = {spacing}\nhull_pitch_deg = {{ value = 0.0, u = 0.0 }}\n"
        )
    };
    let text = format!(
        "format = \"gyradius-session/1\"\n[body]\nmass = 13.18\n[site]\ngravity = {}\n\
         [[swing]]\nid = \"level\"\n\
         periods_s = {{ yaw = {}, sway = {}, pitch_in_phase = {}, pitch_out_of_phase = {} }}\n{}\
         [[swing]]\nid = \"roll\"\nperiods_s = {{ roll_in_phase = {}, roll_out_of_phase = {} }}\n{}",
        s[0],
        s[5],
        s[6],
        s[7],
        s[8],
        suspension("athwartships", &s[1], &s[2]),
        s[9],
        s[10],
        suspension("fore_and_aft", &s[3], &s[4]),
    );
    let session = read_session(&text, "session.toml").unwrap();
    let typed = |swing: &Swing| LoadedSwing {
        id: swing.id.clone(),
        data: LoadedData::Typed,
    };
    let data = session.swings.iter().map(typed).collect();
    LoadedSession {
        session,
        source: "drawn".into(),
        data,
        inclines: vec![],
        assumed: vec![],
    }
}

fn results(values: &[f64]) -> Measurement {
    measure(&session(values), &MeasureOptions::default()).unwrap()
}

fn numbers(measurement: &Measurement) -> [f64; 4] {
    QUANTITIES.map(|name| measurement.quantities[name].value.scalar().unwrap())
}

fn correlation(x: &[[f64; 4]], mean: &[f64; 4], (i, j): (usize, usize)) -> f64 {
    let sum = |a: usize, b: usize| {
        x.iter()
            .map(|r| (r[a] - mean[a]) * (r[b] - mean[b]))
            .sum::<f64>()
    };
    sum(i, j) / (sum(i, i) * sum(j, j)).sqrt()
}

#[test]
fn the_stated_uncertainty_is_that_of_monte_carlo() {
    let (mut rng, inputs) = (rng(), stated());
    let centre = results(&inputs.iter().map(|q| q.value).collect::<Vec<_>>());
    let drawn: Vec<Vec<f64>> = (0..DRAWS)
        .map(|_| {
            inputs
                .iter()
                .map(|q| q.value + q.u * rng.sample::<f64, _>(StandardNormal))
                .collect()
        })
        .collect();
    let x: Vec<[f64; 4]> = std::thread::scope(|scope| {
        let half = |part: &[Vec<f64>]| {
            part.iter()
                .map(|v| numbers(&results(v)))
                .collect::<Vec<_>>()
        };
        let (left, right) = drawn.split_at(DRAWS / 2);
        let other = scope.spawn(move || half(left));
        let mut all = half(right);
        all.extend(other.join().unwrap());
        all
    });
    let n = DRAWS as f64;
    let mean: [f64; 4] = std::array::from_fn(|i| x.iter().map(|r| r[i]).sum::<f64>() / n);
    let values = numbers(&centre);
    for (i, name) in QUANTITIES.iter().enumerate() {
        let spread = (x.iter().map(|r| (r[i] - mean[i]).powi(2)).sum::<f64>() / (n - 1.0)).sqrt();
        let u = centre.quantities[*name].u.scalar().unwrap();
        println!(
            "{name}: {:.6} ± {u:.6}, Monte Carlo {:.6} ± {spread:.6}",
            values[i], mean[i]
        );
        // Standard errors of a mean and of a standard deviation of n normal draws.
        assert!(
            (mean[i] - values[i]).abs() < BOUND * u / n.sqrt(),
            "{name}: mean"
        );
        let excess = (spread / u).ln();
        assert!(
            excess < BOUND / (2.0 * n).sqrt(),
            "{name}: {spread} against {u}"
        );
        // Where the principal axes point is no input: nobody measured it, and a roll is less
        // certain for it.
        let is_roll = *name == "k_roll_m";
        assert!(
            is_roll || excess > -BOUND / (2.0 * n).sqrt(),
            "{name}: {spread} against {u}"
        );
    }
    for i in [0, 1, 3] {
        for j in [0, 1, 3].into_iter().filter(|j| *j > i) {
            let (a, b) = (QUANTITIES[i], QUANTITIES[j]);
            let found = centre
                .correlations
                .iter()
                .find(|(x, y, _)| [(a, b), (b, a)].contains(&(x.as_str(), y.as_str())));
            let (r, counted) = (found.unwrap().2, correlation(&x, &mean, (i, j)));
            println!("{a}, {b}: r {r:.3}, Monte Carlo {counted:.3}");
            // Fisher: atanh r scatters by 1/√(n − 3).
            assert!(
                (r.atanh() - counted.atanh()).abs() < BOUND / (n - 3.0).sqrt(),
                "{a}, {b}"
            );
        }
    }
}

/// A hull that lies at the limit passes, and fails, in 5 % of measurements each: the risk the guard
/// band promises.
#[test]
fn a_hull_at_the_limit_passes_once_in_twenty() {
    let mut rng = rng();
    let limit: guard::Limit = "k_pitch_m>=1.1".parse().unwrap();
    let n = 40_000;
    let mut count = [0.0_f64; 2];
    for _ in 0..n {
        let seen = Quantity::new(1.1 + 0.003 * rng.sample::<f64, _>(StandardNormal), 0.003);
        match guard::verdict(seen, &limit).unwrap().verdict.name() {
            "pass" => count[0] += 1.0,
            "fail" => count[1] += 1.0,
            _ => {}
        }
    }
    let (expected, sd) = (0.05 * f64::from(n), (0.05 * 0.95 * f64::from(n)).sqrt());
    println!("{count:?} of {n}");
    assert!(
        count.iter().all(|c| (c - expected).abs() < BOUND * sd),
        "{count:?}"
    );
}

/// People type short names; a name that is none is refused with the nearest one, not left without a
/// verdict.
#[test]
fn limits_go_by_short_names_too() {
    for (text, name) in [
        ("k_yaw>=1.05", "k_yaw_m"),
        ("k_pitch_m <= 1.1", "k_pitch_m"),
        ("depth>=0.3", "cm_depth_m"),
        ("small_period_yaw-1_s<=4.4", "small_period_yaw-1_s"),
    ] {
        let limit: guard::Limit = text.parse().unwrap();
        assert_eq!(limit.quantity, name, "{text}");
    }
    for (text, told) in [
        ("k_jaw>=1", "the nearest is `k_yaw`"),
        ("inertia_kg_m2>=1", "one of k_yaw"),
    ] {
        let said = text.parse::<guard::Limit>().unwrap_err().to_string();
        assert!(said.contains(told), "{said}");
    }
}
