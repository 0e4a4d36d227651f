//! Which stated figure is wrong in a session that contradicts itself: each, set free within what a
//! slip may be, is tried for whether it resolves the contradiction.
//!
//! One slip may stand in several places: a tape that was misread once and typed for every swing.
//! Readings of one kind with one figure are therefore set free together as well, as one unknown.

use gyradius_recording::SwingData;

use super::estimate::{Observed, Solution, System};
use super::names::{Input, InputKind};
use super::parameters::{Layout, Parameter, Reading, Role, SwingIndex};

/// Stated figures that may be wrong, with the width to which they are opened: a length that was
/// misread, gravity by a wrong altitude or sensor, a clock of a cheap logger, a protractor.
const SUSPECTS: [(InputKind, Opened); 8] = [
    (InputKind::LineLength, Opened::Relative(0.3)),
    (InputKind::Spacing, Opened::Relative(0.3)),
    (InputKind::TopSpacing, Opened::Relative(0.3)),
    (InputKind::AxisHeight, Opened::Relative(0.3)),
    (InputKind::Gravity, Opened::Relative(0.3)),
    (InputKind::PhoneClock, Opened::Absolute(0.1)),
    (InputKind::HullPitch, Opened::Absolute(10.0)),
    (InputKind::HullRoll, Opened::Absolute(10.0)),
];

/// A period that was typed in or listed.
const TYPED: Opened = Opened::Relative(0.3);

/// How far a suspect is opened.
#[derive(Debug, Clone, Copy)]
enum Opened {
    /// By this part of its value.
    Relative(f64),
    /// By so much, its own unit.
    Absolute(f64),
}

impl Opened {
    fn width(self, value: f64) -> f64 {
        match self {
            Self::Relative(part) => part * value.abs(),
            Self::Absolute(width) => width,
        }
    }

    fn of(kind: InputKind) -> Option<Self> {
        let known = SUSPECTS.iter().find(|(known, _)| *known == kind);
        known.map(|(_, opened)| *opened)
    }
}

/// By how much a stated figure may be wrong, its own unit; none of one that is no suspect.
pub(super) fn slip(stated: &Parameter) -> Option<f64> {
    Some(Opened::of(stated.name.kind)?.width(stated.prior.value))
}

/// A session with one suspect set free.
pub(super) struct Freed<'a> {
    /// What was set free; readings that share a slip have the ids of all their swings.
    pub suspect: Input,
    /// The session so opened.
    pub system: System<'a>,
    /// Its solution.
    pub solution: Solution,
}

/// The suspects each of which, set free within what a slip may be, resolves the contradiction. One
/// that would have to be wrong by more explains nothing.
pub(super) fn explanations<'a>(system: &System<'a>, solution: &Solution) -> Vec<Freed<'a>> {
    let figures = (0..system.layout.parameters.len()).map(|i| vec![i]);
    let together = same_figures(&system.layout);
    let figures = figures
        .chain(together)
        .filter_map(|group| figure(system, solution, &group));
    let periods = (0..system.observations.len()).filter_map(|k| period(system, solution, k));
    figures.chain(periods).collect()
}

/// Solves an opened session; none where it still contradicts itself, or where what was opened would
/// be off by more than its width.
fn freed<'a>(
    suspect: Input,
    system: System<'a>,
    start: &Solution,
    off: &dyn Fn(&Solution) -> f64,
) -> Option<Freed<'a>> {
    let solution = system.solve(&start.x).ok()?;
    (solution.birge == 1.0 && off(&solution) <= 1.0).then_some(Freed {
        suspect,
        system,
        solution,
    })
}

/// By how much readings of one stated figure may be wrong, and the session with them set free as one
/// unknown; none of what is no suspect.
pub(super) fn set_free<'a>(system: &System<'a>, group: &[usize]) -> Option<(f64, System<'a>)> {
    let (first, others) = group.split_first()?;
    let parameter = &system.layout.parameters[*first];
    let width = slip(parameter).filter(|_| parameter.role == Role::Stated)?;
    let mut layout = system.layout.clone();
    layout.parameters[*first].role = Role::Unknown;
    layout.parameters[*first].prior.u = width;
    others.iter().for_each(|other| layout.tie(*other, *first));
    Some((width, system.with(layout)))
}

/// Readings of one figure set free as one unknown.
fn figure<'a>(system: &System<'a>, start: &Solution, group: &[usize]) -> Option<Freed<'a>> {
    let (first, others) = group.split_first()?;
    let parameter = &system.layout.parameters[*first];
    let (stated, (width, opened)) = (parameter.prior.value, set_free(system, group)?);
    let suspect = match others {
        [] => parameter.name.clone(),
        _ => Input::of(parameter.name.kind, &read_for(system, group).join(", ")),
    };
    let mut found = freed(suspect, opened, start, &|solution| {
        (solution.x[*first] - stated).abs() / width
    })?;
    // Who looks for one of the readings finds it where the slip puts it.
    others
        .iter()
        .for_each(|other| found.solution.x[*other] = found.solution.x[*first]);
    Some(found)
}

/// A period that somebody wrote down may be misread, or another motion's.
fn period<'a>(system: &System<'a>, start: &Solution, k: usize) -> Option<Freed<'a>> {
    let observation = &system.observations[k];
    let Observed::Period(swing, _) = observation.what else {
        return None;
    };
    let data = &system.session.swings[swing].data;
    if !matches!(data, SwingData::PeriodsS(_) | SwingData::Periods(_)) {
        return None;
    }
    let mut opened = system.with(system.layout.clone());
    opened.observations[k].value.u = TYPED.width(observation.value.value);
    freed(observation.label.clone(), opened, start, &|solution| {
        let rows = system.with_opened(k, solution);
        rows.unwrap_or(f64::INFINITY)
    })
}

/// What was read of a swing's suspension.
fn readings(swing: &SwingIndex) -> [Option<usize>; 6] {
    [
        swing.line_length,
        swing.spacing,
        swing.top_spacing,
        swing.axis_height,
        Some(swing.pitch_deg),
        swing.roll_deg,
    ]
}

/// Readings of one kind with the same figure, two or more together.
pub(super) fn same_figures(layout: &Layout) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for i in layout.swings.iter().flat_map(readings).flatten() {
        let is_same = |group: &&mut Vec<usize>| {
            let [known, new] = [group[0], i].map(|k| &layout.parameters[k]);
            known.name == new.name && known.prior.value == new.prior.value
        };
        match groups.iter_mut().find(is_same) {
            Some(group) if group.contains(&i) => {}
            Some(group) => group.push(i),
            None => groups.push(vec![i]),
        }
    }
    groups.retain(|group| group.len() > 1);
    groups
}

/// The ids of the swings that readings are of.
pub(super) fn read_for<'a>(system: &System<'a>, group: &[usize]) -> Vec<&'a str> {
    let swings = system.session.swings.iter().zip(&system.layout.swings);
    let is_its = |index: &SwingIndex| readings(index).iter().flatten().any(|i| group.contains(i));
    swings
        .filter(|(_, index)| is_its(index))
        .map(|(swing, _)| swing.id.as_str())
        .collect()
}

impl Layout {
    /// Puts one parameter in the place of another wherever a swing has that; the other stays as it
    /// was stated, and nothing depends on it.
    fn tie(&mut self, other: usize, to: usize) {
        let put = |place: &mut usize| {
            if *place == other {
                *place = to;
            }
        };
        for swing in &mut self.swings {
            put(&mut swing.pitch_deg);
            let read = [
                &mut swing.line_length,
                &mut swing.spacing,
                &mut swing.top_spacing,
                &mut swing.axis_height,
                &mut swing.roll_deg,
            ];
            read.into_iter().flatten().for_each(put);
        }
        for shared in &mut self.shared {
            let is_other = |(reading, _): &(Reading, f64)| *reading == Reading::Parameter(other);
            shared.readings.retain(|one| !is_other(one));
        }
    }
}

impl System<'_> {
    /// How far an observation is from what a solution has for it, in the width that it is opened to.
    fn with_opened(&self, k: usize, solution: &Solution) -> Option<f64> {
        let rows = self.plain_rows(&solution.x, &solution.free)?;
        let stated = self.observations[k].value;
        Some(rows[k].abs() * stated.u / TYPED.width(stated.value))
    }
}
