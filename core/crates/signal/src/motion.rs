//! One mode's motion and how it depends on the mode's parameters.
//!
//! # Conventions
//! `z(τ) = E(τ) exp(iφ(τ))`, `E' = −E(α + βE)`, `φ' = ω + shift·E^power`, `z(0) = 1`. In closed
//! form, with `u = (1 − e^{−ατ})/α`: `E = e^{−ατ}/(1 + βu)`; `∫E = ln(1 + βu)/β`; `∫E² = ((1 +
//! α/β)(1 − 1/(1 + βu)) − (α/β) ln(1 + βu))/β`.

use num_complex::Complex64;

/// Parameters of a mode, per span.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Motion {
    pub omega: f64,
    pub alpha: f64,
    pub law: Option<Law>,
}

/// Its dependence on amplitude.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Law {
    pub shift: f64,
    pub beta: f64,
    pub power: u8,
}

/// Logarithm of z, its time derivative, and its derivatives by (ω, α, shift, β).
#[derive(Debug, Clone, Copy)]
pub(super) struct MotionAt {
    pub log: Complex64,
    pub rate: Complex64,
    pub slopes: [Complex64; 4],
}

impl Motion {
    pub fn plain(omega: f64, alpha: f64) -> Self {
        Self {
            omega,
            alpha,
            law: None,
        }
    }

    pub fn parameter_count(&self) -> usize {
        if self.law.is_some() { 4 } else { 2 }
    }

    pub fn parameters(&self) -> Vec<f64> {
        let law = self.law.map(|law| [law.shift, law.beta]);
        [self.omega, self.alpha]
            .into_iter()
            .chain(law.into_iter().flatten())
            .collect()
    }

    pub fn with_parameters(&self, p: &[f64]) -> Self {
        let law = self.law.map(|law| Law {
            shift: p[2],
            beta: p[3],
            power: law.power,
        });
        Self {
            omega: p[0],
            alpha: p[1],
            law,
        }
    }

    /// Whether the envelope stays finite over the span.
    pub fn is_sound(&self) -> bool {
        let beta = self.law.map_or(0.0, |law| law.beta);
        let turned = 1.0 + beta * ramp(self.alpha, 1.0);
        self.omega > 0.0
            && self.alpha.abs() < 0.7 * self.omega + 5.0
            && turned > 0.02
            && turned.is_finite()
    }

    /// Envelope E(τ).
    pub fn envelope(&self, tau: f64) -> f64 {
        let beta = self.law.map_or(0.0, |law| law.beta);
        (-self.alpha * tau).exp() / (1.0 + beta * ramp(self.alpha, tau))
    }

    pub fn at(&self, tau: f64) -> MotionAt {
        let i = Complex64::i();
        let Some(law) = self.law else {
            let rate = Complex64::new(-self.alpha, self.omega);
            let zero = Complex64::ZERO;
            return MotionAt {
                log: rate * tau,
                rate,
                slopes: [i * tau, Complex64::from(-tau), zero, zero],
            };
        };
        let (alpha, beta) = (self.alpha, law.beta);
        let decay = (-alpha * tau).exp();
        let (u, by_alpha) = (ramp(alpha, tau), ramp_slope(alpha, tau, decay));
        let turned = 1.0 + beta * u;
        let (envelope, log_turned) = (decay / turned, (beta * u).ln_1p());
        let swept = Swept::of(alpha, beta, u, log_turned, law.power);
        let along = (decay / (turned * turned), 1.0 / turned);
        let swept_by_alpha =
            swept.by_alpha + by_alpha * if law.power == 1 { along.1 } else { along.0 };
        MotionAt {
            log: Complex64::new(
                -alpha * tau - log_turned,
                self.omega * tau + law.shift * swept.value,
            ),
            rate: Complex64::new(
                -alpha - beta * envelope,
                self.omega + law.shift * envelope.powi(i32::from(law.power)),
            ),
            slopes: [
                i * tau,
                Complex64::new(-tau - beta * by_alpha / turned, law.shift * swept_by_alpha),
                i * swept.value,
                Complex64::new(-u / turned, law.shift * swept.by_beta),
            ],
        }
    }
}

/// u = (1 − e^{−ατ})/α.
fn ramp(alpha: f64, tau: f64) -> f64 {
    let x = alpha * tau;
    if x.abs() < 1e-8 {
        tau * (1.0 - 0.5 * x)
    } else {
        -(-x).exp_m1() / alpha
    }
}

/// ∂u/∂α.
fn ramp_slope(alpha: f64, tau: f64, decay: f64) -> f64 {
    let x = alpha * tau;
    if x.abs() < 1e-3 {
        return -tau * tau * (0.5 - x * (1.0 / 3.0 - 0.125 * x));
    }
    (tau * decay - ramp(alpha, tau)) / alpha
}

/// ∫₀^τ E^power = ∫₀^u g(v) dv with `g = 1/(1 + βv)` (power 1) or `(1 − αv)/(1 + βv)²` (power 2),
/// and its derivatives at constant u.
struct Swept {
    value: f64,
    by_alpha: f64,
    by_beta: f64,
}

impl Swept {
    fn of(alpha: f64, beta: f64, u: f64, log_turned: f64, power: u8) -> Self {
        let x = beta * u;
        // Below 0.05 the closed forms cancel.
        let [one, first, second] = if x.abs() < 0.05 {
            moments_series(beta, u)
        } else {
            moments(beta, u, log_turned)
        };
        let turned = 1.0 + x;
        if power == 1 {
            return Self {
                value: one,
                by_alpha: 0.0,
                by_beta: -first,
            };
        }
        // ∫(1 − αv)/(1 + βv)² = u/(1 + βu) − α∫v/(1 + βv)².
        Self {
            value: u / turned - alpha * first,
            by_alpha: -first,
            by_beta: -(u / turned).powi(2) + 2.0 * alpha * second,
        }
    }
}

/// ∫₀^u of 1/(1 + βv), v/(1 + βv)² and v²/(1 + βv)³.
fn moments(beta: f64, u: f64, log_turned: f64) -> [f64; 3] {
    let q = 1.0 + beta * u;
    let first = (log_turned - beta * u / q) / (beta * beta);
    let second = (log_turned + 2.0 / q - 0.5 / (q * q) - 1.5) / beta.powi(3);
    [log_turned / beta, first, second]
}

/// The same term by term, for small βu.
fn moments_series(beta: f64, u: f64) -> [f64; 3] {
    let (mut sums, mut power) = ([0.0; 3], u);
    for k in 0..12 {
        let n = f64::from(k);
        sums[0] += power / (n + 1.0);
        sums[1] += (n + 1.0) * power * u / (n + 2.0);
        sums[2] += 0.5 * (n + 1.0) * (n + 2.0) * power * u * u / (n + 3.0);
        power *= -beta * u;
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against numerical integration of the differential equations (midpoint rule, 20 000 steps).
    #[test]
    fn closed_forms_solve_the_equations() {
        for (alpha, beta, power) in [
            (1.3, 0.8, 2),
            (1.3, 0.01, 2),
            (0.0, 2.0, 2),
            (-0.2, 0.6, 1),
            (2.0, 0.0, 1),
        ] {
            let motion = Motion {
                omega: 40.0,
                alpha,
                law: Some(Law {
                    shift: -3.0,
                    beta,
                    power,
                }),
            };
            let (mut envelope, mut phase, steps) = (1.0_f64, 0.0, 20_000);
            let h = 1.0 / f64::from(steps);
            for _ in 0..steps {
                let middle = envelope * (1.0 - 0.5 * h * (alpha + beta * envelope));
                envelope -= h * middle * (alpha + beta * middle);
                phase += h * (40.0 - 3.0 * middle.powi(i32::from(power)));
            }
            let log = motion.at(1.0).log;
            assert!(
                (log.re - envelope.ln()).abs() < 1e-7,
                "{alpha} {beta}: {} {}",
                log.re,
                envelope.ln()
            );
            assert!(
                (log.im - phase).abs() < 1e-6,
                "{alpha} {beta}: {} {phase}",
                log.im
            );
        }
    }
    /// Central differences of the logarithm, which the first test holds.
    #[test]
    fn slopes_are_the_derivatives() {
        for (alpha, beta, power) in [
            (1.3, 0.8, 2),
            (1.3, 0.01, 2),
            (1e-5, 2.0, 2),
            (-0.2, -0.3, 1),
            (2.0, 0.0, 1),
            (0.4, 0.0, 2),
        ] {
            let motion = Motion {
                omega: 40.0,
                alpha,
                law: Some(Law {
                    shift: -3.0,
                    beta,
                    power,
                }),
            };
            let at = motion.at(0.7);
            let p = motion.parameters();
            for (i, slope) in at.slopes.iter().enumerate() {
                let moved = |h: f64| {
                    let mut p = p.clone();
                    p[i] += h;
                    motion.with_parameters(&p).at(0.7).log
                };
                let difference = (moved(1e-5) - moved(-1e-5)) / 2e-5;
                assert!(
                    (difference - slope).norm() < 1e-7,
                    "{alpha} {beta} {power} {i}: {difference} {slope}"
                );
            }
        }
    }
}
