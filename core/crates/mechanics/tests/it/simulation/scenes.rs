//! Scenes that several tests use, and what is read off a motion.

use gyradius_base::constants::STANDARD_GRAVITY_M_S2 as G;
use gyradius_base::frames::{Mat3, Vec3};
use gyradius_mechanics::effects::EffectValues;
use gyradius_mechanics::{
    Body, Dimensions, Fineness, Hanging, Moment, Path, Scene, Start, SuspensionAxis,
};

/// Paper, Tables 1 and 4, d = 0.900 m.
pub const MASS_KG: f64 = 622.7;
pub const YAW_GYRADIUS_M: f64 = 1.0566;
pub const YAW_INERTIA: f64 = MASS_KG * YAW_GYRADIUS_M * YAW_GYRADIUS_M;
pub const LINE_M: f64 = 3.477;
pub const HALF_SPACING_M: f64 = 0.9;

pub fn body(mass_kg: f64, gyradii_m: [f64; 3], depth_m: f64) -> Body {
    let inertia = Mat3::from_diagonal(&Vec3::from(gyradii_m.map(|k| mass_kg * k * k)));
    Body::new(mass_kg, &inertia, &Vec3::new(0.0, 0.0, -depth_m))
}

pub fn bifilar(
    axis: SuspensionAxis,
    body: Body,
    line_length_m: f64,
    spacing_m: f64,
    start: Start,
) -> Scene {
    Scene {
        hanging: Hanging::Bifilar(axis),
        body,
        dimensions: Dimensions {
            line_length_m,
            spacing_m,
            top_spacing_m: spacing_m,
            gravity_m_s2: G,
            ..Dimensions::default()
        },
        start,
        effects: Vec::new(),
    }
}

/// The paper's keelboat, athwartships.
pub fn keelboat(start: Start) -> Scene {
    let hull = body(MASS_KG, [0.625, 1.156, YAW_GYRADIUS_M], 0.4);
    bifilar(
        SuspensionAxis::Athwartships,
        hull,
        LINE_M,
        2.0 * HALF_SPACING_M,
        start,
    )
}

/// Paper, Fig. 15: k_p = 352, k_y = 303, l2 = 253, d = 280 mm.
pub fn model_hull(axis: SuspensionAxis, line_length_m: f64, start: Start) -> Scene {
    bifilar(
        axis,
        body(13.18, [0.204, 0.352, 0.303], 0.253),
        line_length_m,
        0.56,
        start,
    )
}

pub fn with(mut scene: Scene, id: &str, numbers: &[(&str, f64)]) -> Scene {
    scene.effects.push(EffectValues::new(id, numbers).unwrap());
    scene
}

pub fn yawed(yaw_rad: f64) -> Start {
    Start {
        yaw_rad,
        ..Start::default()
    }
}

/// A keelboat displaced along the axis, so that its lines hang at `angle_rad`.
pub fn swayed(angle_rad: f64) -> Start {
    Start {
        along_m: LINE_M * angle_rad.sin(),
        ..Start::default()
    }
}

pub fn heading(moment: &Moment<f64>) -> f64 {
    let turn = moment.turn();
    (turn[(1, 0)] - turn[(0, 1)]).atan2(turn[(0, 0)] + turn[(1, 1)])
}

/// Turn about the hull's y axis where nothing else turns.
pub fn pitch(moment: &Moment<f64>) -> f64 {
    2.0 * moment.attitude[2].atan2(moment.attitude[0])
}

/// The same about x.
pub fn roll(moment: &Moment<f64>) -> f64 {
    2.0 * moment.attitude[1].atan2(moment.attitude[0])
}

/// Zeros of `f` along the motion.
pub fn zeros(path: &Path<f64>, f: impl Fn(&Moment<f64>) -> f64) -> Vec<f64> {
    let at = |t: f64| f(&path.at(t));
    let (h, count) = (0.02, (path.duration_s() / 0.02) as usize);
    let zero = |mut a: f64, mut b: f64| {
        let (mut fa, mut fb) = (at(a), at(b));
        for _ in 0..60 {
            // Illinois' false position.
            let c = (a * fb - b * fa) / (fb - fa);
            let fc = at(c);
            if fc == 0.0 || (b - a).abs() < 1e-14 {
                return c;
            }
            if fc * fb < 0.0 {
                (a, fa) = (b, fb);
            } else {
                fa *= 0.5;
            }
            (b, fb) = (c, fc);
        }
        b
    };
    let between = |n: usize| (n as f64 * h, (n + 1) as f64 * h);
    let crosses = |&(a, b): &(f64, f64)| at(a) * at(b) < 0.0;
    (0..count)
        .map(between)
        .filter(crosses)
        .map(|(a, b)| zero(a, b))
        .collect()
}

/// From the first to the last zero.
pub fn period_s(path: &Path<f64>, f: impl Fn(&Moment<f64>) -> f64) -> f64 {
    let at = zeros(path, f);
    2.0 * (at[at.len() - 1] - at[0]) / (at.len() - 1) as f64
}

pub fn assert_close(found: f64, expected: f64, relative: f64) {
    assert!(
        (found / expected - 1.0).abs() <= relative,
        "{found} against {expected}"
    );
}

/// Classical Runge–Kutta of order 4 in steps so small that kinks do not matter: the equations of
/// one coordinate that the simulation is held against share no code with it. `seen` gets time and
/// state at every multiple of `every_s`.
pub fn runge_kutta<const N: usize>(
    mut y: [f64; N],
    duration_s: f64,
    every_s: f64,
    slope: impl Fn(f64, &[f64; N]) -> [f64; N],
    mut seen: impl FnMut(f64, &[f64; N]),
) {
    const SUBSTEPS: usize = 2000;
    let h = every_s / SUBSTEPS as f64;
    let moved = |y: &[f64; N], k: &[f64; N], by: f64| {
        let mut out = *y;
        out.iter_mut().zip(k).for_each(|(o, k)| *o += by * k);
        out
    };
    for n in 0..=(duration_s / every_s) as usize {
        seen(n as f64 * every_s, &y);
        for i in 0..SUBSTEPS {
            let t = (n * SUBSTEPS + i) as f64 * h;
            let k1 = slope(t, &y);
            let k2 = slope(t + 0.5 * h, &moved(&y, &k1, 0.5 * h));
            let k3 = slope(t + 0.5 * h, &moved(&y, &k2, 0.5 * h));
            let k4 = slope(t + h, &moved(&y, &k3, h));
            for j in 0..N {
                y[j] += h / 6.0 * (k1[j] + 2.0 * (k2[j] + k3[j]) + k4[j]);
            }
        }
    }
}

/// Angular acceleration of a pure yaw of the keelboat on parallel lines under a torque, heave
/// included: (I + a + m z'²) ψ̈ + m z' z'' ψ̇² + m g z' = M, z = −√(l² − 4 d² sin²(ψ/2)), a an
/// inertia that is added.
pub fn yaw_acceleration(psi: f64, rate: f64, torque: f64, added: f64) -> f64 {
    let d2 = HALF_SPACING_M * HALF_SPACING_M;
    let h = (LINE_M * LINE_M - 4.0 * d2 * (0.5 * psi).sin().powi(2)).sqrt();
    let first = d2 * psi.sin() / h;
    let second = d2 * psi.cos() / h + first * first / h;
    let forces = MASS_KG * first * (G + second * rate * rate);
    (torque - forces) / (YAW_INERTIA + added + MASS_KG * first * first)
}

/// Largest difference of the simulated heading from that of a pure yaw with memory `z` under the
/// torque and added inertia given by `law(t, heading, rate, z)`, whose last number is the rate of
/// the memory.
pub fn worst_yaw(
    scene: &Scene,
    duration_s: f64,
    law: impl Fn(f64, f64, f64, f64) -> [f64; 3],
) -> f64 {
    worst_yaw_as(Fineness::FULL, scene, duration_s, law)
}

/// The same of a motion computed so finely.
pub fn worst_yaw_as(
    fineness: Fineness,
    scene: &Scene,
    duration_s: f64,
    law: impl Fn(f64, f64, f64, f64) -> [f64; 3],
) -> f64 {
    let path = scene.motion_as(fineness, duration_s).unwrap();
    let mut worst = 0.0f64;
    let slope = |t: f64, y: &[f64; 3]| {
        let [torque, added, memory] = law(t, y[0], y[1], y[2]);
        [y[1], yaw_acceleration(y[0], y[1], torque, added), memory]
    };
    let start = [scene.start.yaw_rad, scene.start.yaw_rad_s, 0.0];
    runge_kutta(start, duration_s, 0.1, slope, |t, y| {
        worst = worst.max((heading(&path.at(t)) - y[0]).abs());
    });
    println!(
        "{:?}: worst heading {worst:.1e} rad",
        scene.effects.last().map(|e| e.kind.id)
    );
    worst
}
