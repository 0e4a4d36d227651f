//! What is refused at the door: tasks, phones and dimensions that nothing could come of.

use std::collections::BTreeSet;
use std::path::Path;

use super::entry::{Entry, FORMAT};
use super::event::{Measured, PhoneInfo};
use super::journal::JOURNAL;
use super::memory::StepMemory;
use super::task::Task;
use gyradius_base::error::{Error, Result};
use gyradius_planning::Step;
use gyradius_recording::{Quantity, SuspensionKind};

/// A task that can be followed.
pub(super) fn task(task: &Task) -> Result<()> {
    if task.steps.is_empty() {
        return Err(Error::argument("steps", "at least one step", "none"));
    }
    let mut ids = BTreeSet::new();
    for step in &task.steps {
        if let Step::Swing(swing) = step {
            let id = &swing.id;
            if id.is_empty() || !ids.insert(id) {
                return Err(Error::argument(
                    "steps",
                    "swings with ids of their own",
                    format!("`{id}`"),
                ));
            }
            for (name, value) in [
                ("amplitude_deg", swing.amplitude_deg),
                ("duration_s", swing.duration_s),
                ("period_u_wanted", swing.period_u_wanted),
            ] {
                if !(value > 0.0 && value.is_finite()) {
                    return Err(Error::argument(
                        "steps",
                        format!("`{name}` of `{id}` above 0"),
                        value,
                    ));
                }
            }
        }
    }
    // Figures that are no numbers are lost in JSON: they must not become a journal that cannot be
    // read.
    let round = serde_json::to_string(task).and_then(|text| serde_json::from_str::<Task>(&text));
    round
        .map(|_| ())
        .map_err(|error| Error::argument("task", "numbers everywhere", error))
}

/// A journal of this format.
pub(super) fn format(folder: &Path, first: Option<&Entry>) -> Result<()> {
    let found = match first {
        Some(Entry::Created { format, .. }) => format.as_str(),
        _ => "another line",
    };
    let minor = found.strip_prefix(FORMAT);
    if minor.is_some_and(|rest| rest.is_empty() || rest.starts_with('.')) {
        return Ok(());
    }
    Err(Error::Malformed {
        file: folder.join(JOURNAL).display().to_string(),
        line: Some(1),
        expected: FORMAT.to_owned(),
        found: found.to_owned(),
    })
}

/// A phone whose figures are numbers.
pub(super) fn phone(phone: &PhoneInfo) -> Result<()> {
    let wrong = |scale: &f64| !(*scale > 0.0 && scale.is_finite());
    match phone
        .sensors
        .iter()
        .filter_map(|sensor| sensor.full_scale)
        .find(wrong)
    {
        Some(scale) => Err(Error::argument("phone", "`full_scale` above 0", scale)),
        None => Ok(()),
    }
}

/// Dimensions that can be computed with, and all that the step needs.
pub(super) fn measured(step: &StepMemory, measured: Measured) -> Result<()> {
    let lengths = [
        ("line_length_m", measured.line_length_m, true),
        ("spacing_m", measured.spacing_m, true),
        ("top_spacing_m", measured.top_spacing_m, true),
        ("axis_height_m", measured.axis_height_m, true),
        ("mass_kg", measured.mass_kg, true),
        ("arm_m", measured.arm_m, true),
        ("hull_pitch_deg", measured.hull_pitch_deg, false),
        ("points_moved_m", measured.points_moved_m, false),
        ("depth_m", measured.depth_m, false),
    ];
    for (name, quantity, positive) in lengths {
        let Some(Quantity { value, u }) = quantity else {
            continue;
        };
        let fine = value.is_finite() && (!positive || value > 0.0) && u >= 0.0 && u.is_finite();
        if !fine {
            let expected = if positive {
                "a number above 0 and its u"
            } else {
                "a number and its u"
            };
            return Err(Error::argument(name, expected, format!("{value} ± {u}")));
        }
    }
    match missing(step, measured) {
        Some(name) => Err(Error::argument(
            name,
            "to be measured for this step",
            "nothing",
        )),
        None => Ok(()),
    }
}

fn missing(step: &StepMemory, measured: Measured) -> Option<&'static str> {
    let first = |needed: &[(&'static str, bool)]| {
        needed
            .iter()
            .find(|(_, there)| !there)
            .map(|(name, _)| *name)
    };
    match &step.planned {
        Step::Incline(_) => first(&[
            ("mass_kg", measured.mass_kg.is_some()),
            ("arm_m", measured.arm_m.is_some()),
            ("depth_m", measured.depth_m.is_some()),
        ]),
        Step::Swing(swing) => match swing.suspension.kind {
            SuspensionKind::Free => None,
            SuspensionKind::Bifilar | SuspensionKind::Trifilar => first(&[
                (
                    "line_length_m",
                    measured
                        .line_length_m
                        .or(swing.suspension.line_length_m)
                        .is_some(),
                ),
                (
                    "spacing_m",
                    measured.spacing_m.or(swing.suspension.spacing_m).is_some(),
                ),
            ]),
            SuspensionKind::Compound => first(&[(
                "axis_height_m",
                measured
                    .axis_height_m
                    .or(swing.suspension.axis_height_m)
                    .is_some(),
            )]),
        },
    }
}
