//! The consistency tests: every stated dimension against what the swings imply, every route against
//! every other.
//!
//! They are made unasked; what differs by more than [`FLAG_SIGMA`] standard uncertainties is
//! flagged.

use std::collections::BTreeMap;

use gyradius_base::message::{Argument, Message, spaced};
use gyradius_recording::{ModeName, Quantity};

use super::alternatives::RouteCalculation;
use super::estimate::{Derived, Observed, Solution, System};
use super::measurement::Claim;
use super::names::{InputKind, QuantityName, RouteMethod, Subject};
use super::routes::ratio::line_length_m;
use super::sentences::{inputs, message, name, origins};
use super::suspects::{same_figures, set_free};

/// A difference this large speaks up: chance does that once in 370 for a normal error.
pub const FLAG_SIGMA: f64 = 3.0;
/// Stated figures that are held against the rest.
const TESTABLE: [InputKind; 4] = [
    InputKind::LineLength,
    InputKind::Spacing,
    InputKind::TopSpacing,
    InputKind::Gravity,
];
/// Figures of which it is told where nothing tests them.
const TO_BE_TESTED: [InputKind; 5] = [
    InputKind::Spacing,
    InputKind::TopSpacing,
    InputKind::LineLength,
    InputKind::AxisHeight,
    InputKind::PhoneClock,
];
/// An implied figure less certain than this part of what a slip may be says nothing about a slip.
const SAYS_NOTHING: f64 = 1.0 / 6.0;

/// The consistency tests of a session.
pub struct ConsistencyTests {
    /// Comparisons, the worst first.
    pub claims: Vec<Claim>,
    /// Stated figures, and by how much each could be wrong without being flagged.
    pub hidden: Vec<Hidden>,
}

/// Readings of one stated figure (parameters), and by how much it could be wrong without being flagged,
/// its own unit.
pub struct Hidden {
    /// The readings.
    pub readings: Vec<usize>,
    /// The error.
    pub error: f64,
}

/// Every consistency test of a session.
pub fn consistency_tests(
    system: &System,
    solution: &Solution,
    routes: &[RouteCalculation],
) -> ConsistencyTests {
    let mut claims = sway_against_tape(system);
    let (stated, mut hidden) = stated_against_the_rest(system, solution);
    // A tape that was misread once may have been typed for several swings.
    let together = same_figures(&system.layout).into_iter();
    let together = together.filter(|group| {
        let kind = system.layout.parameters[group[0]].name.kind;
        TO_BE_TESTED.contains(&kind)
    });
    hidden.extend(together.filter_map(|group| {
        let implied = Implied::of(system, solution, &group)?;
        Some(implied.hidden(group))
    }));
    claims.extend(stated);
    claims.extend(route_against_route(routes));
    claims.sort_by(|a, b| b.sigma.total_cmp(&a.sigma));
    ConsistencyTests { claims, hidden }
}

/// Each sway period against the length of the lines, eq. (7) turned round: l = g T² / 4π².
fn sway_against_tape(system: &System) -> Vec<Claim> {
    let gravity = system.layout.parameters[system.layout.gravity].prior;
    system
        .periods
        .iter()
        .filter_map(|o| {
            let Observed::Period(i, ModeName::Sway) = o.what else {
                return None;
            };
            let index = &system.layout.swings[i];
            if index.top_spacing != index.spacing {
                return None;
            }
            let stated = system.layout.parameters[index.line_length?].prior;
            let implied = line_length_m(o.value.value, gravity.value).ok()?;
            let relative = (2.0 * o.value.u / o.value.value).hypot(gravity.u / gravity.value);
            let implied = Quantity::new(implied, implied * relative);
            let swing = Argument::Id(system.session.swings[i].id.clone());
            Some(claim(
                InputKind::LineLength,
                stated,
                implied,
                message("by_sway", [("swing", swing)]),
            ))
        })
        .collect()
}

/// Each stated dimension freed, and the session solved without it; and what of an error that leaves
/// hidden.
fn stated_against_the_rest(system: &System, solution: &Solution) -> (Vec<Claim>, Vec<Hidden>) {
    let parameters = system.layout.parameters.iter().enumerate();
    let is_asked = |(i, kind): (usize, InputKind)| match kind {
        // What all swings share of it.
        InputKind::PhoneClock => i == system.layout.clock,
        _ => TESTABLE.contains(&kind) || TO_BE_TESTED.contains(&kind),
    };
    let asked = parameters.filter(|(i, p)| is_asked((*i, p.name.kind)));
    // Of figures that were stated alike for several swings the worst is told.
    let (mut worst, mut hidden): (Vec<Claim>, _) = (vec![], vec![]);
    for (i, parameter) in asked {
        let kind = parameter.name.kind;
        let Some(implied) = Implied::of(system, solution, &[i]) else {
            continue;
        };
        if TO_BE_TESTED.contains(&kind) {
            hidden.push(implied.hidden(vec![i]));
        }
        if !TESTABLE.contains(&kind) || !implied.says_something() {
            continue;
        }
        let claim = implied.claim(kind);
        let is_alike = |known: &&mut Claim| {
            (known.claim == claim.claim)
                && (known.stated, known.stated_u) == (claim.stated, claim.stated_u)
        };
        match worst.iter_mut().find(is_alike) {
            Some(known) if known.sigma >= claim.sigma => {}
            Some(known) => *known = claim,
            None => worst.push(claim),
        }
    }
    (worst, hidden)
}

/// A stated figure set free within what a slip may be, as the rest of the session has it then.
struct Implied<'a> {
    stated: Quantity,
    width: f64,
    opened: System<'a>,
    freed: Solution,
    derived: Derived,
}

impl<'a> Implied<'a> {
    fn of(system: &System<'a>, solution: &Solution, group: &[usize]) -> Option<Self> {
        let first = *group.first()?;
        let (width, opened) = set_free(system, group)?;
        let freed = opened.solve(&solution.x).ok()?;
        let derived = freed.derive(&opened.layout, |x| Some(x[first]))?;
        Some(Self {
            stated: system.layout.parameters[first].prior,
            width,
            opened,
            freed,
            derived,
        })
    }

    fn hidden(&self, readings: Vec<usize>) -> Hidden {
        let error = FLAG_SIGMA * self.derived.u.hypot(self.stated.u);
        Hidden {
            readings,
            error: error.min(self.width),
        }
    }

    fn says_something(&self) -> bool {
        self.derived.u <= SAYS_NOTHING * self.width
    }

    fn claim(&self, kind: InputKind) -> Claim {
        let budget = super::outputs::budget(&self.opened, &self.freed, &self.derived);
        let largest = budget.iter().take(2).map(|line| &line.input);
        let by = message("by_all", [("inputs", inputs(largest))]);
        let implied = Quantity::new(self.derived.value, self.derived.u);
        claim(kind, self.stated, implied, by)
    }
}

fn claim(kind: InputKind, stated: Quantity, implied: Quantity, by: Message) -> Claim {
    let sigma =
        (implied.value - stated.value).abs() / stated.u.hypot(implied.u).max(f64::MIN_POSITIVE);
    let bare = bare_claim(
        Subject::Stated(kind),
        (stated, implied),
        sigma,
        by.english.clone(),
    );
    bare.told(message(
        "stated",
        [
            ("name", Argument::Texts(vec![kind.in_words()])),
            ("stated", figure(&stated, kind.unit())),
            ("by", Argument::Texts(vec![by])),
            ("implied", figure(&implied, kind.unit())),
            ("verdict", verdict(sigma)),
            ("sigma", Argument::Number(sigma, 1)),
        ],
    ))
}

fn bare_claim(
    claim: Subject,
    (stated, implied): (Quantity, Quantity),
    sigma: f64,
    from: String,
) -> Claim {
    Claim {
        claim,
        stated: stated.value,
        stated_u: stated.u,
        implied: implied.value,
        implied_u: implied.u,
        sigma,
        from,
        flagged: sigma > FLAG_SIGMA,
        message: Message::default(),
        pairs: 1,
        sigma_range: None,
    }
}

fn figure(value: &Quantity, unit: &str) -> Argument {
    Argument::Figure(
        format!("{:.4} ± {:.4} {unit}", value.value, value.u)
            .trim_end()
            .into(),
    )
}

fn verdict(sigma: f64) -> Argument {
    name(if sigma > FLAG_SIGMA {
        "contradict"
    } else {
        "agree"
    })
}

/// Single routes to the same quantity, method against method: of all pairs of swings the one that
/// differs most.
fn route_against_route(routes: &[RouteCalculation]) -> Vec<Claim> {
    let mut by_methods: BTreeMap<(&QuantityName, RouteMethod, RouteMethod), Vec<Pair>> =
        BTreeMap::new();
    for (i, a) in routes.iter().enumerate() {
        for b in routes[i + 1..].iter().filter(|b| b.quantity == a.quantity) {
            let (first, second) = if a.method <= b.method { (a, b) } else { (b, a) };
            let pairs = by_methods
                .entry((&a.quantity, first.method, second.method))
                .or_default();
            pairs.extend(Pair::of(first, second));
        }
    }
    by_methods
        .into_values()
        .filter_map(|pairs| worst_of(&pairs))
        .collect()
}

/// Two routes and how far apart they are; inputs they share cancel in the difference as they
/// should.
struct Pair<'a> {
    first: &'a RouteCalculation,
    second: &'a RouteCalculation,
    sigma: f64,
}

impl<'a> Pair<'a> {
    /// Two routes through the very same figures are one route.
    fn of(first: &'a RouteCalculation, second: &'a RouteCalculation) -> Option<Self> {
        let u = first.figure.u_of_difference(&second.figure);
        let sigma = (first.figure.value - second.figure.value).abs() / u;
        (u > 1e-9 * first.figure.value.abs()).then_some(Pair {
            first,
            second,
            sigma,
        })
    }
}

fn worst_of(pairs: &[Pair]) -> Option<Claim> {
    let worst = pairs.iter().max_by(|a, b| a.sigma.total_cmp(&b.sigma))?;
    let least = pairs.iter().map(|p| p.sigma).fold(f64::INFINITY, f64::min);
    let quantity = |r: &RouteCalculation| Quantity::new(r.figure.value, r.figure.u());
    let (first, second) = (quantity(worst.first), quantity(worst.second));
    let about = &worst.first.quantity;
    let unit = about.unit();
    let way = |r: &RouteCalculation| name(&format!("route.{}", r.method));
    let told = message(
        "against",
        [
            ("quantity", name(&format!("quantity.{about}"))),
            ("one", way(worst.first)),
            ("one_from", origins(&worst.first.from)),
            ("first", figure(&first, unit)),
            ("other", way(worst.second)),
            ("other_from", origins(&worst.second.from)),
            ("second", figure(&second, unit)),
            ("verdict", verdict(worst.sigma)),
            ("sigma", Argument::Number(worst.sigma, 1)),
            (
                "pairs",
                Argument::Texts(others(pairs.len(), [least, worst.sigma])),
            ),
        ],
    );
    let from = format!(
        "{} against {}",
        spaced(worst.second.method.name()),
        spaced(worst.first.method.name())
    );
    let sigma_range = (pairs.len() > 1).then_some([least, worst.sigma]);
    let bare = bare_claim(
        Subject::Quantity(about.clone()),
        (first, second),
        worst.sigma,
        from,
    );
    Some(
        Claim {
            pairs: pairs.len(),
            sigma_range,
            ..bare
        }
        .told(told),
    )
}

/// How far all pairs of swings differ by the same two ways, where there are several.
fn others(count: usize, [least, most]: [f64; 2]) -> Vec<Message> {
    let arguments = [
        ("count", count as f64, 0),
        ("least", least, 1),
        ("most", most, 1),
    ];
    let told = || {
        message(
            "pairs",
            arguments.map(|(name, value, places)| (name, Argument::Number(value, places))),
        )
    };
    (count > 1).then(told).into_iter().collect()
}

impl Claim {
    /// With its sentence.
    fn told(self, message: Message) -> Self {
        Self { message, ..self }
    }
}
