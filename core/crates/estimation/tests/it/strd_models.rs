//! The models of StRD's nonlinear regression problems, as their files write them.

use std::f64::consts::PI;

use super::dual::Dual;

/// A model of the parameters and one row's predictors.
pub type Model = fn(&[Dual], &[f64]) -> Dual;

/// Every problem with its model, in NIST's order: lower, average, higher difficulty.
pub const MODELS: [(&str, Model); 27] = [
    ("Misra1a", |b, x| b[0] * (1.0 - (-(b[1] * x[0])).exp())),
    ("Chwirut2", chwirut),
    ("Chwirut1", chwirut),
    ("Lanczos3", lanczos),
    ("Gauss1", gauss),
    ("Gauss2", gauss),
    ("DanWood", |b, x| b[0] * Dual::constant(x[0]).pow(b[1])),
    ("Misra1b", |b, x| {
        b[0] * (1.0 - (1.0 + b[1] * (x[0] / 2.0)).powf(-2.0))
    }),
    ("Kirby2", |b, x| ratio(&b[..3], &b[3..], x[0])),
    ("Hahn1", |b, x| ratio(&b[..4], &b[4..], x[0])),
    ("Nelson", |b, x| b[0] - b[1] * x[0] * (-(b[2] * x[1])).exp()),
    ("MGH17", |b, x| {
        b[0] + b[1] * (-(b[3] * x[0])).exp() + b[2] * (-(b[4] * x[0])).exp()
    }),
    ("Lanczos1", lanczos),
    ("Lanczos2", lanczos),
    ("Gauss3", gauss),
    ("Misra1c", |b, x| {
        b[0] * (1.0 - (1.0 + b[1] * (2.0 * x[0])).powf(-0.5))
    }),
    ("Misra1d", |b, x| b[0] * b[1] * x[0] / (1.0 + b[1] * x[0])),
    ("Roszman1", |b, x| {
        let angle = b[2] / (Dual::constant(x[0]) - b[3]);
        b[0] - b[1] * x[0] - angle.atan() * PI.recip()
    }),
    ("ENSO", |b, x| {
        let wave = |cos: Dual, sin: Dual, period: Dual| {
            let phase = Dual::constant(2.0 * PI * x[0]) / period;
            cos * phase.cos() + sin * phase.sin()
        };
        let year = wave(b[1], b[2], Dual::constant(12.0));
        b[0] + year + wave(b[4], b[5], b[3]) + wave(b[7], b[8], b[6])
    }),
    ("MGH09", |b, x| {
        let square = x[0] * x[0];
        b[0] * (square + b[1] * x[0]) / (square + b[2] * x[0] + b[3])
    }),
    ("Thurber", |b, x| ratio(&b[..4], &b[4..], x[0])),
    ("BoxBOD", |b, x| b[0] * (1.0 - (-(b[1] * x[0])).exp())),
    ("Rat42", |b, x| b[0] / (1.0 + (b[1] - b[2] * x[0]).exp())),
    ("MGH10", |b, x| b[0] * (b[1] / (x[0] + b[2])).exp()),
    ("Eckerle4", |b, x| {
        let away = (Dual::constant(x[0]) - b[2]) / b[1];
        b[0] / b[1] * (away.squared() * -0.5).exp()
    }),
    ("Rat43", |b, x| {
        let one = Dual::constant(1.0);
        b[0] / (1.0 + (b[1] - b[2] * x[0]).exp()).pow(one / b[3])
    }),
    ("Bennett5", |b, x| {
        let one = Dual::constant(1.0);
        b[0] * (b[1] + x[0]).pow(-(one / b[2]))
    }),
];

fn chwirut(b: &[Dual], x: &[f64]) -> Dual {
    (-(b[0] * x[0])).exp() / (b[1] + b[2] * x[0])
}

fn lanczos(b: &[Dual], x: &[f64]) -> Dual {
    let term = |k: usize| b[k] * (-(b[k + 1] * x[0])).exp();
    term(0) + term(2) + term(4)
}

fn gauss(b: &[Dual], x: &[f64]) -> Dual {
    let bell = |k: usize| {
        let away = (Dual::constant(x[0]) - b[k + 1]) / b[k + 2];
        b[k] * (-away.squared()).exp()
    };
    b[0] * (-(b[1] * x[0])).exp() + bell(2) + bell(5)
}

/// A polynomial over another that begins with 1.
fn ratio(above: &[Dual], below: &[Dual], x: f64) -> Dual {
    let polynomial = |b: &[Dual], first: i32| {
        let terms = b.iter().zip(first..).map(|(b, power)| *b * x.powi(power));
        terms.fold(Dual::constant(0.0), |sum, term| sum + term)
    };
    polynomial(above, 0) / (1.0 + polynomial(below, 1))
}
