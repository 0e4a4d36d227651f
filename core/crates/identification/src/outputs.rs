//! The hull's own quantities from the joint solution, with interval and budget.

use std::collections::BTreeMap;

use gyradius_base::frames::Mat3;
use gyradius_mechanics::RigidBody;
use gyradius_recording::{Quantity, Session};

use super::estimate::{Derived, Solution, System};
use super::findings::{is_supported, undetermined, unsupported};
use super::measurement::{BudgetLine, Measurement, QuantityResult};
use super::names::{Input, InputKind, Method, QuantityName};
use super::spread::Spread;
use super::theory::hull_alone;
use super::value::Value;

/// A quantity is reported when the weak priors make up less than this share of its variance …
const MOST_WEAK_SHARE: f64 = 0.05;
/// … and its relative uncertainty is below this; beyond, the swings do not determine it.
const MOST_RELATIVE_U: f64 = 0.25;
/// A figure this certain is determined, whatever its small uncertainty comes from.
const CERTAIN_RELATIVE_U: f64 = 0.02;
/// The largest uncertainty at which an angle of the principal axes still says something, degrees.
const MOST_ANGLE_U_DEG: f64 = 20.0;
/// Two-sided 95 % of a normal distribution.
pub const COVERAGE_95: f64 = 1.959_963_984_540_054;
/// A hanging tilted by less says nothing of the principal axes, degrees.
const LEAST_TILT_DEG: f64 = 5.0;

/// The body that a solution describes, with what rode on it taken off.
struct Hull<'a> {
    session: &'a Session,
    system: &'a System<'a>,
    level_depth: Option<usize>,
}

impl Hull<'_> {
    fn at(&self, x: &[f64]) -> Option<RigidBody> {
        let depth = self.system.layout.level_or_first_depth()?;
        hull_alone(self.session, &self.system.layout, x, depth).ok()
    }

    fn scalar(&self, name: &QuantityName, x: &[f64]) -> Option<f64> {
        let body = self.at(x)?;
        let k = |i: usize| (body.inertia_kg_m2[(i, i)] / body.mass_kg).sqrt();
        match name {
            QuantityName::KRoll => Some(k(0)),
            QuantityName::KPitch => Some(k(1)),
            QuantityName::KYaw => Some(k(2)),
            QuantityName::CmDepth => self.level_depth.map(|_| -body.cm_m.z),
            QuantityName::InertiaRoll => Some(body.inertia_kg_m2[(0, 0)]),
            QuantityName::InertiaPitch => Some(body.inertia_kg_m2[(1, 1)]),
            QuantityName::InertiaYaw => Some(body.inertia_kg_m2[(2, 2)]),
            QuantityName::Psi => Some(psi_rad(&body.inertia_kg_m2).to_degrees()),
            QuantityName::PrincipalGyradii
            | QuantityName::Inertia
            | QuantityName::SmallPeriod(_) => None,
        }
    }
}

/// A quantity of the hull alone at parameters of the session.
pub fn hull_scalar(system: &System, name: &QuantityName, x: &[f64]) -> Option<f64> {
    Hull {
        session: system.session,
        system,
        level_depth: system.layout.level_depth(),
    }
    .scalar(name, x)
}

/// Angle from the hull's x axis up to the principal x axis, positive bow up, rad. Eqs. (3), (4) in
/// tensor form: tan 2ψ = 2 I_xz / (I_xx − I_zz) with the tensor's own I_xz = −∫ x z dm.
fn psi_rad(inertia: &Mat3) -> f64 {
    let (ixx, izz, ixz) = (inertia[(0, 0)], inertia[(2, 2)], inertia[(0, 2)]);
    0.5 * (-2.0 * ixz).atan2(izz - ixx)
}

/// Principal gyradii in the order x, y, z of the hull axes they lie nearest to, m.
fn principal_gyradii_m(body: &RigidBody) -> [f64; 3] {
    let inertia = &body.inertia_kg_m2;
    let (ixx, izz, ixz) = (inertia[(0, 0)], inertia[(2, 2)], inertia[(0, 2)]);
    let psi = psi_rad(inertia);
    let (s, c) = psi.sin_cos();
    let about =
        |ux: f64, uz: f64| (ux * ux * ixx + 2.0 * ux * uz * ixz + uz * uz * izz) / body.mass_kg;
    [
        about(c, s).sqrt(),
        (inertia[(1, 1)] / body.mass_kg).sqrt(),
        about(-s, c).sqrt(),
    ]
}

/// Fills in quantities, budget and correlations, and what is not stated for want of a swing that
/// shows it.
pub fn write_quantities(system: &System, solution: &Solution, result: &mut Measurement) {
    let spread = Spread::of(system, solution);
    write_averaged(system, &spread, result);
}

/// The same of a session that was solved in every way that its data allow.
pub fn write_averaged(system: &System, spread: &Spread, result: &mut Measurement) {
    let hull = Hull {
        session: system.session,
        system,
        level_depth: system.layout.level_depth(),
    };
    let mut determined: Vec<(QuantityName, Derived)> = Vec::new();
    let (mut left_out, mut not_determined) = (Vec::new(), Vec::new());
    for name in QuantityName::SCALARS {
        let shown = match name {
            QuantityName::Psi => has_tilted_swings(system),
            QuantityName::CmDepth => hull.level_depth.is_some(),
            _ => true,
        };
        let averaged = spread.derive(|x| hull.scalar(&name, x));
        let Some(averaged) = averaged else {
            if shown && is_supported(system, &name) {
                not_determined.push((name, None));
            }
            continue;
        };
        if !(shown && is_determined(&name, &averaged.derived)) {
            if shown && is_supported(system, &name) {
                not_determined.push((name, Some(averaged.derived.clone())));
            }
            continue;
        }
        if !is_supported(system, &name) {
            left_out.push(name);
            continue;
        }
        let mut lines = budget(spread.system(), spread.solution(), &averaged.derived);
        let beyond = [
            (InputKind::UnknownTilt, averaged.by_product),
            (InputKind::Contradiction, averaged.by_doubt),
        ];
        for (kind, u_contribution) in beyond {
            add_line(&mut lines, kind, u_contribution, averaged.derived.u);
        }
        let shown = scalar_result(&averaged.derived);
        result.quantities.insert(name.clone(), shown);
        result.budget.insert(name.clone(), lines);
        determined.push((name, averaged.derived));
    }
    for one in unsupported(system.session, &left_out) {
        result.find(one);
    }
    for (name, derived) in &not_determined {
        let certainty = derived.as_ref().map(|d| Quantity::new(d.value, d.u));
        result.find(undetermined(name, certainty));
    }
    for (i, (a, da)) in determined.iter().enumerate() {
        for (b, db) in &determined[i + 1..] {
            result
                .correlations
                .push((a.clone(), b.clone(), da.correlation(db)));
        }
    }
    let has = |name: &QuantityName| determined.iter().any(|(n, _)| n == name);
    if [
        QuantityName::KYaw,
        QuantityName::KPitch,
        QuantityName::KRoll,
    ]
    .iter()
    .all(has)
    {
        write_tensor(&hull, spread, has(&QuantityName::Psi), result);
    } else if system.session.body.mass_kg.is_some() {
        for moment in determined.iter().filter_map(|(name, _)| name.moment()) {
            if let Some(averaged) = spread.derive(|x| hull.scalar(&moment, x)) {
                let shown = scalar_result(&averaged.derived);
                result.quantities.insert(moment, shown);
            }
        }
    }
}

/// The same session with its unknown product of inertia one standard uncertainty off: its effect on
/// a roll is of the second order, which no linear propagation sees.
pub fn with_principal_axes_turned(system: &System, solution: &Solution) -> Option<Solution> {
    let product = system.layout.product_xz;
    let u = solution.u(product);
    let mut layout = system.layout.clone();
    layout.parameters[product].prior = Quantity::new(solution.x[product] + u, 1e-6 * u);
    let turned = system.with(layout);
    let mut start = solution.x.clone();
    start[product] += u;
    turned.solve(&start).ok()
}

fn add_line(lines: &mut Vec<BudgetLine>, kind: InputKind, u_contribution: f64, u: f64) {
    if u_contribution > 1e-4 * u {
        lines.push(BudgetLine {
            input: kind.into(),
            u_contribution,
        });
        lines.sort_by(|a, b| b.u_contribution.total_cmp(&a.u_contribution));
    }
}

/// Only swings about tilted axes tell a bow-up from a bow-down principal axis.
fn has_tilted_swings(system: &System) -> bool {
    system
        .layout
        .swings
        .iter()
        .any(|s| system.layout.parameters[s.pitch_deg].prior.value.abs() > LEAST_TILT_DEG)
}

fn is_determined(name: &QuantityName, derived: &Derived) -> bool {
    let (small, certain) = match name {
        QuantityName::Psi => (derived.u < MOST_ANGLE_U_DEG, false),
        _ => {
            let relative_u = derived.u / derived.value.abs();
            (
                relative_u < MOST_RELATIVE_U,
                relative_u < CERTAIN_RELATIVE_U,
            )
        }
    };
    certain || (small && derived.weak_share < MOST_WEAK_SHARE)
}

fn scalar_result(derived: &Derived) -> QuantityResult {
    let half = COVERAGE_95 * derived.u;
    QuantityResult {
        value: derived.value.into(),
        u: derived.u.into(),
        interval_95: Some([derived.value - half, derived.value + half]),
        method: Method::JointEstimate,
    }
}

/// Principal gyradii and the tensor; without ψ the products of inertia are not known and the hull
/// axes are taken as principal.
fn write_tensor(hull: &Hull, spread: &Spread, psi_known: bool, result: &mut Measurement) {
    let derive = |f: &dyn Fn(&[f64]) -> Option<f64>| {
        let averaged = spread.derive(f)?;
        Some(averaged.derived)
    };
    let body_of = |x: &[f64]| {
        let mut body = hull.at(x)?;
        if !psi_known {
            body.inertia_kg_m2[(0, 2)] = 0.0;
            body.inertia_kg_m2[(2, 0)] = 0.0;
        }
        Some(body)
    };
    let method = if psi_known {
        Method::JointEstimate
    } else {
        Method::JointEstimateAlongHullAxes
    };
    let gyradius = |i: usize| derive(&|x| body_of(x).map(|b| principal_gyradii_m(&b)[i]));
    if let [Some(x), Some(y), Some(z)] = [0, 1, 2].map(gyradius) {
        let k = [x, y, z];
        let entry = QuantityResult {
            value: Value::Vector(k.each_ref().map(|d| d.value)),
            u: Value::Vector(k.each_ref().map(|d| d.u)),
            interval_95: None,
            method,
        };
        result
            .quantities
            .insert(QuantityName::PrincipalGyradii, entry);
    }
    if hull.session.body.mass_kg.is_none() {
        return;
    }
    let element = |i: usize, j: usize| derive(&|x| body_of(x).map(|b| b.inertia_kg_m2[(i, j)]));
    let mut values = [[0.0; 3]; 3];
    let mut us = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..3 {
            if let Some(d) = element(i, j) {
                (values[i][j], us[i][j]) = (d.value, d.u);
            }
        }
    }
    let entry = QuantityResult {
        value: Value::Matrix(values),
        u: Value::Matrix(us),
        interval_95: None,
        method,
    };
    result.quantities.insert(QuantityName::Inertia, entry);
}

/// Contributions by input, largest first; rows with the same name add in quadrature.
pub fn budget(system: &System, solution: &Solution, derived: &Derived) -> Vec<BudgetLine> {
    let mut squares: BTreeMap<Input, f64> = BTreeMap::new();
    let mut add = |name: Input, square: f64| *squares.entry(name).or_default() += square;
    let mut by_row = derived.by_row.clone();
    for group in system.correlated(&solution.free) {
        for (name, contribution) in group.by_source(&mut by_row) {
            add(name, contribution.powi(2));
        }
    }
    for (row, observation) in system.observations.iter().enumerate() {
        let square = by_row[row].powi(2);
        let by_amplitude = (observation.u_amplitude / observation.value.u)
            .powi(2)
            .min(1.0);
        add(observation.label.clone(), square * (1.0 - by_amplitude));
        add(InputKind::FiniteAmplitude.into(), square * by_amplitude);
    }
    let first_prior = system.observations.len();
    for (k, i) in solution.free.iter().enumerate() {
        add(
            system.layout.parameters[*i].name.clone(),
            by_row[first_prior + k].powi(2),
        );
    }
    let mut lines: Vec<BudgetLine> = squares
        .into_iter()
        .map(|(input, square)| BudgetLine {
            input,
            u_contribution: square.sqrt(),
        })
        .filter(|line| line.u_contribution > 1e-4 * derived.u)
        .collect();
    lines.sort_by(|a, b| b.u_contribution.total_cmp(&a.u_contribution));
    lines
}
