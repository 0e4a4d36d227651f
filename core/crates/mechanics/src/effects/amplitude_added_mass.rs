//! Air that moves with the hull, the more the wider it swings.

use std::f64::consts::FRAC_1_SQRT_2;

use super::effect::{AddedMass, Described, Effect};
use crate::numbers::numbers;
use crate::real::{Real, V3};
use crate::state::Now;
use crate::suspended::Suspended;

numbers! {
    /// F = −a A v̇ along x and y, M = −a A ω̇ about y and z: Morison's inertia with a coefficient
    /// in proportion to the amplitude A, as the Keulegan–Carpenter number (2π A over the breadth)
    /// has it.
    ///
    /// The amplitude is taken from the moment: A² = x² + (v/ω₀)², with x the heading, the pitch, or
    /// the displacement of the centre of mass from below the mid-point of the upper ends along the
    /// hull's x or y; ω₀ is the base model's small swing: ω₀² = K/I_zz for the turn (K the
    /// stiffness that the lines give it at rest), g over the drop of the lines along the line that
    /// joins the suspension points, the double pendulum's mode in phase (eq. 16) across it and
    /// about it. Along such a swing A is constant. (G. H. Keulegan and L. H. Carpenter, J. Res. NBS
    /// 60 (1958) 423; paper, "Air damping".)
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
}

/// Height of the lines and Σ b·t over their number, b and t the horizontal places of the lower and
/// upper ends.
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

/// ω² of the double pendulum's mode in phase, of the lines' drop D, the centre of mass h below
/// their lower ends and the gyradius k about the line that joins these: the lower root of ω⁴ D k² −
/// ω² g (h² + k² + D h) + g² h = 0 (eq. 16).
fn in_phase_square<S: Real>(gravity_m_s2: S, drop_m: S, depth_m: S, gyradius2_m2: S) -> S {
    let sum = depth_m * depth_m + gyradius2_m2 + drop_m * depth_m;
    let root = (sum * sum - drop_m * gyradius2_m2 * depth_m.scale(4.0)).sqrt();
    gravity_m_s2 * depth_m.scale(2.0) / (sum + root)
}

impl<S: Real> Effect<S> for AmplitudeAddedMass<S> {
    fn adds_mass(&self) -> bool {
        true
    }

    fn add_mass(
        &self,
        now: &Now<S>,
        _memory: &[S],
        system: &Suspended<S>,
        mass: &mut AddedMass<S>,
    ) {
        let (drop, spread) = drop_and_spread(system);
        let pendulum = system.gravity_m_s2 / drop;
        let yaw_square = pendulum * system.mass_kg * spread / system.inertia_kg_m2[(2, 2)];
        let in_phase = |about: usize| {
            let gyradius2_m2 = system.inertia_kg_m2[(about, about)] / system.mass_kg;
            in_phase_square(system.gravity_m_s2, drop, -system.cm_m.z, gyradius2_m2)
        };
        let pitch_square = in_phase(1);
        let athwartships = system.axis().y.value().abs() > FRAC_1_SQRT_2;
        let [surge_square, sway_square] = if athwartships {
            [pitch_square, pendulum]
        } else {
            [pendulum, in_phase(0)]
        };
        let amplitude = |x: S, v: S, square: S| (x * x + v * v / square).sqrt();
        let (place, velocity) = (now.turn.tr_mul(&now.level_position()), now.velocity_hull());
        let zero = S::zero();
        let kg = V3::new(
            self.surge_kg_m * amplitude(place.x, velocity.x, surge_square),
            self.sway_kg_m * amplitude(place.y, velocity.y, sway_square),
            zero,
        );
        let (heading, _) = now.twist();
        let yaw = self.yaw_kg_m2_rad * amplitude(heading, now.rate.z, yaw_square);
        let pitch = self.pitch_kg_m2_rad * amplitude(-now.turn[(2, 0)], now.rate.y, pitch_square);
        mass.add_diagonal(&kg, &V3::new(zero, pitch, yaw));
        mass.force += kg.component_mul(&now.rate.cross(&velocity));
    }
}
