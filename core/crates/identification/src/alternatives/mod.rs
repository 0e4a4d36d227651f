//! The paper's single routes, run on a session beside the joint estimate.
//!
//! Each route is a function of named inputs with uncertainties, so that two routes know what they
//! share. The routes give the body as it hangs; [`HullShare`] brings them to the hull alone by the
//! joint estimate's own ratio (hull over hanging body), so that all figures of one quantity mean
//! the same thing.

mod heights;
mod inclines;
mod simplified;
mod swings;
mod tilts;

use gyradius_base::error::Result;
use gyradius_recording::{ModeName, Orientation};

use super::beats::CountedBeat;
use super::estimate::{Observed, Solution, System};
use super::measurement::Route;
use super::names::{Origin, QuantityName, RouteMethod};
use super::outputs::COVERAGE_95;
use super::parameters::{LEVEL_DEG, Reading};
use super::theory::{hull_alone, swing_body, world_from_hull};
use super::traced::Traced;

/// One route and what it gives.
pub struct RouteCalculation {
    /// Quantity.
    pub quantity: QuantityName,
    /// Method.
    pub method: RouteMethod,
    /// Equations of the paper.
    pub equation: &'static str,
    /// Swings or inclines it used.
    pub from: Vec<Origin>,
    /// What it gives.
    pub figure: Traced,
    /// Its 95 % interval where that is not ± 1.96 u.
    pub interval_95: Option<[f64; 2]>,
}

impl RouteCalculation {
    /// As it is written to the result.
    pub fn route(&self) -> Route {
        Route {
            method: self.method,
            value: self.figure.value,
            u: self.figure.u(),
            interval_95: self.interval_95.unwrap_or_else(|| {
                let half = COVERAGE_95 * self.figure.u();
                [self.figure.value - half, self.figure.value + half]
            }),
            equation: self.equation.into(),
            from: self.from.iter().map(Origin::to_string).collect(),
        }
    }
}

/// All single routes that a session's observations allow; `beats` are those counted in the swings'
/// records.
pub fn routes(
    system: &System,
    solution: &Solution,
    beats: &[Option<CountedBeat>],
) -> Vec<RouteCalculation> {
    let mut found = of_figures(system, solution, beats);
    simplified::widen(system, solution, &mut found);
    found
}

/// The routes on the figures as they stand in the system.
fn of_figures(
    system: &System,
    solution: &Solution,
    beats: &[Option<CountedBeat>],
) -> Vec<RouteCalculation> {
    let benches: Vec<Bench> = (0..system.session.swings.len())
        .filter_map(|i| Bench::of(system, solution, i))
        .collect();
    let mut found: Vec<RouteCalculation> = benches
        .iter()
        .flat_map(|bench| swings::routes(bench, solution, beats))
        .collect();
    found.extend(heights::routes(&benches));
    let rolls: Vec<&RouteCalculation> = found
        .iter()
        .filter(|r| r.quantity == QuantityName::KRoll)
        .collect();
    let tilted = tilts::routes(&benches, &rolls);
    found.extend(tilted);
    found.extend(inclines::routes(system, solution));
    found
}

/// Everything the routes draw on, for one swing.
struct Bench<'a> {
    system: &'a System<'a>,
    swing: usize,
    share: HullShare,
}

/// Hull-alone over hanging-body figures by the joint estimate: gyradii about the directions that
/// are x, y, z in this hanging, and the difference in depth.
struct HullShare {
    gyradii: [f64; 3],
    depth_m: f64,
}

impl<'a> Bench<'a> {
    fn of(system: &'a System<'a>, solution: &Solution, swing: usize) -> Option<Self> {
        let (layout, index) = (&system.layout, &system.layout.swings[swing]);
        let hanging = swing_body(layout, &solution.x, &system.session.swings[swing], index).ok()?;
        let alone = hull_alone(system.session, layout, &solution.x, index.log_depth).ok()?;
        let turned = alone.rotated(world_from_hull(&solution.x, index));
        let k = |body: &gyradius_mechanics::RigidBody, i: usize| {
            (body.inertia_kg_m2[(i, i)] / body.mass_kg).sqrt()
        };
        let gyradii = std::array::from_fn(|i| k(&turned, i) / k(&hanging, i));
        Some(Bench {
            system,
            swing,
            share: HullShare {
                gyradii,
                depth_m: hanging.cm_m.z - alone.cm_m.z,
            },
        })
    }

    fn period(&self, mode: ModeName) -> Option<Traced> {
        let found = self
            .system
            .periods
            .iter()
            .find(|o| o.what == Observed::Period(self.swing, mode))?;
        Some(Traced::input(found.label.to_string(), found.value))
    }

    fn stated(&self, index: Option<usize>) -> Option<Traced> {
        Some(stated(self.system, index?))
    }

    fn gravity(&self) -> Traced {
        stated(self.system, self.system.layout.gravity)
    }

    fn index(&self) -> &super::parameters::SwingIndex {
        &self.system.layout.swings[self.swing]
    }

    /// Half the stated spacing, as the paper's d.
    fn half_spacing(&self) -> Option<Traced> {
        Traced::combine(&[&self.stated(self.index().spacing)?], |v| Ok(0.5 * v[0])).ok()
    }

    fn orientation(&self) -> Orientation {
        self.system.session.swings[self.swing]
            .suspension
            .orientation
    }

    /// The gyradius that a compound pendulum on this suspension has, and the direction it turns
    /// about.
    fn compound_quantity(&self) -> (QuantityName, usize) {
        match self.orientation() {
            Orientation::Athwartships => (QuantityName::KPitch, 1),
            Orientation::ForeAndAft => (QuantityName::KRoll, 0),
        }
    }

    fn is_level(&self) -> bool {
        self.system.layout.parameters[self.index().pitch_deg]
            .prior
            .value
            .abs()
            < LEVEL_DEG
    }

    fn is_parallel(&self) -> bool {
        self.index().top_spacing == self.index().spacing
    }

    fn id(&self) -> String {
        self.system.session.swings[self.swing].id.clone()
    }

    /// A route through this swing alone; none where its equation has no answer.
    fn route(
        &self,
        (quantity, method, equation): (QuantityName, RouteMethod, &'static str),
        parts: &[&Traced],
        formula: impl Fn(&[f64]) -> Result<f64>,
    ) -> Option<RouteCalculation> {
        let figure = Traced::combine(parts, formula).ok()?;
        Some(RouteCalculation {
            quantity,
            method,
            equation,
            from: vec![Origin::Swing(self.id())],
            figure,
            interval_95: None,
        })
    }
}

/// A stated figure; the same figure stated for several swings is one input.
fn stated(system: &System, i: usize) -> Traced {
    let parameter = &system.layout.parameters[i];
    let own = Traced::input(format!("{} #{i}", parameter.name), parameter.prior);
    let shares = system.layout.shared.iter().filter_map(|one| {
        let of_this = |(reading, _): &&(Reading, f64)| *reading == Reading::Parameter(i);
        let (_, change) = one.readings.iter().find(of_this)?;
        Some((one.name.to_string(), *change))
    });
    own.sharing(shares)
}
