//! `session.toml` read into a [`Session`], every error with file, line and what was expected.
//!
//! The format is described in this folder's `README.md`.

use std::cell::RefCell;

use toml_edit::Document;

use super::domain::Domain;
use super::keys::{AssumedU, Field, ReadWith, Source, Table};
use super::named_file::NamedFile;
use super::names::{INSTRUMENTS, name_of};
use super::session::{Attachment, Body, End, Incline, InclineAngle, Instrument, Session, Site};
use super::toml_recorded::{RECORDED, recorded};
use super::toml_swing::{POSITION, SWING, swing};
use gyradius_base::error::Result;

/// Name and major version of the format, without the minor version that a text may add.
pub(crate) const FORMAT: &str = "gyradius-session/1";

/// Keys of a session file's root.
pub const ROOT: &[&str] = &[
    "format",
    "title",
    "measured_on",
    "phone",
    "logger",
    "body",
    "site",
    "attachment",
    "swing",
    "incline",
    "recorded",
    "instrument",
];
const BODY: &[&str] = &["name", "mass", "length_overall", "density"];
const SITE: &[&str] = &["gravity", "latitude_deg", "altitude", "air_density"];
const ATTACHMENT: &[&str] = &["name", "mass", "position", "gyradii"];
const INSTRUMENT: &[&str] = &["id", "kind", "scale_u", "zero_u"];
const INCLINE: &[&str] = &["end", "mass", "arm", "depth", "angle_deg", "recording"];

/// Density of the air where none is stated, kg/m³ (ISO 2533 standard atmosphere, sea level); for a
/// check only.
const SEA_LEVEL_AIR_KG_M3: f64 = 1.225;

/// Longest text that is looked at, bytes; a session with a hundred swings has 50 kB.
const MAX_TEXT_BYTES: usize = 4 << 20;

/// A session and the places where it names files.
#[derive(Debug)]
pub struct ParsedSession {
    /// The session.
    pub session: Session,
    /// The files that it names.
    pub(crate) files: Vec<NamedFile>,
    /// Figures that are stated without an uncertainty.
    pub assumed: Vec<AssumedU>,
}

/// Reads the text of a `session.toml`; `file_name` is what messages call it.
pub fn read_session(text: &str, file_name: &str) -> Result<Session> {
    parse_session(text, file_name).map(|parsed| parsed.session)
}

/// The same with what the text says beside the session's figures.
pub fn parse_session(text: &str, file_name: &str) -> Result<ParsedSession> {
    with_root(text, file_name, ROOT, FORMAT, |root| session(root, SWING))
}

/// Reads the tables of a text that begins with `format = "…"`, this version or a minor one of it.
pub fn with_root<T>(
    text: &str,
    file_name: &str,
    known: &[&'static str],
    format: &str,
    read: impl FnOnce(&Table<'_>) -> Result<T>,
) -> Result<T> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let noted = RefCell::default();
    let source = Source {
        file: file_name,
        text,
        noted: &noted,
    };
    refuse_size(source, format)?;
    let document = Document::parse(text).map_err(|error| {
        let line = error.span().map(|span| source.line(span.start));
        source.malformed(line, "TOML", error.message().replace('\n', ", "))
    })?;
    let root = Table::root(source, document.as_table(), known);
    check_format(&root, format)?;
    root.refuse_unknown()?;
    read(&root)
}

fn refuse_size(source: Source<'_>, format: &str) -> Result<()> {
    let needs = || format!("a text that starts with `format = \"{format}\"`");
    if source.text.trim().is_empty() {
        return Err(source.malformed(None, needs(), "an empty file"));
    }
    if source.text.len() > MAX_TEXT_BYTES {
        return Err(source.malformed(
            None,
            needs(),
            format!("a text of {} bytes", source.text.len()),
        ));
    }
    Ok(())
}

/// A session from its tables; the keys that a swing may have are given.
pub fn session<'a>(root: &Table<'a>, of_swing: &'a [&'static str]) -> Result<ParsedSession> {
    let mut files = Vec::new();
    let body = body(
        &root
            .require("body", "the body that swings, as [body]")?
            .table(BODY)?,
    )?;
    let site = root
        .get("site")
        .map_or(Ok(Site::default()), |field| site(&field.table(SITE)?))?;
    refuse_lighter_than_air(root, &body, &site)?;
    let attachments = root.tables("attachment", ATTACHMENT)?;
    let attachments = attachments
        .iter()
        .map(attachment)
        .collect::<Result<Vec<_>>>()?;
    refuse_heavier_than_body(root, &body, &attachments)?;
    let mut session = Session {
        title: root.text_or_empty("title")?,
        measured_on: root.text_or_empty("measured_on")?,
        phone: root.text_or_empty("phone")?,
        logger: root.text_or_empty("logger")?,
        body,
        site,
        attachments,
        ..Session::default()
    };
    for table in root.tables("swing", of_swing)? {
        let next = swing(&table, &session.swings, &mut files, &mut session.hung_as)?;
        session.swings.push(next);
    }
    for table in root.tables("incline", INCLINE)? {
        session.inclines.push(incline(&table, &mut files)?);
    }
    for table in root.tables("recorded", RECORDED)? {
        session.recorded.push(recorded(&table, &mut files)?);
    }
    if session.swings.is_empty() && session.inclines.is_empty() {
        return Err(root.error("at least one [[swing]] or [[incline]]", "none"));
    }
    for table in root.tables("instrument", INSTRUMENT)? {
        let next = instrument(&table, &session.instruments)?;
        session.instruments.push(next);
    }
    let noted = root.noted();
    for figure in noted.read_with {
        refuse_other_instrument(root, &figure, &session.instruments)?;
        session.read_with.insert(figure.path, figure.instrument);
    }
    Ok(ParsedSession {
        session,
        files,
        assumed: noted.assumed,
    })
}

fn instrument(table: &Table<'_>, before: &[Instrument]) -> Result<Instrument> {
    let field = table.require("id", "a name that figures call it by")?;
    let id = field.text()?;
    if id.trim().is_empty() || before.iter().any(|one| one.id == id) {
        return Err(field.error(
            format!("`{}` to be a name unlike all before it", field.path),
            format!("{id:?}"),
        ));
    }
    let share = |key: &str| table.number(key, Domain::UNCERTAINTY);
    Ok(Instrument {
        id: id.into(),
        kind: table
            .require("kind", "tape, clock, protractor or scale")?
            .choice(INSTRUMENTS)?,
        scale_u: share("scale_u")?.unwrap_or_default(),
        zero_u: share("zero_u")?.unwrap_or_default(),
    })
}

/// A figure names an instrument that is there and reads such figures.
fn refuse_other_instrument(
    root: &Table<'_>,
    figure: &ReadWith,
    instruments: &[Instrument],
) -> Result<()> {
    let wrong = |expected: String, found: String| Err(root.error_at(figure.line, expected, found));
    let (key, id) = (&figure.path, &figure.instrument);
    match instruments.iter().find(|one| one.id == *id) {
        None => {
            let known: Vec<String> = instruments
                .iter()
                .map(|one| format!("`{}`", one.id))
                .collect();
            let expected = match known.is_empty() {
                true => format!("an [[instrument]] with id = {id:?} for `{key}`"),
                false => format!("`{key}` to name one of {}", known.join(", ")),
            };
            wrong(expected, format!("{id:?}"))
        }
        Some(named) if Some(named.kind) != figure.kind => {
            let found = format!("{id:?}, a {}", name_of(named.kind, INSTRUMENTS));
            let expected = match figure.kind {
                Some(kind) => format!("`{key}` to be read with a {}", name_of(kind, INSTRUMENTS)),
                None => format!("no instrument for `{key}`, which none of them reads"),
            };
            wrong(expected, found)
        }
        Some(_) => Ok(()),
    }
}

/// A minor version, as in `gyradius-session/1.2`, adds keys but changes none.
fn check_format(root: &Table<'_>, format: &str) -> Result<()> {
    let field = root.require(
        "format",
        &format!("the format's name and version, \"{format}\""),
    )?;
    let text = field.text()?;
    let rest = text.strip_prefix(format);
    let minor = |rest: &str| {
        rest.strip_prefix('.')
            .is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
    };
    if rest.is_some_and(|rest| rest.is_empty() || minor(rest)) {
        return Ok(());
    }
    Err(field.error(
        format!("`format` to be \"{format}\", the version that this program reads"),
        format!("{text:?}"),
    ))
}

fn body(table: &Table<'_>) -> Result<Body> {
    Ok(Body {
        name: table.text_or_empty("name")?,
        mass_kg: table.quantity("mass", Domain::MASS)?,
        length_overall_m: table.number("length_overall", Domain::LENGTH)?,
        density_kg_m3: table.number("density", Domain::DENSITY)?,
    })
}

fn site(table: &Table<'_>) -> Result<Site> {
    if table.get("gravity").is_some() {
        table.refuse(
            &["latitude_deg"],
            "`gravity` is stated and is what it would be computed for",
        )?;
    }
    if table.get("latitude_deg").is_none() {
        table.refuse(&["altitude"], "it serves only beside `latitude_deg`")?;
    }
    Ok(Site {
        gravity_m_s2: table.quantity("gravity", Domain::GRAVITY)?,
        latitude_deg: table.number("latitude_deg", Domain::LATITUDE)?,
        altitude_m: table.number("altitude", Domain::ALTITUDE)?,
        air_density_kg_m3: table.number("air_density", Domain::AIR_DENSITY)?,
    })
}

/// Catches a density in g/cm³, which would make the buoyancy larger than the weight.
fn refuse_lighter_than_air(root: &Table<'_>, body: &Body, site: &Site) -> Result<()> {
    let air = site.air_density_kg_m3.unwrap_or(SEA_LEVEL_AIR_KG_M3);
    match body.density_kg_m3 {
        Some(density) if density <= air => {
            let place = root
                .require("body", "the body")?
                .table(BODY)?
                .require("density", "its density")?;
            Err(place.error(
                format!("`body.density` in kg/m³, above that of the air, {air}"),
                density.to_string(),
            ))
        }
        _ => Ok(()),
    }
}

/// The body's mass is everything that swings, attachments included.
fn refuse_heavier_than_body(
    root: &Table<'_>,
    body: &Body,
    attachments: &[Attachment],
) -> Result<()> {
    let attached: f64 = attachments.iter().map(|one| one.mass_kg.value).sum();
    match body.mass_kg {
        Some(mass) if attached >= mass.value => {
            let place = root
                .require("body", "the body")?
                .table(BODY)?
                .require("mass", "its mass")?;
            let all = mass.value;
            Err(place.error(
                "`body.mass` to be everything that swings, attachments included",
                format!("{all} kg with attachments of {attached} kg"),
            ))
        }
        _ => Ok(()),
    }
}

fn attachment(table: &Table<'_>) -> Result<Attachment> {
    let gyradii = table
        .get("gyradii")
        .map(|field| field.vector(Domain::GYRADIUS))
        .transpose()?;
    let (position_m, position_u_m) = table
        .require("position", POSITION)?
        .place(Domain::COORDINATE)?;
    Ok(Attachment {
        name: table.text_or_empty("name")?,
        mass_kg: table.require("mass", "kg")?.quantity(Domain::MASS)?,
        position_m,
        position_u_m,
        gyradii_m: gyradii.unwrap_or_default(),
    })
}

fn incline(table: &Table<'_>, files: &mut Vec<NamedFile>) -> Result<Incline> {
    let angle = table.exactly_one(&["angle_deg", "recording"])?;
    let end = table.require("end", "where the weight hung, bow or stern")?;
    Ok(Incline {
        end: end.choice(&[("bow", End::Bow), ("stern", End::Stern)])?,
        mass_kg: table
            .require("mass", "the weight, kg")?
            .quantity(Domain::MASS)?,
        arm_m: table.require("arm", "L_s, m")?.quantity(Domain::LENGTH)?,
        depth_m: table
            .require("depth", "b_s, m")?
            .quantity(Domain::COORDINATE)?,
        angle: incline_angle(&angle, files)?,
    })
}

fn incline_angle(field: &Field<'_>, files: &mut Vec<NamedFile>) -> Result<InclineAngle> {
    if field.key == "angle_deg" {
        return field.quantity(Domain::INCLINE).map(InclineAngle::Stated);
    }
    let file = field.file_name()?;
    files.push(NamedFile::new(field, &file));
    Ok(InclineAngle::Recording(file))
}
