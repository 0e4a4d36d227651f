//! How far the period of a longer record may still be from that of the record so far.
//!
//! Noise is the least of it. The period depends on the amplitude, and a longer record has a smaller
//! mean amplitude; and a motion close to the main one looks like a part of it until the record is
//! long enough to tell them apart. Both are systematic: they do not average out, and they are
//! bounded here.

/// Steps of the integrals over the envelope.
const STEPS: u32 = 200;
/// Relative change of a pendulum's frequency over the square of its amplitude in rad (first order
/// of the elliptic integral), taken until the data show a law of their own. A bifilar suspension
/// about as wide as twice the gyradius changes by less: 1/16 (1 − d²/L²), d half its spacing, L its
/// lines.
const PENDULUM: f64 = 1.0 / 16.0;
/// Least mean of E² or E, weighted by energy, that any longer record can come to: ∫E⁴/∫E² of a full
/// decay.
const LONGEST_MEAN: f64 = 0.5;

/// How a mode's amplitude falls: E' = −E(α + βE), E(0) = 1.
#[derive(Debug, Clone, Copy)]
pub(super) struct Envelope {
    pub alpha_per_s: f64,
    pub beta_per_s: f64,
}

impl Envelope {
    pub fn at(&self, t_s: f64) -> f64 {
        let x = self.alpha_per_s * t_s;
        let ramp_s = if x.abs() < 1e-8 {
            t_s
        } else {
            -(-x).exp_m1() / self.alpha_per_s
        };
        (-x).exp() / (1.0 + self.beta_per_s * ramp_s)
    }

    /// Decay rate at a moment, 1/s.
    pub fn decay_per_s(&self, t_s: f64) -> f64 {
        self.alpha_per_s + self.beta_per_s * self.at(t_s)
    }

    /// `∫ E² f(t, E) dt` over a span.
    fn integral(&self, span_s: f64, f: impl Fn(f64, f64) -> f64) -> f64 {
        let step_s = span_s / f64::from(STEPS);
        let at = |i: u32| {
            let t_s = (f64::from(i) + 0.5) * step_s;
            let envelope = self.at(t_s);
            envelope * envelope * f(t_s, envelope)
        };
        (0..STEPS).map(at).sum::<f64>() * step_s
    }

    /// Mean of E².
    pub fn mean_square(&self, span_s: f64) -> f64 {
        self.integral(span_s, |_, _| 1.0) / span_s
    }

    /// Mean of E^power weighted by energy.
    fn mean(&self, span_s: f64, power: u8) -> f64 {
        self.integral(span_s, |_, e| e.powi(i32::from(power))) / self.integral(span_s, |_, _| 1.0)
    }

    /// What a span says of a frequency: ∫E²(t − t̄)² dt, to which the inverse of its variance is
    /// proportional (Cramér–Rao bound with unknown phase).
    fn information(&self, span_s: f64) -> f64 {
        let mean_s = self.integral(span_s, |t, _| t) / self.integral(span_s, |_, _| 1.0);
        self.integral(span_s, |t, _| (t - mean_s).powi(2))
    }
}

/// The main motion: what its uncertainty follows from.
#[derive(Debug, Clone, Copy)]
pub(super) struct MainMode {
    pub omega_rad_s: f64,
    pub omega_se_rad_s: f64,
    pub envelope: Envelope,
    /// Angle at the start of the free swing, rad.
    pub angle_rad: f64,
    pub shift_rad_s: f64,
    /// 0 where the data show no law yet.
    pub law_power: u8,
    /// Size of the motion that the fit leaves, over that of the main one.
    pub misfit: f64,
}

/// What the uncertainty of the main frequency is made of, as it goes with the record.
#[derive(Debug, Clone, Copy)]
pub(super) struct Spread {
    envelope: Envelope,
    /// Noise: standard error of ω over the present span, rad/s, and what that span says of a
    /// frequency.
    noise_rad_s: f64,
    information: f64,
    /// Change of ω with amplitude at the start of the span, rad/s, and the power of the envelope
    /// that it follows.
    shift_rad_s: f64,
    power: u8,
    /// Size of the motion that the fit leaves, over that of the main one.
    misfit: f64,
}

impl Spread {
    pub fn of(main: &MainMode, span_s: f64) -> Self {
        let envelope = main.envelope;
        let pendulum_rad_s = PENDULUM * main.angle_rad.powi(2) * main.omega_rad_s;
        let (shift_rad_s, power) = match main.law_power {
            0 => (pendulum_rad_s, 2),
            power => (main.shift_rad_s, power),
        };
        let (noise_rad_s, information) = (main.omega_se_rad_s, envelope.information(span_s));
        Self {
            envelope,
            noise_rad_s,
            information,
            shift_rad_s,
            power,
            misfit: main.misfit,
        }
    }

    /// Standard uncertainty of ω that noise leaves in a record of this span, rad/s.
    pub fn noise_rad_s(&self, span_s: f64) -> f64 {
        self.noise_rad_s * (self.information / self.envelope.information(span_s)).sqrt()
    }

    /// Standard uncertainty of ω of the present span as that of any longer one, rad/s: noise, what
    /// is not told apart yet, and half of how far ω may drift, so that twice the uncertainty holds
    /// all of it.
    pub fn omega_u_rad_s(&self, span_s: f64) -> f64 {
        self.noise_rad_s(span_s)
            .hypot(0.5 * self.drift_rad_s(span_s))
            .hypot(self.unresolved_rad_s(span_s))
    }

    /// A motion that is left in the residual moves the phase of the main one by as much as its
    /// share, in rad; a straight line through phases that are off by r/√2 rms has a slope that is
    /// off by √12 r/√2 over the span.
    fn unresolved_rad_s(&self, span_s: f64) -> f64 {
        6_f64.sqrt() * self.misfit / span_s
    }

    /// How far ω of a longer record may go: the mean amplitude falls, at most to that of a full
    /// decay.
    fn drift_rad_s(&self, span_s: f64) -> f64 {
        let to_go = self.envelope.mean(span_s, self.power) - LONGEST_MEAN;
        self.shift_rad_s.abs() * to_go.max(0.0)
    }
}
