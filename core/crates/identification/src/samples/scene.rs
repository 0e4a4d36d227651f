//! From the session's parameters and a swing's own to what is simulated.

use nalgebra::{DMatrix, Matrix6};

use super::turn::{turned, turned_slopes};
use crate::parameters::{Layout, SwingIndex};
use crate::theory::{axis, swing_body, swing_rig};
use gyradius_base::error::Result;
use gyradius_base::frames::{Rotation, Vec3};
use gyradius_mechanics::effects::EffectValues;
use gyradius_mechanics::{Body, Dimensions, Hanging, Jet, Phone, Real, Scene, Start};
use gyradius_recording::Swing;

/// Numbers of the scene by which the motion is differentiated: places in `Scene::names`.
pub const LANES: [usize; 24] = [
    1, 2, 3, 4, 5, 7, 9, // inertia xx, yy, zz, xy, xz; centre of mass x, z
    10, 11, 12, 15, // line length, spacing, top spacing, gravity
    16, 17, 18, 19, 20, 21, 22, 23, // start
    24, 25, 27, 28, 29, // damping of surge, sway, roll, pitch, yaw
];
/// Of these, how many belong to the session.
pub const SHARED_LANES: usize = 11;

/// Places of what belongs to one swing alone, of which there are `OWN`.
pub mod place {
    use std::ops::Range;

    /// Where the body starts.
    pub const START: Range<usize> = 0..8;
    /// Shift along the suspension, across it, turn about it, yaw; their rates follow in order.
    pub const ALONG: usize = 0;
    /// Across it (direction × up).
    pub const ACROSS: usize = 1;
    /// Turn about the suspension's direction.
    pub const TURN_ABOUT: usize = 2;
    /// Yaw.
    pub const YAW: usize = 3;
    /// Damping rates of surge, sway, roll, pitch and yaw.
    pub const DAMPING: Range<usize> = 8..13;
    /// The phone's place, x, y, z, before its turn.
    pub const PHONE: Range<usize> = 13..16;
    /// Its tilts about x and y, and its heading about z.
    pub const TURN: Range<usize> = 16..19;
    /// Biases of gyroscope and accelerometer.
    pub const BIAS: Range<usize> = 19..25;
    /// Their drifts.
    pub const DRIFT: Range<usize> = 25..31;
}

/// How many numbers belong to one swing alone.
pub const OWN: usize = place::DRIFT.end;
const DAMPING: usize = place::DAMPING.start;
pub const PLACE: usize = place::PHONE.start;
pub const TURN: usize = place::TURN.start;
pub const BIAS: usize = place::BIAS.start;
pub const DRIFT: usize = place::DRIFT.start;

/// What belongs to one swing alone.
#[derive(Debug, Clone)]
pub struct Own {
    /// Its parameters, at their [`place`]s.
    pub values: [f64; OWN],
    /// `hanging_from_phone`; the turn in `values` comes after it.
    pub nominal: Rotation,
}

/// One swing of a session.
#[derive(Debug, Clone, Copy)]
pub struct SwingSetup<'a> {
    /// The session's parameters.
    pub layout: &'a Layout,
    /// The swing.
    pub swing: &'a Swing,
    /// Where its parameters are among those of the session.
    pub index: &'a SwingIndex,
}

impl SwingSetup<'_> {
    /// What is simulated, per kilogram: masses enter a motion by their ratios alone.
    pub fn scene(&self, x: &[f64], own: &Own) -> Result<Scene> {
        self.scene_of(x, &own.values[..PLACE])
    }

    /// The same over numbers that may have derivatives, from the start and the damping rates, behind
    /// which that of heave may stand.
    pub fn scene_of<S: Real>(&self, x: &[S], v: &[S]) -> Result<Scene<S>> {
        let body = swing_body(self.layout, x, self.swing, self.index)?;
        // Asked for the lines' sake: a length that is no length is an error with its name.
        let plain: Vec<f64> = x.iter().map(|x| x.value()).collect();
        swing_rig(self.layout, &plain, self.swing, self.index)?;
        let value = |i: Option<usize>| i.map_or(S::zero(), |i| x[i]);
        let body = Body::new(S::one(), &(body.inertia_kg_m2 / body.mass_kg), &body.cm_m);
        let scales = damping_scales(&body);
        let rates = v[DAMPING..].iter().zip(scales);
        let damping: Vec<(&str, S)> = rates
            .map(|(rate, (name, scale))| (name, *rate * scale))
            .collect();
        Ok(Scene {
            hanging: Hanging::Bifilar(axis(self.swing.suspension.orientation)),
            body,
            dimensions: Dimensions {
                line_length_m: value(self.index.line_length),
                spacing_m: value(self.index.spacing),
                top_spacing_m: value(self.index.top_spacing),
                gravity_m_s2: x[self.layout.gravity],
                ..Dimensions::default().map(S::constant)
            },
            start: Start {
                along_m: v[0],
                across_m: v[1],
                turn_rad: v[2],
                yaw_rad: v[3],
                along_m_s: v[4],
                across_m_s: v[5],
                turn_rad_s: v[6],
                yaw_rad_s: v[7],
            },
            effects: vec![EffectValues::new("linear_damping", &damping)?],
        })
    }

    /// The hull's centre of mass, hanging axes, m: straight below the mid-point of the suspension
    /// points.
    pub fn centre_m(&self, x: &[f64]) -> Vec3 {
        Vec3::new(0.0, 0.0, -x[self.index.log_depth].exp())
    }

    /// Derivatives of the scene's numbers ([`LANES`]) by the parameters at `free`: damping rates
    /// stay, and their numbers go with the body.
    pub fn lane_slopes(&self, x: &[f64], own: &Own, free: &[usize]) -> Result<DMatrix<f64>> {
        let mut slopes = DMatrix::zeros(LANES.len(), free.len());
        let v: Vec<Jet> = own.values[..PLACE]
            .iter()
            .map(|v| Jet::constant(*v))
            .collect();
        for (group, places) in free.chunks(gyradius_mechanics::LANES).enumerate() {
            let mut x: Vec<Jet> = x.iter().map(|x| Jet::constant(*x)).collect();
            for (lane, i) in places.iter().enumerate() {
                x[*i] = Jet::parameter(x[*i].value, lane);
            }
            let numbers = self.scene_of(&x, &v)?.values();
            for (row, place) in LANES.iter().enumerate() {
                for lane in 0..places.len() {
                    let column = group * gyradius_mechanics::LANES + lane;
                    slopes[(row, column)] = numbers[*place].slope[lane];
                }
            }
        }
        Ok(slopes)
    }

    /// Change of the scene's damping numbers by the swing's damping rates.
    pub fn damping_slopes(&self, scene: &Scene) -> [f64; 5] {
        let [rates @ .., _] = damping_scales(&scene.body).map(|(_, scale)| scale);
        rates
    }
}

/// Numbers of the linear damping, and the mass or inertia that makes them of a rate, 1/s.
fn damping_scales<S: Real>(body: &Body<S>) -> [(&'static str, S); 6] {
    [
        ("surge_n_s_m", body.mass_kg),
        ("sway_n_s_m", body.mass_kg),
        ("roll_n_m_s", body.inertia_xx_kg_m2),
        ("pitch_n_m_s", body.inertia_yy_kg_m2),
        ("yaw_n_m_s", body.inertia_zz_kg_m2),
        ("heave_n_s_m", body.mass_kg),
    ]
}

impl Own {
    /// Nothing moves yet; a hull dies away in minutes.
    pub fn at_rest(nominal: Rotation) -> Self {
        /// τ of some 200 s (the paper's 640 s, phones in air 60 s).
        const DAMPING_RATE_PER_S: f64 = 0.01;
        let mut values = [0.0; OWN];
        values[DAMPING..DAMPING + 5].fill(DAMPING_RATE_PER_S);
        Self { values, nominal }
    }

    /// Where the phone lies, hanging axes, m; its turn is folded.
    pub fn phone_m(&self) -> Vec3 {
        Vec3::from_column_slice(&self.values[place::PHONE])
    }

    /// The phone's place; its biases are added by the caller.
    pub fn phone(&self) -> Phone {
        let place = self.phone_m();
        Phone {
            position_x_m: place.x,
            position_y_m: place.y,
            position_z_m: place.z,
            ..Phone::default()
        }
    }

    /// The same motion of a hull whose bow is where its stern was.
    pub fn turned_round(&self) -> Self {
        const ABOUT_FACE: [usize; 8] = [0, 1, 2, 4, 5, 6, PLACE, PLACE + 1];
        let half_turn = Rotation::from_axis_angle(&Vec3::z_axis(), std::f64::consts::PI);
        let mut turned = self.clone().folded();
        ABOUT_FACE
            .iter()
            .for_each(|i| turned.values[*i] = -turned.values[*i]);
        turned.nominal = Rotation::new_normalize((half_turn * turned.nominal).into_inner());
        turned
    }

    /// The turn taken into the nominal orientation and the place.
    pub fn folded(mut self) -> Self {
        let (nominal, place_m) = turned(self.turn(), &self.nominal, self.phone_m());
        self.nominal = Rotation::new_normalize(nominal.into_inner());
        self.values[place::PHONE].copy_from_slice(place_m.as_slice());
        self.values[place::TURN].fill(0.0);
        self
    }

    fn turn(&self) -> Vec3 {
        Vec3::from_column_slice(&self.values[place::TURN])
    }

    /// What of place and turn is folded, by their numbers.
    pub fn folding_slopes(&self) -> Matrix6<f64> {
        turned_slopes(self.turn(), &self.nominal, self.phone_m())
    }

    /// Uncertainties of weak priors about zero: they keep the equations solvable where a swing does
    /// not show a number.
    pub fn prior_u() -> [f64; OWN] {
        let mut u = [0.0; OWN];
        u[..DAMPING].fill(3.0); // m, rad, m/s, rad/s
        u[DAMPING..PLACE].fill(0.3); // 1/s: dies away within three seconds
        u[PLACE..TURN].fill(5.0); // m
        u[TURN..BIAS].fill(1.0); // rad
        u[BIAS..BIAS + 3].fill(0.1); // rad/s
        u[BIAS + 3..DRIFT].fill(0.1); // m/s², ten times a phone's
        u[DRIFT..DRIFT + 3].fill(1e-3); // rad/s per s
        u[DRIFT + 3..].fill(1e-3); // m/s² per s
        u
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;
    use gyradius_recording::{Quantity, read_session};

    const SESSION: &str = r#"
format = "gyradius-session/1"
title = "t"
[body]
name = "b"
[[swing]]
id = "yaw"
periods_s = { yaw = 4.0 }
[swing.suspension]
kind = "bifilar"
orientation = "athwartships"
line_length = { value = 2.0, u = 0.0 }
spacing = { value = 0.8, u = 0.0 }
"#;

    /// A damping rate γ of the yaw is the number γ I/M = γ k²: by ln k it changes by 2 γ k².
    #[test]
    fn damping_numbers_go_with_the_body() {
        let session = read_session(SESSION, "session.toml").unwrap();
        let layout = Layout::of(&session, Quantity::exact(9.8), &[None], &[None], &[]);
        let setup = SwingSetup {
            layout: &layout,
            swing: &session.swings[0],
            index: &layout.swings[0],
        };
        let mut x = layout.start();
        let (k_m, rate_per_s) = (0.7f64, 0.03);
        let yaw = layout.log_gyradii[2];
        x[yaw] = k_m.ln();
        let mut own = Own::at_rest(Rotation::identity());
        own.values[DAMPING + 4] = rate_per_s;
        let slopes = setup.lane_slopes(&x, &own, &[yaw]).unwrap();
        assert_relative_eq!(
            slopes[(LANES.len() - 1, 0)],
            2.0 * rate_per_s * k_m * k_m,
            max_relative = 1e-6
        );
    }
}
