//! What is simulated, as named numbers: body, rig, start, effects.
//!
//! # Conventions
//! Hull axes: x forward, y to port, z up; lengths in the hull count from the mid-point of the
//! suspension points. World: z up, origin mid-way between the upper ends, x along the hull's at yaw
//! zero. The *axis* is the direction that joins the suspension points: +y athwartships, +x fore and
//! aft; *across* is axis × up. The attitude is `world_from_hull` = yaw about z · roll about across
//! · turn about the axis.

use super::effects::{EffectValues, build};
use super::equations::Equations;
use super::numbers::{Number, Numbers, numbers};
use super::path::{Fineness, Moment, Path};
use super::real::{Dual, M3, Real, V3, constant};
use super::rig::{Hanging, Line, Rig, RigidBody, SuspensionAxis};
use super::small::small_modes;
use super::start::{Start, started};
use super::suspended::{Cord, Suspended};
use gyradius_base::error::{Error, Result};
use gyradius_base::frames::Vec3;

numbers! {
    /// The body, hull axes.
    pub struct Body {
        /// Mass.
        mass_kg: "kg",
        /// About the centre of mass.
        inertia_xx_kg_m2: "kg m^2",
        /// About the centre of mass.
        inertia_yy_kg_m2: "kg m^2",
        /// About the centre of mass.
        inertia_zz_kg_m2: "kg m^2",
        /// Element of the inertia tensor (minus the sum of m x y).
        inertia_xy_kg_m2: "kg m^2",
        /// Element of the inertia tensor (minus the sum of m x z).
        inertia_xz_kg_m2: "kg m^2",
        /// Element of the inertia tensor (minus the sum of m y z).
        inertia_yz_kg_m2: "kg m^2",
        /// Centre of mass.
        cm_x_m: "m",
        /// Centre of mass.
        cm_y_m: "m",
        /// Centre of mass: minus its depth below the suspension points.
        cm_z_m: "m",
    }
}

numbers! {
    /// The suspension.
    pub struct Dimensions {
        /// Length of the lines (bifilar).
        line_length_m: "m",
        /// Between the suspension points on the hull.
        spacing_m: "m",
        /// Between the upper ends.
        top_spacing_m: "m",
        /// Height of the axis above the suspension points (compound).
        axis_height_m: "m",
        /// Between the two points of each V (compound).
        spread_m: "m",
        /// Acceleration of free fall.
        gravity_m_s2: "m/s^2",
    }
}

impl<S: Real> Body<S> {
    /// Inertia about the centre of mass.
    pub fn inertia(&self) -> M3<S> {
        let (xy, xz, yz) = (
            self.inertia_xy_kg_m2,
            self.inertia_xz_kg_m2,
            self.inertia_yz_kg_m2,
        );
        let (xx, yy, zz) = (
            self.inertia_xx_kg_m2,
            self.inertia_yy_kg_m2,
            self.inertia_zz_kg_m2,
        );
        M3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
    }

    /// Centre of mass.
    pub fn cm(&self) -> V3<S> {
        V3::new(self.cm_x_m, self.cm_y_m, self.cm_z_m)
    }
}

impl<S: Real> Body<S> {
    /// From an inertia tensor and a centre of mass.
    pub fn new(mass_kg: S, inertia_kg_m2: &M3<S>, cm_m: &V3<S>) -> Self {
        let i = |r: usize, c: usize| (inertia_kg_m2[(r, c)] + inertia_kg_m2[(c, r)]).scale(0.5);
        Self {
            mass_kg,
            inertia_xx_kg_m2: i(0, 0),
            inertia_yy_kg_m2: i(1, 1),
            inertia_zz_kg_m2: i(2, 2),
            inertia_xy_kg_m2: i(0, 1),
            inertia_xz_kg_m2: i(0, 2),
            inertia_yz_kg_m2: i(1, 2),
            cm_x_m: cm_m.x,
            cm_y_m: cm_m.y,
            cm_z_m: cm_m.z,
        }
    }
}

/// What is simulated.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene<S = f64> {
    /// How the body hangs.
    pub hanging: Hanging,
    /// The body.
    pub body: Body<S>,
    /// The suspension.
    pub dimensions: Dimensions<S>,
    /// The start.
    pub start: Start<S>,
    /// What the simple theory leaves out.
    pub effects: Vec<EffectValues<S>>,
}

/// Derivatives are computed in groups of so many parameters.
pub const LANES: usize = 12;

impl<S: Real> Scene<S> {
    /// All its numbers, in the order of [`Scene::names`].
    pub fn values(&self) -> Vec<S> {
        let mut values = self.body.to_numbers();
        values.extend(self.dimensions.to_numbers());
        values.extend(self.start.to_numbers());
        values.extend(self.effects.iter().flat_map(|e| &e.values));
        values
    }

    /// The same scene over other numbers.
    pub(super) fn map<T>(&self, f: impl Fn(S) -> T + Copy) -> Scene<T> {
        Scene {
            hanging: self.hanging,
            body: self.body.map(f),
            dimensions: self.dimensions.map(f),
            start: self.start.map(f),
            effects: self.effects.iter().map(|e| e.map(f)).collect(),
        }
    }
}

impl Scene {
    /// Names and units of all its numbers; those of effects read `effect.number`, a second of the
    /// same kind `effect#2.number`.
    pub fn names(&self) -> Vec<(String, &'static str)> {
        let own = [
            <Body as Numbers<f64>>::NUMBERS,
            <Dimensions as Numbers<f64>>::NUMBERS,
            <Start as Numbers<f64>>::NUMBERS,
        ];
        let mut names: Vec<(String, &'static str)> = own
            .concat()
            .iter()
            .map(|n: &Number| (n.name.to_owned(), n.unit))
            .collect();
        names.extend(effect_names(&self.effects));
        names
    }

    /// The scene with other numbers, in the order of [`Scene::names`].
    pub fn with_values(&self, values: &[f64]) -> Result<Self> {
        let mut scene = self.clone();
        let mut rest = values.iter().copied();
        let few = || Error::argument("values", "as many as the scene has numbers", values.len());
        scene.body = Body::from_numbers(&mut rest).ok_or_else(few)?;
        scene.dimensions = Dimensions::from_numbers(&mut rest).ok_or_else(few)?;
        scene.start = Start::from_numbers(&mut rest).ok_or_else(few)?;
        for effect in &mut scene.effects {
            for value in &mut effect.values {
                *value = rest.next().ok_or_else(few)?;
            }
        }
        Ok(scene)
    }

    /// Place of a number in [`Scene::names`].
    pub fn index(&self, name: &str) -> Result<usize> {
        let found = self.names().iter().position(|(n, _)| n == name);
        found.ok_or_else(|| Error::argument("number", "a number of the scene", name))
    }

    /// The motion.
    pub fn motion(&self, duration_s: f64) -> Result<Path<f64>> {
        self.motion_as(Fineness::FULL, duration_s)
    }

    /// The motion, as finely as is asked.
    pub fn motion_as(&self, fineness: Fineness, duration_s: f64) -> Result<Path<f64>> {
        self.run(
            self.values(),
            duration_s,
            self.step_s(fineness.steps_per_period)?,
            fineness,
        )
    }

    /// The motion with its derivatives by the numbers at `wanted`, [`LANES`] of them to a path.
    pub fn motion_and_derivatives(
        &self,
        wanted: &[usize],
        fineness: Fineness,
        duration_s: f64,
    ) -> Result<Vec<Path<Dual<LANES>>>> {
        let step_s = self.step_s(fineness.steps_per_period)?;
        let values = self.values();
        let run = |lanes: &[usize]| self.run(seeded(&values, lanes)?, duration_s, step_s, fineness);
        wanted.chunks(LANES).map(run).collect()
    }

    /// The body at the start.
    pub fn first_moment(&self) -> Result<Moment<f64>> {
        let (equations, start) = self.equations(self.values())?;
        let y = started(&equations, self.hanging, &start)?;
        let mut slope = y.clone();
        equations.slope(&y, &mut slope);
        Ok(Moment::new(&y, &slope))
    }

    pub(super) fn run<S: Real>(
        &self,
        values: Vec<S>,
        duration_s: f64,
        step_s: f64,
        fineness: Fineness,
    ) -> Result<Path<S>> {
        let sizes = sizes(&values);
        let (equations, start) = self.equations(values)?;
        let y = started(&equations, self.hanging, &start)?;
        Path::integrate(&equations, y, sizes, duration_s, step_s, fineness)
    }

    pub(super) fn equations<S: Real>(&self, values: Vec<S>) -> Result<(Equations<S>, Start<S>)> {
        self.effects.iter().try_for_each(EffectValues::check)?;
        let rest = &mut values.into_iter() as &mut dyn Iterator<Item = S>;
        let few = || Error::argument("values", "as many as the scene has numbers", "too few");
        let body = Body::from_numbers(rest).ok_or_else(few)?;
        let dimensions = Dimensions::from_numbers(rest).ok_or_else(few)?;
        let start = Start::from_numbers(rest).ok_or_else(few)?;
        let effects: Option<Vec<_>> = self
            .effects
            .iter()
            .map(|e| build(e.kind.id, rest))
            .collect();
        let system = Suspended {
            mass_kg: body.mass_kg,
            inertia_kg_m2: body.inertia(),
            cm_m: body.cm(),
            cords: cords(self.hanging, &dimensions),
            gravity_m_s2: dimensions.gravity_m_s2,
            spring: None,
        };
        Ok((Equations::new(system, effects.ok_or_else(few)?), start))
    }

    /// Turn about the axis at which the body hangs still on lines that are alike, rad: its centre
    /// of mass then lies below the axis. Effects that shift the centre count; whatever else moves
    /// the rest does not.
    pub fn rest_turn_rad(&self) -> Result<f64> {
        let (equations, _) = self.equations(self.values())?;
        let (cm, axis) = (equations.system.cm_m, self.hanging.axis().unit());
        let across = axis.cross(&Vec3::z());
        // A turn by θ about the axis takes the centre's share across to c cos θ + z sin θ.
        Ok(cm.dot(&across).atan2(-cm.z))
    }

    /// Step of the integration for so many steps per period of the fastest mode.
    pub fn step_s(&self, per_period: f64) -> Result<f64> {
        let (equations, _) = self.equations(self.values())?;
        Ok(std::f64::consts::TAU / fastest_rad_s(self.hanging, &equations)? / per_period)
    }
}

/// Names and units of the numbers of effects.
pub(super) fn effect_names(effects: &[EffectValues]) -> Vec<(String, &'static str)> {
    let mut names = Vec::new();
    for (i, effect) in effects.iter().enumerate() {
        let before = effects[..i]
            .iter()
            .filter(|e| e.kind.id == effect.kind.id)
            .count();
        let count = if before > 0 {
            format!("#{}", before + 1)
        } else {
            String::new()
        };
        names.extend(
            effect
                .kind
                .numbers
                .iter()
                .map(|n| (format!("{}{count}.{}", effect.kind.id, n.name), n.unit)),
        );
    }
    names
}

/// The numbers, those at `lanes` as parameters in this order.
pub(super) fn seeded(values: &[f64], lanes: &[usize]) -> Result<Vec<Dual<LANES>>> {
    let mut seeded: Vec<Dual<LANES>> = values.iter().map(|v| Dual::constant(*v)).collect();
    for (lane, &i) in lanes.iter().enumerate() {
        let value = values
            .get(i)
            .ok_or_else(|| Error::argument("wanted", "places of numbers", i))?;
        seeded[i] = Dual::parameter(*value, lane);
    }
    Ok(seeded)
}

/// Change of each parameter by which it changes the first number that depends on it by that
/// number's size, a zero by 1; 1 for a parameter on which none depends.
fn sizes<S: Real>(values: &[S]) -> Vec<f64> {
    let lanes = values.first().map_or(0, |value| value.slopes().len());
    let of = |value: &S| match value.value().abs() {
        0.0 => 1.0,
        size => size,
    };
    let size = |lane: usize| {
        let behind = values.iter().find(|value| value.slopes()[lane] != 0.0);
        behind.map_or(1.0, |value| of(value) / value.slopes()[lane].abs())
    };
    (0..lanes).map(size).collect()
}

/// The lines of a suspension.
fn cords<S: Real>(hanging: Hanging, d: &Dimensions<S>) -> Vec<Cord<S>> {
    let axis: V3<S> = constant(&hanging.axis().unit());
    let across = axis.cross(&V3::z());
    let half = |x: S, side: f64| x.scale(0.5 * side);
    let sides = [-1.0, 1.0];
    match hanging {
        Hanging::Bifilar(_) => sides
            .map(|side| Cord {
                top_m: axis * half(d.top_spacing_m, side),
                point_m: axis * half(d.spacing_m, side),
                length_m: d.line_length_m,
            })
            .to_vec(),
        Hanging::Compound(_) => {
            let half_spread = d.spread_m.scale(0.5);
            let length_m = (d.axis_height_m * d.axis_height_m + half_spread * half_spread).sqrt();
            let leg = |side: f64, leg: f64| Cord {
                top_m: axis * half(d.spacing_m, side),
                point_m: axis * half(d.spacing_m, side) + across * half(d.spread_m, leg),
                length_m,
            };
            sides
                .into_iter()
                .flat_map(|side| sides.map(|other| leg(side, other)))
                .collect()
        }
    }
}

/// Fastest angular frequency of the lines, the body and the effects.
fn fastest_rad_s(hanging: Hanging, equations: &Equations<f64>) -> Result<f64> {
    let system = &equations.system;
    let of_lines = match hanging {
        Hanging::Bifilar(_) => bifilar_rad_s(system)?,
        Hanging::Compound(axis) => compound_rad_s(system, axis),
    };
    let of_effects = equations
        .effects()
        .map(|(effect, _)| effect.fastest_rad_s(system));
    Ok(of_effects.fold(of_lines, f64::max))
}

fn bifilar_rad_s(system: &Suspended<f64>) -> Result<f64> {
    let line = |i: usize| Line {
        top_m: system.cords[i].top_m,
        hull_point_m: system.cords[i].point_m,
        length_m: system.cords[i].length_m,
    };
    let rig = Rig {
        lines: [line(0), line(1)],
        gravity_m_s2: system.gravity_m_s2,
    };
    let (mass_kg, cm_m) = (system.mass_kg, system.cm_m);
    let body = RigidBody {
        mass_kg,
        inertia_kg_m2: system.inertia_kg_m2,
        cm_m,
    };
    Ok(small_modes(&rig, &body)?.omega_rad_s[3])
}

/// The faster of the compound pendulum (eq. 22) and of the sway on the lines.
fn compound_rad_s(system: &Suspended<f64>, axis: SuspensionAxis) -> f64 {
    let unit = axis.unit();
    let height = system.cords.iter().map(|c| {
        (c.length_m.powi(2) - (c.top_m - c.point_m).norm_squared())
            .max(0.0)
            .sqrt()
    });
    let height = height.fold(f64::INFINITY, f64::min);
    let arm = height - system.cm_m.z;
    let about_axis = unit.dot(&(system.inertia_kg_m2 * unit)) / system.mass_kg + arm * arm;
    (system.gravity_m_s2 * arm / about_axis)
        .max(system.gravity_m_s2 / height)
        .sqrt()
}
