//! The `[[swing]]` tables of `session.toml`.

use std::collections::{BTreeMap, BTreeSet};

use super::domain::Domain;
use super::keys::{Field, Table};
use super::named_file::NamedFile;
use super::names::{EXCITATIONS, KINDS, MODES, ORIENTATIONS};
use super::quantity::Quantity;
use super::same_hanging::HungAs;
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
    "same_as",
    "kind",
    "orientation",
    "line_length",
    "spacing",
    "top_spacing",
    "hull_pitch_deg",
    "hull_roll_deg",
    "points_m",
    "points_moved",
    "axis_height",
    "radius",
    "top_radius",
];
/// The sine of 3°: what hangs further askew is another suspension, and by less the spacing along
/// the axis is right to 0.14 %.
const MOST_ASKEW: f64 = 0.0523;
/// The figures of suspensions: key, what it is, what it may be.
const FIGURES: [(&str, &str, Domain); 9] = [
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
    ("hull_roll_deg", "starboard down, degrees", Domain::PITCH),
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
    hung_as: &mut BTreeMap<String, HungAs>,
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
    let hung = suspension.table(SUSPENSION)?;
    let first = same_as(&hung, before)?;
    let suspension = self::suspension(&hung, first.map(|swing| &swing.suspension))?;
    if let Some(first) = first {
        let but_for = stated(&hung);
        let swing = first.id.clone();
        hung_as.insert(id.clone(), HungAs { swing, but_for });
    }
    Ok(Swing {
        id,
        data,
        excited: excited.unwrap_or_default(),
        added_masses: added.iter().map(added_mass).collect::<Result<_>>()?,
        amplitude_deg,
        suspension,
    })
}

/// The swing before that this one hangs as, but for what is stated beside.
fn same_as<'a>(table: &Table<'_>, before: &'a [Swing]) -> Result<Option<&'a Swing>> {
    let Some(field) = table.get("same_as") else {
        return Ok(None);
    };
    table.refuse(&["kind"], "it is that of the swing that `same_as` names")?;
    let id = field.text()?;
    let first = before.iter().find(|swing| swing.id == id);
    let error = || {
        let ids: Vec<&str> = before.iter().map(|swing| swing.id.as_str()).collect();
        let before = if ids.is_empty() {
            "none".to_owned()
        } else {
            ids.join(", ")
        };
        field.error(
            format!(
                "`{}` to be the id of a swing before this one ({before})",
                field.path
            ),
            format!("{id:?}"),
        )
    };
    first.map(Some).ok_or_else(error)
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

/// Keys of the figures that a table states; points are a spacing.
fn stated(table: &Table<'_>) -> BTreeSet<String> {
    let figures = FIGURES.map(|(key, ..)| (key, key));
    let each = figures.into_iter().chain([("points_m", "spacing")]);
    each.filter(|(key, _)| table.get(key).is_some())
        .map(|(_, figure)| figure.to_owned())
        .collect()
}

/// How a swing hung; `first` is how the swing did that it hangs as.
fn suspension(table: &Table<'_>, first: Option<&Suspension>) -> Result<Suspension> {
    let kind = match first {
        Some(first) => first.kind,
        None => table
            .require("kind", "bifilar, compound, trifilar or free")?
            .choice(KINDS)?,
    };
    for key in FIGURES.map(|(key, ..)| key) {
        let why_not = kind.why_not(key);
        if !why_not.is_empty() {
            table.refuse(&[key], &why_not)?;
        }
    }
    let orientation = match (table.get("orientation"), first) {
        (None, Some(first)) => first.orientation,
        (None, None) if !kind.has_direction() => Orientation::Athwartships,
        (None, None) => table
            .require("orientation", "athwartships or fore_and_aft")?
            .choice(ORIENTATIONS)?,
        (Some(field), _) => field.choice(ORIENTATIONS)?,
    };
    let points = points(table, kind, orientation)?;
    let mut suspension = Suspension::unmeasured(kind, orientation);
    let unstated = Suspension::unmeasured(kind, orientation);
    let kept = first.map(|first| first.but_for(&BTreeSet::new(), &unstated));
    for (key, what, domain) in FIGURES {
        // The points say how far apart they are.
        let is_told = key == "spacing" && points.is_some()
            || kept.as_ref().is_some_and(|kept| kept.figure(key).is_some());
        if kind.needs().contains(&key) && !is_told {
            table.require(key, what)?;
        }
        suspension.set_figure(key, table.quantity(key, domain)?);
    }
    if let Some((points, apart)) = points {
        (suspension.points_m, suspension.spacing_m) = (Some(points), Some(apart));
    }
    if let Some(first) = first {
        suspension = first.but_for(&stated(table), &suspension);
    }
    refuse_lines_too_short(table, &suspension)?;
    Ok(suspension)
}

/// The two points of suspension, and how far apart they are: along the suspension, at one height.
fn points(
    table: &Table<'_>,
    kind: SuspensionKind,
    orientation: Orientation,
) -> Result<Option<(Vec<[f64; 3]>, Quantity)>> {
    let Some(field) = table.get("points_m") else {
        return Ok(None);
    };
    if kind != SuspensionKind::Bifilar {
        table.refuse(&["points_m"], "two points are those of kind = \"bifilar\"")?;
    }
    table.refuse(&["spacing"], "`points_m` say how far apart the points are")?;
    let both = field.vectors(Domain::COORDINATE)?;
    let expected = || format!("`{}` to be two points, [[x, y, z], [x, y, z]]", field.path);
    let &[one, other] = both.as_slice() else {
        return Err(field.error(expected(), format!("{} points", both.len())));
    };
    let along: [f64; 3] = std::array::from_fn(|i| other[i] - one[i]);
    let spacing = along.iter().fold(0.0, |sum: f64, part| sum.hypot(*part));
    let (axis, beside) = match orientation {
        Orientation::Athwartships => ("athwartships", [along[0], along[2]]),
        Orientation::ForeAndAft => ("fore and aft", [along[1], along[2]]),
    };
    let across = beside[0].hypot(beside[1]);
    if spacing == 0.0 || across > MOST_ASKEW * spacing {
        return Err(field.error(
            format!("{}, {axis} of one another at one height", expected()),
            format!("{across} m beside that line in {spacing} m"),
        ));
    }
    let apart = field.with_usual_u(spacing, Domain::LENGTH, false);
    Ok(Some((both, apart)))
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
    let expected = format!(
        "`{}` that lines of {} m can reach from `{}` {below} m",
        table.path_of(keys[0]),
        length.value,
        keys[1]
    );
    let found = format!("{above} m");
    // It may be that of the swing that this one hangs as.
    Err(match table.get(keys[0]) {
        Some(place) => place.error(expected, found),
        None => table.error(expected, found),
    })
}
