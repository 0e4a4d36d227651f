//! A phone on a mount that gives.

use super::effect::{OwnMotion, Ride, SensorDescribed, SensorEffect};
use crate::numbers::numbers;
use crate::phone::Offset;
use crate::real::{Real, V3};
use gyradius_base::error::{Error, Result};

use super::oscillator::Driven;

numbers! {
    /// The phone is light against the hull and hangs in a spring and damper, alike along and about
    /// all axes: against the hull it turns by θ̈ + 2 ζ ω θ̇ + ω² θ = −α and shifts by d̈ + 2 ζ ω ḋ
    /// + ω² d = −f, with the hull's angular acceleration α and the specific force f at the phone's
    /// place (base excitation of an oscillator: e.g. D. J. Inman, *Engineering Vibration*, sec.
    /// 2.4). θ is small. A frequency of 0 leaves its part out. On a hull that was held the phone
    /// begins at rest; on one that swings already it has followed for long.
    pub struct PhoneMountResonance {
        /// ω / 2π of the turn.
        turn_hz: "Hz",
        /// ω / 2π of the shift.
        shift_hz: "Hz",
        /// ζ, below 1.
        damping_ratio: "1",
        /// Where the mount turns about one axis only: that axis n, phone axes, of any size (0:
        /// about all).
        axis_x: "1",
        /// The same.
        axis_y: "1",
        /// The same.
        axis_z: "1",
        /// Share of the hull's turning about that axis that drives it: 1 for a mount, anything for
        /// its parts alone.
        turning_share: "1",
        /// h, phone axes: height of the phone's centre of mass above the axis over its squared
        /// gyradius about it. The turn is then driven by −n·(h × (f − f₀)) too, f₀ the specific
        /// force at rest.
        lever_x_per_m: "1/m",
        /// The same.
        lever_y_per_m: "1/m",
        /// The same.
        lever_z_per_m: "1/m",
    }
}

impl<S> SensorDescribed for PhoneMountResonance<S> {
    const ID: &'static str = "phone_mount_resonance";
}

impl<S: Real> PhoneMountResonance<S> {
    fn driven<D: Fn(S) -> V3<S>>(
        &self,
        frequency_hz: S,
        ride: &Ride<'_, S>,
        drive: D,
    ) -> Result<Option<Driven<S, D>>> {
        if frequency_hz.value() == 0.0 {
            return Ok(None);
        }
        let omega = frequency_hz.scale(std::f64::consts::TAU);
        Driven::new((omega, self.damping_ratio), (ride.from_s, ride.to_s), drive).map(Some)
    }
}

impl<S: Real> SensorEffect<S> for PhoneMountResonance<S> {
    fn check(&self) -> Result<()> {
        let slowest = self.turn_hz.value().min(self.shift_hz.value());
        if slowest < 0.0 {
            return Err(Error::argument(
                "phone_mount_resonance",
                "frequencies of 0 or above",
                slowest,
            ));
        }
        let zeta = self.damping_ratio.value();
        if !(0.0..1.0).contains(&zeta) {
            return Err(Error::argument(
                "phone_mount_resonance",
                "`damping_ratio` from 0 to below 1",
                zeta,
            ));
        }
        Ok(())
    }

    fn own_motion<'a>(&'a self, ride: &'a Ride<'a, S>) -> Result<Option<OwnMotion<'a, S>>> {
        let axis = V3::new(self.axis_x, self.axis_y, self.axis_z);
        let lever = V3::new(self.lever_x_per_m, self.lever_y_per_m, self.lever_z_per_m);
        let (has_axis, square) = (axis.dot(&axis).value() > 0.0, axis.dot(&axis));
        let to_phone = *ride.mounted.phone_from_hull();
        let at_rest = to_phone * V3::new(S::zero(), S::zero(), ride.mounted.gravity());
        let turning = move |t: S| {
            let hull = (ride.hull)(t);
            let turning = to_phone * hull.angular_acceleration;
            if !has_axis {
                return -turning;
            }
            let force = to_phone * ride.mounted.force_at_place(&hull) - at_rest;
            -axis * (axis.dot(&(turning * self.turning_share + lever.cross(&force))) / square)
        };
        let shifting = move |t: S| -ride.mounted.force_at_place(&(ride.hull)(t));
        let turn = self.driven(self.turn_hz, ride, turning)?;
        let shift = self.driven(self.shift_hz, ride, shifting)?;
        Ok(Some(Box::new(move |t: S| {
            let still = || [V3::zeros(); 3];
            let [turn, turn_rate, _] = turn.as_ref().map_or_else(still, |turn| turn.at(t));
            let [shift, shift_rate, shift_acceleration] =
                shift.as_ref().map_or_else(still, |shift| shift.at(t));
            Offset {
                shift,
                shift_rate,
                shift_acceleration,
                turn,
                turn_rate,
            }
        })))
    }
}
