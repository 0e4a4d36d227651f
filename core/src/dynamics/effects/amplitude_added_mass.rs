//! Air that moves with the hull, the more the wider it swings.

use super::{AddedMass, Described, Effect, Now};
use crate::dynamics::numbers::numbers;
use crate::dynamics::real::{Real, V3};
use crate::dynamics::suspended::Suspended;

numbers! {
    /// F = −a A v̇ along x and y, M = −a A ω̇ about y and z: Morison's inertia with a coefficient in proportion to the
    /// amplitude A, as the Keulegan–Carpenter number (2π A over the breadth) has it.
    ///
    /// The amplitude is taken from the moment: A² = x² + (v/ω₀)², with x the heading, or the displacement of the centre
    /// of mass from below the mid-point of the upper ends along the hull's x or y; ω₀² = K/I_zz for the turn (K the
    /// stiffness that the lines give it at rest), g over the drop of the lines for the displacements; for the pitch, g over
    /// the length r + I_yy/(m r) of the pendulum that line and hull make, r = drop + depth. Along a harmonic
    /// swing of the base model A is constant. (G. H. Keulegan and L. H. Carpenter, J. Res. NBS 60 (1958) 423; paper,
    /// "Air damping".)
    pub struct AmplitudeAddedMass {
        /// Along x, for each metre of amplitude.
        surge_kg_m: "kg/m",
        /// Along y, for each metre of amplitude.
        sway_kg_m: "kg/m",
        /// About y, for each radian of amplitude.
        pitch_kg_m2_rad: "kg m^2/rad",
        /// About z, for each radian of amplitude.
        yaw_kg_m2_rad: "kg m^2/rad",
    }
}

impl<S> Described for AmplitudeAddedMass<S> {
    const ID: &'static str = "amplitude_added_mass";
    const SENTENCE: &'static str = "the wider the swing, the more air moves with the hull: the period grows in proportion to the amplitude";
}

/// Height of the lines and Σ b·t over their number, b and t the horizontal places of the lower and upper ends.
fn drop_and_spread<S: Real>(system: &Suspended<S>) -> (S, S) {
    let count = 1.0 / system.cords.len() as f64;
    let (mut drop, mut spread) = (S::zero(), S::zero());
    for cord in &system.cords {
        let across = cord.top_m - cord.point_m;
        drop += (cord.length_m * cord.length_m - across.dot(&across)).sqrt();
        spread += cord.top_m.x * cord.point_m.x + cord.top_m.y * cord.point_m.y;
    }
    (drop.scale(count), spread.scale(count))
}

impl<S: Real> Effect<S> for AmplitudeAddedMass<S> {
    fn adds_mass(&self) -> bool {
        true
    }

    fn add_mass(&self, now: &Now<S>, _memory: &[S], system: &Suspended<S>, mass: &mut AddedMass<S>) {
        let (drop, spread) = drop_and_spread(system);
        let square = system.gravity_m_s2 / drop;
        let yaw_square = square * system.mass_kg * spread / system.inertia_kg_m2[(2, 2)];
        let amplitude = |x: S, v: S, square: S| (x * x + v * v / square).sqrt();
        let (place, velocity) = (now.turn.tr_mul(&now.level_position()), now.velocity_hull());
        let zero = S::zero();
        let kg = V3::new(
            self.surge_kg_m * amplitude(place.x, velocity.x, square),
            self.sway_kg_m * amplitude(place.y, velocity.y, square),
            zero,
        );
        let (heading, _) = now.twist();
        let yaw = self.yaw_kg_m2_rad * amplitude(heading, now.rate.z, yaw_square);
        let arm = drop - system.cm_m.z;
        let pendulum = arm + system.inertia_kg_m2[(1, 1)] / (system.mass_kg * arm);
        let tilt = -now.turn[(2, 0)];
        let pitch = self.pitch_kg_m2_rad * amplitude(tilt, now.rate.y, system.gravity_m_s2 / pendulum);
        mass.add_diagonal(&kg, &V3::new(zero, pitch, yaw));
        mass.force += kg.component_mul(&now.rate.cross(&velocity));
    }
}
