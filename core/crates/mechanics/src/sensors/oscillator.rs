//! A damped oscillator that follows a given drive: ẍ + 2 ζ ω ẋ + ω² x = u(t), three axes alike.
//!
//! The solution by its impulse response h(t) = e^{−ζωt} sin(ω_d t) / ω_d, ω_d = ω √(1 − ζ²),
//! stepped on a grid of its own that is fine against ω; within a step ∫ h(t − s) u(s) ds by Gauss
//! and Legendre. A constant drive is met exactly.

use crate::real::{Real, V3};
use gyradius_base::error::{Error, Result};

/// ω times the length of a step.
const STEP: f64 = 0.5;
/// More steps than these are a slip of the pen.
const MOST_STEPS: f64 = 5e6;
/// Nodes and weights on 0 … 1 (order 8): the error of a step is STEP⁹/2e9 of the drive's.
const LEGENDRE: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

/// ω times the time over which the slope of a drive is taken.
const SLOPE: f64 = 1e-3;

/// Place and velocity.
type State<S> = (V3<S>, V3<S>);

/// What an impulse does by the end of a time: [h, h'] of one at its beginning and of one at each
/// node.
struct Responses<S> {
    whole: [S; 2],
    nodes: [[S; 2]; LEGENDRE.len()],
}

/// The oscillator along a drive.
pub struct Driven<S: Real, D> {
    drive: D,
    omega: S,
    zeta: S,
    from_s: f64,
    step_s: f64,
    knots: Vec<State<S>>,
}

impl<S: Real, D: Fn(S) -> V3<S>> Driven<S, D> {
    /// Follows the drive from `from_s`, before which it has followed for long what changed slowly
    /// or not at all; there the drive may jump, as where a held hull is let go.
    pub fn new((omega, zeta): (S, S), (from_s, to_s): (f64, f64), drive: D) -> Result<Self> {
        let step_s = STEP / omega.value();
        let count = ((to_s - from_s) / step_s).ceil().max(1.0);
        if count > MOST_STEPS {
            return Err(Error::argument(
                "frequency_rad_s",
                "a frequency that can be followed",
                omega.value(),
            ));
        }
        let mut driven = Self {
            drive,
            omega,
            zeta,
            from_s,
            step_s,
            knots: Vec::new(),
        };
        let mut state = driven.steady(S::constant(from_s.next_down()));
        let step = S::constant(step_s);
        let responses = driven.responses(step);
        for n in 0..count as usize {
            driven.knots.push(state);
            state = driven.after(n, step, &responses);
        }
        Ok(driven)
    }

    /// What has followed the drive for long, as fast as that changed: x = (u − 2 ζ u̇/ω − (1 − 4
    /// ζ²) ü/ω²) / ω² and its derivative, the series of the steady response in Ω/ω, Ω the drive's
    /// frequency, to the second order. The derivatives are those before `t_s`.
    fn steady(&self, t_s: S) -> State<S> {
        let back_s = SLOPE / self.omega.value();
        let [u, before, long_before] =
            [0.0, 1.0, 2.0].map(|n| (self.drive)(t_s - S::constant(n * back_s)));
        // Per radian of ω.
        let by = |x: V3<S>, n: i32| x.map(|x| x.scale(SLOPE.powi(-n)));
        let bend = by(u - before.map(|x| x.scale(2.0)) + long_before, 2);
        let slope = by(u - before, 1) + bend.map(|x| x.scale(0.5 * SLOPE));
        let twice_zeta = self.zeta.scale(2.0);
        let place = u - slope * twice_zeta - bend * (S::one() - twice_zeta * twice_zeta);
        let velocity = (slope - bend * twice_zeta) * self.omega;
        let square = self.omega * self.omega;
        (place / square, velocity / square)
    }

    /// The state so long after knot `n`.
    fn after(&self, n: usize, time: S, responses: &Responses<S>) -> State<S> {
        let begin = S::constant(self.from_s + n as f64 * self.step_s);
        let (x, v) = self.knots[n];
        let [response, rate] = responses.whole;
        // The free motion is x (h' + 2 ζ ω h) + v h; its derivative uses h'' = −2 ζ ω h' − ω² h.
        let damping = (self.zeta * self.omega).scale(2.0);
        let mut place = x * (rate + damping * response) + v * response;
        let mut velocity = v * rate - x * (self.omega * self.omega * response);
        for ((node, weight), [response, rate]) in LEGENDRE.into_iter().zip(responses.nodes) {
            let drive = (self.drive)(begin + time.scale(node)) * time.scale(weight);
            place += drive * response;
            velocity += drive * rate;
        }
        (place, velocity)
    }

    fn responses(&self, time: S) -> Responses<S> {
        let nodes = LEGENDRE.map(|(node, _)| self.impulse(time.scale(1.0 - node)));
        Responses {
            whole: self.impulse(time),
            nodes,
        }
    }

    /// h and its derivative.
    fn impulse(&self, time: S) -> [S; 2] {
        let ringing = self.omega * (S::one() - self.zeta * self.zeta).sqrt();
        let decay = self.zeta * self.omega;
        let left = (-(decay * time)).exp();
        let (sin, cos) = ((ringing * time).sin(), (ringing * time).cos());
        [left * sin / ringing, left * (cos - decay * sin / ringing)]
    }

    /// Place, velocity, acceleration.
    pub fn at(&self, t_s: S) -> [V3<S>; 3] {
        let since = t_s.value() - self.from_s;
        let (x, v) = if since <= 0.0 {
            self.steady(t_s)
        } else {
            let n = ((since / self.step_s) as usize).min(self.knots.len() - 1);
            let time = t_s - S::constant(self.from_s + n as f64 * self.step_s);
            self.after(n, time, &self.responses(time))
        };
        let damping = (self.zeta * self.omega).scale(2.0);
        [
            x,
            v,
            (self.drive)(t_s) - v * damping - x * (self.omega * self.omega),
        ]
    }
}
