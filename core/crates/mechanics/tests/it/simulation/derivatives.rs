//! Derivatives of the motion against differences of it.

use gyradius_mechanics::effects::{EffectValues, catalogue};
use gyradius_mechanics::{Dual, Fineness, LANES, Moment, Path, Real, Scene, Start};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use crate::simulation::scenes::*;
use gyradius_test_support::rng;

/// An ordinary size of each number of an effect on the keelboat.
fn ordinary(id: &str, number: &str) -> f64 {
    match (id, number) {
        ("power_law_damping", "exponent") => 0.4,
        (_, "transition_rad_s") => 0.02,
        (_, "give_rad") => 0.02,
        (_, "strain_per_decade") => 1e-2,
        (_, "loaded_before_s") => 5.0,
        (_, "force_per_strain_n") => 3e5,
        (_, "delay_s") => 1e-3,
        (_, "linear_density_kg_m") => 0.5,
        ("support_compliance", "mass_kg") => 150.0,
        ("support_compliance", "stiffness_x_n_m" | "stiffness_y_n_m") => 5e4,
        ("internal_motion", "mass_kg") => 30.0,
        ("internal_motion", "stiffness_n_m") => 150.0,
        ("support_compliance", "damping_x_n_s_m" | "damping_y_n_s_m") => 400.0,
        (_, "seed") => 5.0,
        (_, "gust_time_s") => 4.0,
        (_, "gust_m_s") => 1.0,
        ("wind", "force_coefficient") => 4.0,
        ("wind", _) => 0.5,
        ("line_torsion", "neutral_rad") => 0.1,
        ("added_mass" | "buoyancy", name) if !name.ends_with("_m") => 3.0,
        ("internal_motion", name) if name.starts_with("start_") => 0.05,
        ("internal_motion", name) if !name.starts_with("place_") => 1.0,
        (_, "give_m") => 0.02,
        ("bearing_friction" | "presliding_bearing", _) => 3.0,
        ("knock" | "line_slip", "at_s" | "over_s") => 2.0,
        ("line_slip", _) => 0.05,
        ("knock", _) => 5.0,
        ("learned_force", "coordinate") => 3.0,
        ("learned_force", "scale_of_position" | "scale_of_rate") => 0.2,
        ("learned_force", _) => 5.0,
        (_, name) if ["excess_m", "difference_m", "forward_m", "to_port_m"].contains(&name) => 0.05,
        (_, name) if name.starts_with("place_") || name.starts_with("centre_") => 0.05,
        _ => 20.0,
    }
}

/// Whole numbers that choose something.
const CHOICES: [&str; 2] = ["seed", "coordinate"];

fn drawn(rng: &mut ChaCha8Rng, id: Option<&str>) -> Scene {
    let mut part = |size: f64| {
        size * rng.random_range(0.5..1.0) * if rng.random::<bool>() { 1.0 } else { -1.0 }
    };
    let start = Start {
        along_m: part(0.3),
        across_m: part(0.2),
        turn_rad: part(0.05),
        yaw_rad: part(0.2),
        along_m_s: part(0.2),
        across_m_s: part(0.2),
        turn_rad_s: part(0.1),
        yaw_rad_s: part(0.1),
    };
    let mut scene = keelboat(start);
    (scene.body.cm_x_m, scene.body.cm_y_m) = (part(0.05), part(0.05));
    (scene.body.inertia_xy_kg_m2, scene.body.inertia_xz_kg_m2) = (part(20.0), part(60.0));
    scene.body.inertia_yz_kg_m2 = part(20.0);
    scene.dimensions.top_spacing_m += part(0.1);
    if let Some(id) = id {
        let kind = catalogue().into_iter().find(|kind| kind.id == id).unwrap();
        let scale = part(1.0).abs();
        let value = |name: &'static str| {
            let size = ordinary(id, name);
            (
                name,
                if CHOICES.contains(&name) {
                    size
                } else {
                    scale * size
                },
            )
        };
        let numbers: Vec<_> = kind.numbers.iter().map(|n| value(n.name)).collect();
        scene.effects = vec![EffectValues::new(id, &numbers).unwrap()];
    }
    scene
}

fn read<S: Real>(m: &Moment<S>) -> [S; 6] {
    let (a, w) = (m.acceleration, m.rate);
    [a.x, a.y, a.z, w.x, w.y, w.z]
}

const TIMES: [f64; 6] = [0.05, 0.9, 1.7, 2.9, 3.8, 4.9];
const DURATION_S: f64 = 5.0;

/// Lengths of steps that a motion is read by, shares of what is asked.
const LENGTHS: [f64; 3] = [0.83, 1.0, 1.19];

/// The middle one of what steps of three lengths give: an acceleration read within a step across a
/// kink is off, by up to 5e-10 m/s² of what was drawn, which is a millionth of what a torque about
/// the roll axis does to it; it is so by one of them.
fn middle([a, b, c]: [Vec<f64>; 3]) -> Vec<f64> {
    a.iter()
        .zip(&b)
        .zip(&c)
        .map(|((a, b), c)| a.min(*b).max(a.max(*b).min(*c)))
        .collect()
}

/// Steps of another length.
fn with_steps(fineness: Fineness, length: f64) -> Fineness {
    Fineness {
        steps_per_period: fineness.steps_per_period / length,
        ..fineness
    }
}

/// Readings over all times as one list.
fn readings(scene: &Scene, values: &[f64], fineness: Fineness) -> Vec<f64> {
    let scene = scene.with_values(values).unwrap();
    middle(LENGTHS.map(|length| {
        let path = scene
            .motion_as(with_steps(fineness, length), DURATION_S)
            .unwrap();
        TIMES.iter().flat_map(|t| read(&path.at(*t))).collect()
    }))
}

/// Central differences at h, h/2 and h/4, extrapolated twice, and how far the two first
/// extrapolations are apart: what is left of the curvature, or rounding.
fn differences(scene: &Scene, i: usize, h: f64, fineness: Fineness) -> (Vec<f64>, f64) {
    let values = scene.values();
    let moved = |by: f64| {
        let mut moved = values.clone();
        moved[i] += by;
        readings(scene, &moved, fineness)
    };
    let central = |h: f64| -> Vec<f64> {
        moved(h)
            .iter()
            .zip(moved(-h))
            .map(|(a, b)| (a - b) / (2.0 * h))
            .collect()
    };
    let better = |fine: &[f64], coarse: &[f64], order: f64| -> Vec<f64> {
        fine.iter()
            .zip(coarse)
            .map(|(f, c)| f + (f - c) / (order - 1.0))
            .collect()
    };
    let [a, b, c] = [h, 0.5 * h, 0.25 * h].map(central);
    let (wide, narrow) = (better(&b, &a, 4.0), better(&c, &b, 4.0));
    (better(&narrow, &wide, 16.0), farthest(&narrow, &wide))
}

fn farthest(a: &[f64], b: &[f64]) -> f64 {
    a.iter()
        .zip(b)
        .fold(0.0f64, |worst, (x, y)| worst.max((x - y).abs()))
}

fn largest(a: &[f64]) -> f64 {
    a.iter().fold(0.0f64, |largest, x| largest.max(x.abs()))
}

/// The differences that agree best with themselves, and to what part of the largest: a wide step is
/// spoilt by curvature, a narrow one by rounding.
fn best_differences(scene: &Scene, i: usize, fineness: Fineness) -> (Vec<f64>, f64) {
    let value = scene.values()[i].abs().max(0.01);
    let mut best = (Vec::new(), f64::INFINITY);
    for part in [2e-2, 2e-1, 6e-3, 2e-3, 6e-4, 2e-4] {
        let (found, apart) = differences(scene, i, part * value, fineness);
        let unsure = apart / largest(&found);
        if unsure < best.1 {
            best = (found, unsure);
        }
        if best.1 < 1e-8 {
            break;
        }
    }
    best
}

/// Numbers that a bifilar scene does not have or that are not differentiated by.
const ASIDE: [&str; 4] = [
    "axis_height_m",
    "spread_m",
    "wind.seed",
    "learned_force.coordinate",
];
/// Derivatives are right to this part of their largest value.
const RIGHT_TO: f64 = 1e-6;
/// Across kinks, or so that the whole of a number is right to this, m/s² or rad/s: a step is not
/// halved for an error of 1e-14 m/s (`ROUNDING` of dynamics/path.rs), which over a step of some ms
/// is that much of an acceleration.
const ROUNDED_TO: f64 = 1e-11;
/// Differences that are known worse than to this cannot judge.
const KNOWN_TO: f64 = 2e-7;

/// What was found of the derivatives of a scene by its numbers.
#[derive(Default)]
struct Found {
    judged: usize,
    unjudged: Vec<String>,
    wrong: Vec<String>,
}

impl Found {
    fn judge(
        &mut self,
        name: &str,
        slopes: &[f64],
        (expected, unsure): (Vec<f64>, f64),
        right_to: f64,
    ) {
        let error = farthest(slopes, &expected) / largest(&expected);
        println!("    {name:40} {error:.1e}, differences known to {unsure:.1e}");
        self.judged += 1;
        if unsure > KNOWN_TO {
            self.unjudged.push(name.to_owned());
        } else if error > right_to {
            self.wrong.push(format!("{name} by {error:.1e}"));
        }
    }
}

fn compare(scene: &Scene, of_derivatives: Fineness, of_differences: Fineness, found: &mut Found) {
    let names = scene.names();
    let first = if scene.effects.is_empty() { 0 } else { 24 };
    let kinked = scene.effects.iter().any(|effect| effect.kind.kinked);
    let wanted: Vec<usize> = (first..names.len())
        .filter(|&i| !ASIDE.contains(&names[i].0.as_str()))
        .collect();
    let paths_by = |length| {
        scene.motion_and_derivatives(&wanted, with_steps(of_derivatives, length), DURATION_S)
    };
    let paths = LENGTHS.map(|length| paths_by(length).unwrap());
    for (n, &i) in wanted.iter().enumerate() {
        let (group, lane) = (n / LANES, n % LANES);
        let slopes_of = |paths: &Vec<Path<Dual<LANES>>>| -> Vec<f64> {
            TIMES
                .iter()
                .flat_map(|t| read(&paths[group].at(*t)).map(|x| x.slope[lane]))
                .collect()
        };
        let slopes = middle(paths.each_ref().map(slopes_of));
        let best = best_differences(scene, i, of_differences);
        let rounded_to = if kinked {
            ROUNDED_TO / influence(scene, i, &best.0)
        } else {
            0.0
        };
        found.judge(&names[i].0, &slopes, best, rounded_to.max(RIGHT_TO));
    }
}

/// Compares the derivatives by every number of the effects that are wanted.
fn compare_effects(kinked: bool, of_derivatives: Fineness, of_differences: Fineness) -> Found {
    let mut rng = rng();
    let mut found = Found::default();
    if !kinked {
        compare(
            &drawn(&mut rng, None),
            of_derivatives,
            of_differences,
            &mut found,
        );
    }
    for kind in catalogue().iter().filter(|kind| kind.kinked == kinked) {
        compare(
            &drawn(&mut rng, Some(kind.id)),
            of_derivatives,
            of_differences,
            &mut found,
        );
    }
    assert!(found.wrong.is_empty(), "{:?}", found.wrong);
    found
}

#[test]
fn derivatives_are_those_of_extrapolated_differences() {
    let of_differences = Fineness {
        steps_per_period: 80.0,
        ..Fineness::FULL
    };
    let found = compare_effects(false, Fineness::OF_DERIVATIVES, of_differences);
    assert!(
        found.judged > 60 && found.unjudged.len() < 3,
        "{:?}",
        found.unjudged
    );
}

/// A velocity that only just changes its sign leaves differences that know little: such numbers are
/// not judged.
#[test]
fn derivatives_across_kinks_are_those_of_extrapolated_differences() {
    let of_differences = Fineness {
        steps_per_period: 300.0,
        largest_error: 1e-14,
        most_halvings: 30,
        ..Fineness::FULL
    };
    let found = compare_effects(true, Fineness::OF_KINKED_DERIVATIVES, of_differences);
    assert!(
        found.judged > 25 && found.unjudged.len() < 9,
        "{:?}",
        found.unjudged
    );
}

/// Those that lead fits are taken over longer steps. Judged over two minutes by those of short
/// steps, which the differences above judge.
#[test]
fn derivatives_that_lead_fits_are_nearly_those_of_short_steps() {
    const LED_BY: f64 = 3e-2;
    // A tenth of the noise of a quiet phone.
    const UNSEEN: f64 = 5e-5;
    let mut rng = rng();
    let smooth = catalogue()
        .into_iter()
        .filter(|kind| !kind.kinked)
        .map(|kind| Some(kind.id));
    for id in [None].into_iter().chain(smooth) {
        let scene = drawn(&mut rng, id);
        let names = scene.names();
        let wanted: Vec<usize> = (0..names.len())
            .filter(|&i| !ASIDE.contains(&names[i].0.as_str()))
            .collect();
        let paths = |fineness| {
            scene
                .motion_and_derivatives(&wanted, fineness, 120.0)
                .unwrap()
        };
        let (short, long) = (
            paths(Fineness::OF_DERIVATIVES),
            paths(Fineness::OF_SLOPES_OF_FITS),
        );
        for (n, &i) in wanted.iter().enumerate() {
            let slopes = |path: &Path<Dual<LANES>>| -> Vec<f64> {
                (0..1200)
                    .flat_map(|k| read(&path.at(0.1 * f64::from(k))).map(|x| x.slope[n % LANES]))
                    .collect()
            };
            let [expected, found] = [&short, &long].map(|paths| slopes(&paths[n / LANES]));
            let error = farthest(&found, &expected) / largest(&expected);
            if influence(&scene, i, &expected) > UNSEEN {
                println!("    {:40} {error:.1e}", names[i].0);
                assert!(error < LED_BY, "{} by {error:.1e}", names[i].0);
            }
        }
    }
}

/// What the whole of a number (1 where it is zero) does to readings of these slopes by it, m/s² or
/// rad/s.
fn influence(scene: &Scene, i: usize, slopes: &[f64]) -> f64 {
    let size = scene.values()[i].abs();
    largest(slopes) * if size > 0.0 { size } else { 1.0 }
}

/// How many numbers have an influence, those that cannot be judged by differences, and what is
/// wrong. Judged over the first seconds; what a number without influence is said to do, at the end
/// of two minutes too.
fn compare_influences(scene: &Scene) -> Found {
    let of_differences = Fineness {
        steps_per_period: 80.0,
        ..Fineness::FULL
    };
    let wanted: Vec<usize> = (0..24)
        .filter(|&i| !ASIDE.contains(&scene.names()[i].0.as_str()))
        .collect();
    let paths = scene
        .motion_and_derivatives(&wanted, Fineness::OF_DERIVATIVES, 120.0)
        .unwrap();
    let mut found = Found::default();
    for (n, &i) in wanted.iter().enumerate() {
        let (name, _) = &scene.names()[i];
        let slopes_at = |t: &f64| read(&paths[n / LANES].at(*t)).map(|x| x.slope[n % LANES]);
        let slopes: Vec<f64> = TIMES.iter().flat_map(slopes_at).collect();
        let (expected, unsure) = best_differences(scene, i, of_differences);
        if influence(scene, i, &expected) > 1e-6 {
            found.judge(name, &slopes, (expected, unsure), RIGHT_TO);
        } else if influence(scene, i, &[slopes, slopes_at(&119.7).into()].concat()) > 1e-10 {
            found
                .wrong
                .push(format!("{name} is said to have an influence"));
        }
    }
    assert!(found.wrong.is_empty(), "{:?}", found.wrong);
    found
}

#[test]
fn numbers_without_influence_have_derivatives_of_zero() {
    // A hull that hangs still answers to what starts it and to a centre of mass that leaves its
    // line, nothing else.
    let at_rest = compare_influences(&keelboat(Start::default()));
    assert!(
        at_rest.judged == 9 && at_rest.unjudged.is_empty(),
        "{:?}",
        at_rest.unjudged
    );
    // One that yaws, not to what resists a pitch and a roll, nor to how deep its centre of mass
    // lies.
    let in_yaw = compare_influences(&keelboat(yawed(0.14)));
    assert!(
        in_yaw.judged == 18 && in_yaw.unjudged.len() < 2,
        "{:?}",
        in_yaw.unjudged
    );
}

#[test]
fn numbers_without_influence_are_no_burden_across_kinks() {
    let numbers = [("yaw_n_m", 3.0), ("transition_rad_s", 0.02)];
    let scene = with(keelboat(yawed(0.14)), "bearing_friction", &numbers);
    let wanted =
        ["inertia_xx_kg_m2", "inertia_yy_kg_m2", "cm_z_m"].map(|name| scene.index(name).unwrap());
    let paths = scene
        .motion_and_derivatives(&wanted, Fineness::OF_KINKED_DERIVATIVES, 60.0)
        .unwrap();
    for slopes in read(&paths[0].at(59.0)).map(|x| x.slope) {
        assert!(slopes.iter().all(|slope| slope.abs() < 1e-10), "{slopes:?}");
    }
}

/// What happens once may begin and end with jumps of its derivatives by its moment and length:
/// those of the motion are right at the steps of a fit, too, since pieces end there. Against
/// central differences.
#[test]
fn derivatives_by_a_moment_need_no_fine_steps() {
    let at_s = 3.37;
    let knocked = [
        ("at_s", at_s),
        ("over_s", 0.12),
        ("impulse_x_n_s", 20.0),
        ("turn_z_n_m_s", 15.0),
    ];
    let slipped = [("at_s", at_s), ("over_s", 0.2), ("positive_m", 4e-3)];
    for (id, numbers) in [("knock", &knocked[..]), ("line_slip", &slipped[..])] {
        let scene = with(keelboat(yawed(0.14)), id, numbers);
        for name in ["at_s", "over_s"] {
            let place = scene.index(&format!("{id}.{name}")).unwrap();
            let wanted = [place];
            let paths = scene.motion_and_derivatives(&wanted, Fineness::OF_FITS, 12.0);
            let path = &paths.unwrap()[0];
            let step = 1e-4;
            let moved = |by: f64| {
                let mut values = scene.values();
                values[place] += by;
                let there = scene.with_values(&values).unwrap();
                there.motion_as(Fineness::OF_FITS, 12.0).unwrap()
            };
            let (up, down) = (moved(step), moved(-step));
            // While it happens, and after it.
            for t_s in [at_s + 0.05, at_s + 1.0, 11.0] {
                let (above, below) = (read(&up.at(t_s)), read(&down.at(t_s)));
                let slopes = read(&path.at(t_s)).map(|x| x.slope[0]);
                let expected: Vec<f64> = (above.iter().zip(below))
                    .map(|(above, below)| (above - below) / (2.0 * step))
                    .collect();
                let most = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                for (slope, expected) in slopes.iter().zip(&expected) {
                    let away = (slope - expected).abs();
                    assert!(
                        away < 2e-3 * most,
                        "{id} {name} at {t_s} s: {slope} for {expected} of {most}"
                    );
                }
            }
        }
    }
}
