//! The paper's single routes, run on a session beside the joint estimate.
//!
//! Each route is a function of named inputs with uncertainties, so that two routes know what they share.
//! The routes give the body as it hangs; `hull_share` brings them to the hull alone by the joint estimate's own ratio
//! (hull over hanging body), so that all figures of one quantity mean the same thing.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use crate::recording::{ModeName, Orientation, Quantity};

use super::estimate::{Observed, Solution, System};
use super::measurement::Route;
use super::theory::{hull_alone, swing_body};

type Inputs = BTreeMap<String, Quantity>;
type Formula = Box<dyn Fn(&BTreeMap<String, f64>) -> Option<f64>>;

/// One route, ready to be evaluated and compared.
pub struct RouteCalculation {
    /// Quantity (`k_yaw_m`, …).
    pub quantity: String,
    /// Method (`yaw_period`, …).
    pub method: String,
    /// Equations of the paper.
    pub equation: String,
    /// Swings it used.
    pub from: Vec<String>,
    inputs: Inputs,
    formula: Formula,
}

impl RouteCalculation {
    fn slope(&self, name: &str) -> Option<f64> {
        let Some(input) = self.inputs.get(name) else { return Some(0.0) };
        let step = 1e-6 * input.value.abs().max(1e-6);
        let at = |shift: f64| {
            let mut values = self.values();
            values.insert(name.into(), input.value + shift);
            (self.formula)(&values)
        };
        Some((at(step)? - at(-step)?) / (2.0 * step))
    }

    fn values(&self) -> BTreeMap<String, f64> {
        self.inputs.iter().map(|(name, q)| (name.clone(), q.value)).collect()
    }

    /// Value and standard uncertainty (GUM, independent inputs).
    pub fn result(&self) -> Option<Quantity> {
        let value = (self.formula)(&self.values()).filter(|v| v.is_finite())?;
        let mut variance = 0.0;
        for (name, input) in &self.inputs {
            variance += (self.slope(name)? * input.u).powi(2);
        }
        Some(Quantity::new(value, variance.sqrt()))
    }

    /// Standard uncertainty of the difference to another route, shared inputs counted once.
    pub fn u_of_difference(&self, other: &RouteCalculation) -> Option<f64> {
        let names: std::collections::BTreeSet<&String> =
            self.inputs.keys().chain(other.inputs.keys()).collect();
        let mut variance = 0.0;
        for name in names {
            let u = self.inputs.get(name).or(other.inputs.get(name)).map_or(0.0, |q| q.u);
            variance += ((self.slope(name)? - other.slope(name)?) * u).powi(2);
        }
        Some(variance.sqrt())
    }

    /// As it is written to the result.
    pub fn route(&self) -> Option<Route> {
        let result = self.result()?;
        Some(Route {
            method: self.method.clone(),
            value: result.value,
            u: result.u,
            equation: self.equation.clone(),
            from: self.from.clone(),
        })
    }
}

/// Everything the routes draw on, for one swing.
struct Bench<'a> {
    system: &'a System<'a>,
    swing: usize,
}

impl Bench<'_> {
    fn period(&self, mode: ModeName) -> Option<(String, Quantity)> {
        let found = self.system.observations.iter().find(|o| o.what == Observed::Period(self.swing, mode))?;
        Some((found.label.clone(), found.value))
    }

    fn stated(&self, index: Option<usize>) -> Option<(String, Quantity)> {
        let i = index?;
        let parameter = &self.system.layout.parameters[i];
        Some((format!("{} #{i}", parameter.name), parameter.prior))
    }

    fn id(&self) -> String {
        self.system.session.swings[self.swing].id.clone()
    }
}

/// All single routes that a session's observations allow.
pub fn routes(system: &System, solution: &Solution) -> Vec<RouteCalculation> {
    let mut found = Vec::new();
    for swing in 0..system.session.swings.len() {
        let bench = Bench { system, swing };
        let share = hull_share(system, solution, swing);
        found.extend(yaw_period(&bench, &share));
        found.extend(period_ratio(&bench, &share));
        found.extend(double_pendulum(&bench, &share));
        found.extend(compound(&bench, &share, solution));
    }
    found.extend(inclines(system, solution));
    found
}

/// Hull-alone over hanging-body figures by the joint estimate: gyradii about x, y, z and depth difference; absent
/// where the swing hangs tilted (its yaw axis is another one).
struct HullShare {
    gyradii: [f64; 3],
    depth_m: f64,
    level: bool,
}

fn hull_share(system: &System, solution: &Solution, swing: usize) -> HullShare {
    let index = &system.layout.swings[swing];
    let hanging = swing_body(&system.layout, &solution.x, &system.session.swings[swing], index);
    let hull = hull_alone(system.session, &system.layout, &solution.x, index.log_depth);
    let k = |inertia: &crate::frames::Mat3, mass: f64, i: usize| (inertia[(i, i)] / mass).sqrt();
    let gyradii = std::array::from_fn(|i| {
        k(&hull.inertia_kg_m2, hull.mass_kg, i) / k(&hanging.inertia_kg_m2, hanging.mass_kg, i)
    });
    HullShare {
        gyradii,
        depth_m: hanging.cm_m.z - hull.cm_m.z,
        level: system.layout.parameters[index.pitch_deg].prior.value.abs() < 2.0,
    }
}

fn route(
    quantity: &str,
    method: &str,
    equation: &str,
    bench: &Bench,
    inputs: Vec<(String, Quantity)>,
    formula: impl Fn(&[f64]) -> Option<f64> + 'static,
) -> RouteCalculation {
    let names: Vec<String> = inputs.iter().map(|(n, _)| n.clone()).collect();
    RouteCalculation {
        quantity: quantity.into(),
        method: method.into(),
        equation: equation.into(),
        from: vec![bench.id()],
        inputs: inputs.into_iter().collect(),
        formula: Box::new(move |values| {
            let ordered: Option<Vec<f64>> = names.iter().map(|n| values.get(n).copied()).collect();
            formula(&ordered?)
        }),
    }
}

fn yaw_period(bench: &Bench, share: &HullShare) -> Option<RouteCalculation> {
    let index = &bench.system.layout.swings[bench.swing];
    let inputs = vec![
        bench.period(ModeName::Yaw)?,
        bench.stated(index.line_length)?,
        bench.stated(index.spacing)?,
        bench.stated(index.top_spacing)?,
        bench.stated(Some(bench.system.layout.gravity))?,
    ];
    let factor = share.gyradii[2];
    share.level.then(|| {
        route("k_yaw_m", "yaw_period", "(5), (6)", bench, inputs, move |v| {
            let (half, top) = (0.5 * v[2], 0.5 * v[3]);
            let height = (v[1] * v[1] - (top - half).powi(2)).sqrt();
            Some(factor * v[0] / TAU * (half * top * v[4] / height).sqrt()) // eq. (6)
        })
    })
}

fn period_ratio(bench: &Bench, share: &HullShare) -> Option<RouteCalculation> {
    let index = &bench.system.layout.swings[bench.swing];
    let inputs =
        vec![bench.period(ModeName::Yaw)?, bench.period(ModeName::Sway)?, bench.stated(index.spacing)?];
    let factor = share.gyradii[2];
    (share.level && index.top_spacing == index.spacing).then(|| {
        route("k_yaw_m", "period_ratio", "(8)", bench, inputs, move |v| {
            Some(factor * v[0] / v[1] * 0.5 * v[2])
        })
    })
}

/// Eqs. (17), (18), with the sway period where the swing shows one, else from the lines by (7).
fn double_pendulum(bench: &Bench, share: &HullShare) -> Vec<RouteCalculation> {
    let index = &bench.system.layout.swings[bench.swing];
    let orientation = bench.system.session.swings[bench.swing].suspension.orientation;
    let (long, short, k_name, about) = match orientation {
        Orientation::Athwartships => (ModeName::PitchInPhase, ModeName::PitchOutOfPhase, "k_pitch_m", 1),
        Orientation::ForeAndAft => (ModeName::RollInPhase, ModeName::RollOutOfPhase, "k_roll_m", 0),
    };
    let (Some(t1), Some(t2), Some(gravity)) =
        (bench.period(long), bench.period(short), bench.stated(Some(bench.system.layout.gravity)))
    else {
        return vec![];
    };
    let (sway, clock) = match (bench.period(ModeName::Sway), bench.stated(index.line_length)) {
        (Some(period), _) => (period, true),
        (None, Some(length)) => (length, false),
        (None, None) => return vec![],
    };
    // Pitch gyradius and depth do not change with a tilt, the depth's reference does.
    let (factor, depth_shift, level) = (share.gyradii[about], share.depth_m, share.level);
    let solve = move |v: &[f64]| {
        let (g, ts2) = (v[2], if clock { v[3] * v[3] } else { TAU * TAU * v[3] / v[2] });
        let (a, b) = (ts2 - v[1] * v[1], v[0] * v[0] - ts2);
        let unit = g / (TAU * TAU * ts2);
        (a > 0.0 && b > 0.0).then(|| {
            let depth = unit * a * b; // eq. (17)
            let k = unit * (v[0] * v[0] * v[1] * v[1] * a * b).sqrt(); // eq. (18)
            (depth, k)
        })
    };
    let method = if clock { "double_pendulum" } else { "double_pendulum_and_line_length" };
    let inputs = vec![t1, t2, gravity, sway];
    let mut found = vec![route(k_name, method, "(18)", bench, inputs.clone(), move |v| {
        solve(v).map(|(_, k)| factor * k)
    })];
    if level {
        found.push(route("cm_depth_m", method, "(17)", bench, inputs, move |v| {
            solve(v).map(|(depth, _)| depth + depth_shift)
        }));
    }
    found
}

/// Eq. (23) with the depth of the joint estimate.
fn compound(bench: &Bench, share: &HullShare, solution: &Solution) -> Option<RouteCalculation> {
    let index = &bench.system.layout.swings[bench.swing];
    let (name, about) = match bench.system.session.swings[bench.swing].suspension.orientation {
        Orientation::Athwartships => ("k_pitch_m", 1),
        Orientation::ForeAndAft => ("k_roll_m", 0),
    };
    let depth = solution.derive(&bench.system.layout, |x| Some(x[index.log_depth].exp()))?;
    let inputs = vec![
        bench.period(ModeName::Compound)?,
        bench.stated(index.axis_height)?,
        bench.stated(Some(bench.system.layout.gravity))?,
        ("depth of the joint estimate".to_string(), Quantity::new(depth.value, depth.u)),
    ];
    let factor = share.gyradii[about];
    let known = depth.weak_share < 0.05 && depth.u < 0.25 * depth.value;
    known.then(|| {
        route(name, "compound_pendulum", "(23)", bench, inputs, move |v| {
            let a = v[1] + v[3];
            let square = (v[0] / TAU).powi(2) * v[2] * a - a * a; // eq. (23)
            (square > 0.0).then(|| factor * square.sqrt())
        })
    })
}

/// Eq. (20), each incline alone.
fn inclines(system: &System, solution: &Solution) -> Vec<RouteCalculation> {
    let Some(first) = system.layout.swings.first() else { return vec![] };
    let hull = hull_alone(system.session, &system.layout, &solution.x, first.log_depth);
    let depth_shift = -hull.cm_m.z - solution.x[first.log_depth].exp();
    let mass = system.layout.parameters[system.layout.mass].prior;
    system
        .observations
        .iter()
        .filter_map(|o| {
            let Observed::Incline(i) = o.what else { return None };
            let incline = &system.session.inclines[i];
            let (m, arm, drop) = (incline.mass_kg.value, incline.arm_m.value, incline.depth_m.value);
            let inputs = [(o.label.clone(), o.value), ("mass".to_string(), mass)];
            Some(RouteCalculation {
                quantity: "cm_depth_m".into(),
                method: "incline".into(),
                equation: "(20)".into(),
                from: vec![o.label.clone()],
                inputs: inputs.into_iter().collect(),
                formula: Box::new({
                    let label = o.label.clone();
                    move |v| {
                        let tangent = v.get(&label)?.to_radians().tan();
                        Some(m / v.get("mass")? * (arm / tangent - drop) + depth_shift) // eq. (20)
                    }
                }),
            })
        })
        .collect()
}
