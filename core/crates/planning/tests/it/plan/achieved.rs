//! Predicted against achieved uncertainty: hulls are drawn at random, the planner is told rough
//! figures of each, what it plans is swung by the simulation and measured.

use std::collections::BTreeMap;

use gyradius_identification::{MeasureOptions, QuantityName, measure};
use gyradius_planning::{Means, Plan, PlannedSwing, Request, RoughHull, Step, plan};
use gyradius_recording::{Excitation, Overwrite, Quantity, load_session};
use gyradius_simulator::{practise, read_rig, save_practised};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use gyradius_test_support::rng;

/// A hull that nobody has measured, and what is rough about what is told of it.
struct True {
    mass_kg: f64,
    length_m: f64,
    beam_m: f64,
    k_m: [f64; 3],
    depth_m: f64,
    psi_deg: f64,
}

fn drawn(rng: &mut ChaCha8Rng) -> True {
    let length_m = rng.random_range(3.0..9.0);
    let beam_m = length_m * rng.random_range(0.25..0.38);
    let yaw = length_m * rng.random_range(0.16..0.25);
    let pitch = yaw * rng.random_range(0.97..1.10);
    let roll = (beam_m * rng.random_range(0.30_f64..0.42)).max(1.05 * (pitch - yaw).abs());
    True {
        mass_kg: 30.0 * f64::powf(length_m / 3.0, 3.0) * rng.random_range(0.6..1.7),
        length_m,
        beam_m,
        k_m: [roll, pitch, yaw],
        depth_m: pitch * rng.random_range(0.25..0.7),
        psi_deg: rng.random_range(-6.0..6.0),
    }
}

/// Told to a part of `off` of the truth.
fn told(rng: &mut ChaCha8Rng, value: f64, off: f64) -> Option<Quantity> {
    Some(Quantity::new(
        value * (1.0 + off * rng.random_range(-1.7..1.7)),
        off * value,
    ))
}

fn asked(rng: &mut ChaCha8Rng, hull: &True, wanted: &[&str]) -> Request {
    let means = Means {
        most_line_length_m: rng.random_range(2.0..5.0),
        u_line_length_m: rng.random_range(0.001..0.006),
        u_spacing_m: rng.random_range(0.0005..0.002),
        u_hull_pitch_deg: rng.random_range(0.1..0.3),
        gyro_noise_rad_s: rng.random_range(0.001..0.004),
        acc_noise_m_s2: rng.random_range(0.01..0.04),
        decay_s: rng.random_range(80.0..600.0),
        ..Means::default()
    };
    Request {
        title: "drawn".into(),
        hull: RoughHull {
            mass_kg: Some(hull.mass_kg),
            length_m: Some(hull.length_m),
            beam_m: Some(hull.beam_m),
            boat_type: None,
            k_yaw_m: told(rng, hull.k_m[2], 0.06),
            k_pitch_m: told(rng, hull.k_m[1], 0.06),
            k_roll_m: told(rng, hull.k_m[0], 0.1),
            cm_depth_m: told(rng, hull.depth_m, 0.1),
            psi_deg: None,
        },
        wanted: wanted.iter().map(|w| (*w).into()).collect(),
        means,
    }
}

fn quantity(q: Quantity) -> String {
    format!("{{ value = {:?}, u = {:?} }}", q.value, q.u)
}

/// A rig that swings the true hull as the plan says, everything stated off by chance within its
/// uncertainty.
fn rig(rng: &mut ChaCha8Rng, plan: &Plan, hull: &True) -> String {
    let means = &plan.means;
    let mut text = format!(
        "format = \"gyradius-rig/1\"\n[body]\nmass = {:?}\n[site]\ngravity = {}\n[truth]\ngravity_m_s2 = {:?}\nk_roll_m = {:?}\nk_pitch_m = {:?}\n\
         k_yaw_m = {:?}\ncm_depth_m = {:?}\npsi_deg = {:?}\nrate_hz = {:?}\nposition_x_m = {:?}\nposition_y_m = {:?}\nposition_z_m = {:?}\nturn_z_rad = {:?}\n",
        hull.mass_kg,
        quantity(means.gravity_m_s2),
        gauss(rng, means.gravity_m_s2),
        hull.k_m[0],
        hull.k_m[1],
        hull.k_m[2],
        hull.depth_m,
        hull.psi_deg,
        means.rate_hz,
        rng.random_range(-0.3..0.3) * hull.length_m,
        rng.random_range(-0.3..0.3) * hull.beam_m,
        rng.random_range(-0.2..0.1),
        rng.random_range(-0.6..0.6),
    );
    let tape =
        |rng: &mut ChaCha8Rng, known: &mut BTreeMap<String, f64>, name: &str, q: Quantity| {
            *known
                .entry(format!("{name} {:?}", q.value))
                .or_insert_with(|| gauss(rng, q))
        };
    let mut known = BTreeMap::new();
    for step in &plan.steps {
        let Step::Swing(swing) = step else { continue };
        let hung = &swing.suspension;
        let orientation = serde_json::to_string(&hung.orientation).unwrap();
        let (length, spacing) = (hung.line_length_m.unwrap(), hung.spacing_m.unwrap());
        let (true_length, true_spacing) = (
            tape(rng, &mut known, "length", length),
            tape(rng, &mut known, "spacing", spacing),
        );
        let pitch = hung.hull_pitch_deg.unwrap();
        let true_pitch = tape(rng, &mut known, "pitch", pitch);
        text += &format!(
            "[[swing]]\nid = \"{0}\"\nrecording = \"{0}.csv\"\nexcited = {1}\n[swing.suspension]\nkind = \"bifilar\"\norientation = {orientation}\n\
             line_length = {2}\nspacing = {3}\nhull_pitch_deg = {4}\n",
            swing.id,
            serde_json::to_string(&swing.excited).unwrap(),
            quantity(length),
            quantity(spacing),
            quantity(pitch),
        );
        if let Some(moved) = hung.points_moved_m {
            // The points are where the true hull hangs at the true tilt, read with the tape.
            let moved = Quantity::new(
                gauss(
                    rng,
                    Quantity::new(hull.depth_m * true_pitch.to_radians().tan(), moved.u),
                ),
                moved.u,
            );
            text += &format!("points_moved = {}\n", quantity(moved));
        }
        text += &format!(
            "[swing.truth]\nline_length_m = {true_length:?}\nspacing_m = {true_spacing:?}\ntop_spacing_m = {true_spacing:?}\nhull_pitch_deg = {true_pitch:?}\nduration_s = {:?}\n{}",
            swing.duration_s,
            release(swing, hull),
        );
    }
    let rate = 2.0 * hull.mass_kg / means.decay_s;
    let turn = hull.k_m.map(|k| rate * k * k);
    text + &format!(
        "[[effect]]\nid = \"linear_damping\"\nsurge_n_s_m = {rate:?}\nsway_n_s_m = {rate:?}\nroll_n_m_s = {:?}\npitch_n_m_s = {:?}\nyaw_n_m_s = {:?}\n\
         [[effect]]\nid = \"clock_scale\"\nerror = 1e-5\n[[effect]]\nid = \"white_noise\"\ngyro_rad_s = {:?}\nacc_m_s2 = {:?}\n",
        turn[0], turn[1], turn[2], means.gyro_noise_rad_s, means.acc_noise_m_s2
    )
}

/// How an operator lets go: the turn by the amplitude, the lines leaning by half of it or as a hull
/// that turns about its stern makes them.
fn release(swing: &PlannedSwing, hull: &True) -> String {
    let has = |e: Excitation| swing.excited.contains(&e);
    let length_m = swing.suspension.line_length_m.unwrap().value;
    let lean = |share: f64| length_m * (share * swing.amplitude_deg).to_radians().sin();
    let mut text = String::new();
    for (e, key) in [
        (Excitation::Yaw, "yaw_deg"),
        (Excitation::Pitch, "pitch_deg"),
        (Excitation::Roll, "roll_deg"),
    ] {
        if has(e) {
            text += &format!("{key} = {:?}\n", swing.amplitude_deg);
        }
    }
    let about_stern = (0.5 * hull.length_m * swing.amplitude_deg.to_radians()).min(lean(1.0));
    for (e, key) in [(Excitation::Sway, "sway_m"), (Excitation::Surge, "surge_m")] {
        if has(e) {
            let shift = if has(Excitation::Yaw) {
                about_stern
            } else if has(Excitation::Roll) {
                lean(0.5)
            } else {
                lean(1.0)
            };
            text += &format!("{key} = {shift:?}\n");
        }
    }
    text
}

fn gauss(rng: &mut ChaCha8Rng, q: Quantity) -> f64 {
    use rand_distr::{Distribution, StandardNormal};
    let z: f64 = StandardNormal.sample(rng);
    q.value + q.u * z
}

/// Predicted over achieved uncertainty, and the error over the predicted uncertainty, by quantity.
fn one(rng: &mut ChaCha8Rng, wanted: &[&str]) -> BTreeMap<QuantityName, (f64, f64)> {
    let hull = drawn(rng);
    let plan = plan(&asked(rng, &hull, wanted)).unwrap();
    let text = rig(rng, &plan, &hull);
    let practised = practise(&read_rig(&text, "drawn.toml").unwrap(), rng.random()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    save_practised(
        &practised,
        folder.path().join("s"),
        folder.path().join("t.json"),
        Overwrite::Refuse,
    )
    .unwrap();
    let found = measure(
        &load_session(folder.path().join("s")).unwrap(),
        &MeasureOptions::default(),
    )
    .unwrap();
    let truth = BTreeMap::from([
        ("k_roll_m", hull.k_m[0]),
        ("k_pitch_m", hull.k_m[1]),
        ("k_yaw_m", hull.k_m[2]),
        ("cm_depth_m", hull.depth_m),
        ("psi_deg", hull.psi_deg),
    ]);
    let mut ratios = BTreeMap::new();
    for (name, predicted) in &plan.quantities {
        let Some(u) = predicted.u else { continue };
        let Some(achieved) = found.quantities.get(name) else {
            println!(
                "  {name} was predicted ({u:.2e}) and not measured: {:?}",
                found.warnings
            );
            continue;
        };
        let (value, achieved_u) = (
            achieved.value.scalar().unwrap(),
            achieved.u.scalar().unwrap(),
        );
        ratios.insert(
            name.clone(),
            (u / achieved_u, (value - truth[name.as_str()]) / u),
        );
    }
    let ids: Vec<&str> = found
        .swings
        .iter()
        .filter(|s| !s.simulated)
        .map(|s| s.id.as_str())
        .collect();
    println!("  {:.1} m {ratios:.2?}, by lines: {ids:?}", hull.length_m);
    ratios
}

fn median(mut of: Vec<f64>) -> f64 {
    of.sort_by(f64::total_cmp);
    let n = of.len();
    if n % 2 == 1 {
        of[n / 2]
    } else {
        0.5 * (of[n / 2 - 1] + of[n / 2])
    }
}

fn medians(count: usize, wanted: &[&str]) -> BTreeMap<QuantityName, (usize, f64, f64)> {
    let mut rng = rng();
    let mut all: BTreeMap<QuantityName, Vec<(f64, f64)>> = BTreeMap::new();
    for _ in 0..count {
        for (name, ratio) in one(&mut rng, wanted) {
            all.entry(name).or_default().push(ratio);
        }
    }
    let of = |(name, ratios): (QuantityName, Vec<(f64, f64)>)| {
        let rms = (ratios.iter().map(|r| r.1 * r.1).sum::<f64>() / ratios.len() as f64).sqrt();
        (
            name,
            (
                ratios.len(),
                median(ratios.iter().map(|r| r.0).collect()),
                rms,
            ),
        )
    };
    all.into_iter().map(of).collect()
}

/// `make plan-check N=100`: hulls to draw.
fn asked_for() -> Option<usize> {
    std::env::var("GYRADIUS_PLAN_HULLS").ok()?.parse().ok()
}

/// The median over many hulls stays within 0.8 to 1.25. Single hulls scatter by a fifth or so,
/// mostly because the planner is told rough figures: that of a few is held to a range that a right
/// program leaves less than once in a thousand runs.
fn range(hulls: usize) -> (f64, f64) {
    if hulls >= 30 { (0.8, 1.25) } else { (0.5, 2.0) }
}

#[test]
fn what_is_predicted_is_achieved() {
    let hulls = asked_for().unwrap_or(8);
    let sets = [
        (&["k_yaw=0.1%", "k_pitch=0.3%"][..], 0.75),
        (
            &["k_yaw=0.1%", "k_pitch=0.5%", "k_roll=1%", "psi=1deg"],
            0.25,
        ),
    ];
    for (wanted, share) in sets {
        // Of fewer than three no median leaves one out that was measured badly.
        let count = ((hulls as f64 * share).round() as usize).max(3);
        let found = medians(count, wanted);
        for (name, (n, ratio, rms)) in &found {
            println!(
                "{name}: median of predicted over achieved {ratio:.3} of {n}; errors {rms:.2} predicted u (rms)"
            );
        }
        let is_asked = |name: &str| {
            wanted
                .iter()
                .any(|w| name.starts_with(w.split('=').next().unwrap()))
        };
        for (name, (n, ratio, _)) in found.iter().filter(|(name, _)| is_asked(name.as_str())) {
            let (least, most) = range(*n);
            assert!(
                (least..=most).contains(ratio),
                "{name}: {ratio} of {n} hulls"
            );
        }
        assert!(wanted.iter().all(|w| {
            found
                .keys()
                .any(|name| name.as_str().starts_with(w.split('=').next().unwrap()))
        }));
    }
}
