//! The `[[swing]]` tables of `session.toml`.

use std::collections::BTreeMap;

use super::domain::Domain;
use super::keys::{Field, Table};
use super::named_file::NamedFile;
use super::names::{EXCITATIONS, KINDS, MODES, ORIENTATIONS};
use super::quantity::Quantity;
use super::session::{
    AddedMass, ModeName, Orientation, Suspension, SuspensionKind, Swing, SwingData,
};
use gyradius_base::error::Result;

/// Keys of a swing.
pub const SWING: &[&str] = &[
    "id",
    "recording",
    "displacement",
    "at",
    "periods",
    "periods_s",
    "amplitude_deg",
    "excited",
    "added_mass",
    "suspension",
];
const SUSPENSION: &[&str] = &[
    "kind",
    "orientation",
    "line_length",
    "spacing",
    "top_spacing",
    "hull_pitch_deg",
    "points_moved",
    "axis_height",
    "radius",
    "top_radius",
];
/// The figures of suspensions: key, what it is, what it may be.
const FIGURES: [(&str, &str, Domain); 8] = [
    ("line_length", "length of the lines, m", Domain::LENGTH),
    (
        "spacing",
        "between the points on the hull, m",
        Domain::LENGTH,
    ),
    ("top_spacing", "between the points above, m", Domain::LENGTH),
    (
        "radius",
        "of the circle through the line ends below, m",
        Domain::LENGTH,
    ),
    (
        "top_radius",
        "of the circle through the line ends above, m",
        Domain::LENGTH,
    ),
    ("hull_pitch_deg", "bow up, degrees", Domain::PITCH),
    (
        "points_moved",
        "of the points, forward from level hanging, m",
        Domain::COORDINATE,
    ),
    (
        "axis_height",
        "height l0 of the swing axis above the suspension points, m",
        Domain::LENGTH,
    ),
];
const ADDED_MASS: &[&str] = &["mass", "position"];
const DATA: &[&str] = &["recording", "displacement", "periods", "periods_s"];

pub(crate) const POSITION: &str =
    "[x, y, z] in m, hull axes, from the mid-point of the suspension points";

/// One swing; `before` are those read so far, whose ids are taken.
pub(crate) fn swing(
    table: &Table<'_>,
    before: &[Swing],
    files: &mut Vec<NamedFile>,
) -> Result<Swing> {
    let id = id(table, before)?;
    let data = data(table, files)?;
    let amplitude_deg = amplitudes(table, &data)?;
    let excited = table
        .get("excited")
        .map(|field| field.choices(EXCITATIONS))
        .transpose()?;
    let added = table.tables("added_mass", ADDED_MASS)?;
    let suspension = table.require("suspension", "how it hung, as [swing.suspension]")?;
    Ok(Swing {
        id,
        data,
        excited: excited.unwrap_or_default(),
        added_masses: added.iter().map(added_mass).collect::<Result<_>>()?,
        amplitude_deg,
        suspension: self::suspension(&suspension.table(SUSPENSION)?)?,
    })
}

fn id(table: &Table<'_>, before: &[Swing]) -> Result<String> {
    let field = table.require("id", "a name of its own")?;
    let id = field.text()?;
    if id.trim().is_empty() || id.chars().any(char::is_control) {
        return Err(field.error(
            format!("`{}` to be a name in one line", field.path),
            format!("{id:?}"),
        ));
    }
    if before.iter().any(|swing| swing.id == id) {
        return Err(field.error(
            format!("`{}` to be unlike all before it", field.path),
            format!("{id:?} again"),
        ));
    }
    Ok(id.into())
}

fn data(table: &Table<'_>, files: &mut Vec<NamedFile>) -> Result<SwingData> {
    let source = table.exactly_one(DATA)?;
    if source.key != "displacement" {
        table.refuse(&["at"], "it serves only beside `displacement`")?;
    }
    if source.key == "periods_s" {
        return periods(&source).map(SwingData::PeriodsS);
    }
    let file = source.file_name()?;
    files.push(NamedFile::new(&source, &file));
    Ok(match source.key.as_str() {
        "recording" => SwingData::Recording(file),
        "periods" => SwingData::Periods(file),
        _ => {
            let at_m = table
                .get("at")
                .map(|field| field.vector(Domain::COORDINATE))
                .transpose()?;
            SwingData::Displacement { file, at_m }
        }
    })
}

fn periods(field: &Field<'_>) -> Result<BTreeMap<ModeName, Quantity>> {
    let periods = field.by_name(MODES)?;
    if periods.is_empty() {
        return Err(field.error(format!("at least one period in `{}`", field.path), "none"));
    }
    periods
        .iter()
        .map(|(mode, value)| Ok((*mode, value.quantity(Domain::PERIOD)?)))
        .collect()
}

/// Amplitudes belong to periods that a person or a gate wrote down; a recording shows its own.
fn amplitudes(table: &Table<'_>, data: &SwingData) -> Result<BTreeMap<ModeName, f64>> {
    let Some(field) = table.get("amplitude_deg") else {
        return Ok(BTreeMap::new());
    };
    if matches!(
        data,
        SwingData::Recording(_) | SwingData::Displacement { .. }
    ) {
        table.refuse(
            &["amplitude_deg"],
            "it serves only beside `periods_s` or `periods`",
        )?;
    }
    let mut amplitudes = BTreeMap::new();
    for (mode, value) in field.by_name(MODES)? {
        if matches!(data, SwingData::PeriodsS(periods) if !periods.contains_key(&mode)) {
            return Err(value.error(
                format!("a period of `{}` in `periods_s`", value.key),
                "only its amplitude",
            ));
        }
        amplitudes.insert(mode, value.number(Domain::AMPLITUDE)?);
    }
    Ok(amplitudes)
}

fn added_mass(table: &Table<'_>) -> Result<AddedMass> {
    Ok(AddedMass {
        mass_kg: table.require("mass", "kg")?.quantity(Domain::MASS)?,
        position_m: table
            .require("position", POSITION)?
            .vector(Domain::COORDINATE)?,
    })
}

fn suspension(table: &Table<'_>) -> Result<Suspension> {
    let kind = table
        .require("kind", "bifilar, compound, trifilar or free")?
        .choice(KINDS)?;
    for key in FIGURES.map(|(key, ..)| key) {
        let why_not = kind.why_not(key);
        if !why_not.is_empty() {
            table.refuse(&[key], &why_not)?;
        }
    }
    let orientation = match table.get("orientation") {
        None if !kind.has_direction() => Orientation::Athwartships,
        None => table
            .require("orientation", "athwartships or fore_and_aft")?
            .choice(ORIENTATIONS)?,
        Some(field) => field.choice(ORIENTATIONS)?,
    };
    let mut suspension = Suspension::unmeasured(kind, orientation);
    for (key, what, domain) in FIGURES {
        if kind.needs().contains(&key) {
            table.require(key, what)?;
        }
        suspension.set_figure(key, table.quantity(key, domain)?);
    }
    refuse_lines_too_short(table, &suspension)?;
    Ok(suspension)
}

/// Lines that lean outwards by more than their length cannot hang.
fn refuse_lines_too_short(table: &Table<'_>, suspension: &Suspension) -> Result<()> {
    let (Some(length), Some(spacing), Some(top)) = (
        suspension.line_length_m,
        suspension.spacing_m,
        suspension.top_spacing_m,
    ) else {
        return Ok(());
    };
    let lean = (top.value - spacing.value).abs() / 2.0;
    if lean < length.value {
        return Ok(());
    }
    let keys = match suspension.kind {
        SuspensionKind::Trifilar => ["top_radius", "radius"],
        _ => ["top_spacing", "spacing"],
    };
    let [above, below] = keys.map(|key| suspension.figure(key).map_or(0.0, |one| one.value));
    let place = table.require(keys[0], "between the points above, m")?;
    Err(place.error(
        format!(
            "`{}` that lines of {} m can reach from `{}` {below} m",
            place.path, length.value, keys[1]
        ),
        format!("{above} m"),
    ))
}
