//! Speed of the simulation: small modes and a 120 s swing at 100 Hz.
#![allow(clippy::unwrap_used, missing_docs)]

use criterion::{Criterion, criterion_group, criterion_main};
use gyradius_core::constants::STANDARD_GRAVITY_M_S2;
use gyradius_core::mechanics::{
    Damping, ModalPart, Rig, RigidBody, Sampling, SuspensionAxis, initial_state, simulate,
    small_modes,
};
use gyradius_core::frames::Vec3;

fn keelboat() -> (Rig, RigidBody) {
    let rig = Rig::bifilar(
        SuspensionAxis::Athwartships,
        3.477,
        1.8,
        1.8,
        STANDARD_GRAVITY_M_S2,
    )
    .unwrap();
    (
        rig,
        RigidBody::from_gyradii(622.7, [0.625, 1.156, 1.0566], Vec3::new(0.0, 0.0, -0.4)),
    )
}

fn small(c: &mut Criterion) {
    let (rig, body) = keelboat();
    c.bench_function("small_modes", |b| {
        b.iter(|| small_modes(&rig, &body).unwrap())
    });
}

fn motion(c: &mut Criterion) {
    let (rig, body) = keelboat();
    let modes = small_modes(&rig, &body).unwrap();
    let parts = [0, 1, 2, 3].map(|mode| ModalPart {
        mode,
        amplitude: 1.0,
        phase_rad: 0.4,
    });
    let start = initial_state(&rig, &body, &modes, &parts).unwrap();
    let sampling = Sampling {
        duration_s: 120.0,
        interval_s: 0.01,
        step_s: None,
    };
    let damping = Damping {
        force_n_s_m: Vec3::repeat(1.0),
        torque_n_m_s: Vec3::repeat(1.0),
    };
    c.bench_function("motion_120_s", |b| {
        b.iter(|| simulate(&rig, &body, &damping, &start, &sampling).unwrap())
    });
}

criterion_group!(benches, small, motion);
criterion_main!(benches);
