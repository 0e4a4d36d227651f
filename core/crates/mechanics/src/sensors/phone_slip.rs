//! A phone that slips on the hull.

use super::effect::{OwnMotion, Ride, SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::phone::Offset;
use crate::real::{Real, V3};
use gyradius_base::error::{Error, Result};

numbers! {
    /// From `at_s` on, over `over_s`, the phone turns by θ about an axis fixed in it and shifts by
    /// d: both times s(u) = u³ (10 − 15 u + 6 u²), the fifth-degree step with no rate and no
    /// acceleration at its ends. What the slip itself turns and accelerates is felt.
    pub struct PhoneSlip {
        /// Start.
        at_s: "s",
        /// Length.
        over_s: "s",
        /// θ, phone axes.
        turn_x_rad: "rad",
        /// θ, phone axes.
        turn_y_rad: "rad",
        /// θ, phone axes.
        turn_z_rad: "rad",
        /// d, hull axes.
        shift_x_m: "m",
        /// d, hull axes.
        shift_y_m: "m",
        /// d, hull axes.
        shift_z_m: "m",
    }
}

impl<S> SensorDescribed for PhoneSlip<S> {
    const ID: &'static str = "phone_slip";
}

/// s(u) with its first and second derivative.
fn step<S: Real>(u: S) -> [S; 3] {
    if u.value() <= 0.0 {
        return [S::zero(); 3];
    }
    if u.value() >= 1.0 {
        return [S::one(), S::zero(), S::zero()];
    }
    let left = S::one() - u;
    let s = u * u * u * (S::constant(10.0) - u.scale(15.0) + (u * u).scale(6.0));
    [
        s,
        (u * u * left * left).scale(30.0),
        (u * left * (left - u)).scale(60.0),
    ]
}

impl<S: Real> SensorEffect<S> for PhoneSlip<S> {
    fn check(&self) -> Result<()> {
        let over_s = self.over_s.value();
        if over_s > 0.0 {
            Ok(())
        } else {
            Err(Error::argument("phone_slip", "`over_s` above 0", over_s))
        }
    }
    fn own_motion<'a>(&'a self, _ride: &'a Ride<'a, S>) -> Result<Option<OwnMotion<'a, S>>> {
        let turn = V3::new(self.turn_x_rad, self.turn_y_rad, self.turn_z_rad);
        let shift = V3::new(self.shift_x_m, self.shift_y_m, self.shift_z_m);
        Ok(Some(Box::new(move |t: S| {
            let [s, rate, bend] = step((t - self.at_s) / self.over_s);
            let (rate, bend) = (rate / self.over_s, bend / (self.over_s * self.over_s));
            Offset {
                shift: shift * s,
                shift_rate: shift * rate,
                shift_acceleration: shift * bend,
                turn: turn * s,
                turn_rate: turn * rate,
            }
        })))
    }
}
