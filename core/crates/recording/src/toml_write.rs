//! A [`Session`] as the text of `session.toml`, in the layout that people edit.

use std::collections::BTreeMap;

use super::names::{
    EXCITATIONS, INSTRUMENTS, KINDS, MODES, ORIENTATIONS, REPAIR_KINDS, SENSORS, name_of,
};
use super::quantity::Quantity;
use super::recorded::{Recorded, RecordedRepair};
use super::session::{
    AddedMass, Attachment, Body, End, Incline, InclineAngle, Instrument, ModeName, Orientation,
    Session, Site, SuspensionKind, Swing, SwingData,
};
use super::toml_read::FORMAT;

/// The text of a `session.toml` that reads back to an equal session, if the session is a valid one.
pub fn write_session(session: &Session) -> String {
    written(session, Lines::default())
}

/// The same with what is usual and not stated as comments, to be filled in by hand.
pub fn write_session_to_fill_in(session: &Session) -> String {
    written(session, Lines::to_fill_in())
}

/// The tables of its swings and recordings alone, to be put at the end of another session's text,
/// with what is usual and not stated as comments. Instruments are those of the other session.
pub fn write_swings_to_fill_in(added: &Session) -> String {
    let mut text = Lines::to_fill_in();
    swings(&mut text, added);
    for one in &added.recorded {
        recorded(&mut text, one);
    }
    text.text
}

fn swings(text: &mut Lines, session: &Session) {
    let figures = Figures(session);
    for (i, one) in session.swings.iter().enumerate() {
        swing(text, one, &figures, &format!("swing[{}]", i + 1));
    }
}

fn written(session: &Session, mut text: Lines) -> String {
    text.key("format", quoted(FORMAT));
    text.key_unless_empty("title", &session.title);
    text.key_unless_empty("measured_on", &session.measured_on);
    text.key_unless_empty("phone", &session.phone);
    text.key_unless_empty("logger", &session.logger);
    for one in &session.instruments {
        instrument(&mut text, one);
    }
    let figures = Figures(session);
    body(&mut text, &session.body, &figures);
    site(&mut text, &session.site);
    for (i, one) in session.attachments.iter().enumerate() {
        let mass = figures.written(&format!("attachment[{}].mass", i + 1), one.mass_kg);
        attachment(&mut text, one, mass);
    }
    if session.attachments.is_empty() {
        text.hint(PHONE);
        let hung = |swing: &Swing| swing.suspension.kind == SuspensionKind::Trifilar;
        if session.swings.iter().any(hung) {
            text.hint(PLATFORM);
        }
    }
    swings(&mut text, session);
    for (i, one) in session.inclines.iter().enumerate() {
        incline(&mut text, one, &figures, &format!("incline[{}]", i + 1));
    }
    for one in &session.recorded {
        recorded(&mut text, one);
    }
    text.text
}

/// Writes figures with the instruments that they were read with.
struct Figures<'a>(&'a Session);

impl Figures<'_> {
    fn written(&self, key: &str, figure: Quantity) -> String {
        let written = quantity(figure);
        let Some(instrument) = self.0.read_with.get(key) else {
            return written;
        };
        let figure = written
            .trim_start_matches("{ value = ")
            .trim_end_matches(" }");
        format!(
            "{{ value = {figure}, instrument = {} }}",
            quoted(instrument)
        )
    }
}

fn instrument(text: &mut Lines, instrument: &Instrument) {
    text.header("[[instrument]]");
    text.key("id", quoted(&instrument.id));
    text.key("kind", quoted(name_of(instrument.kind, INSTRUMENTS)));
    text.key("scale_u", number(instrument.scale_u));
    text.key("zero_u", number(instrument.zero_u));
}
/// Keys that are usual and may be missing; the figures are examples.
const MASS: &str =
    "# mass = { value = 100.0, u = 0.2 }  # kg, everything that swings, attachments too\n";
const SITE: &str = "\n# [site]\n# gravity = { value = 9.81, u = 0.005 }  # m/s2; or latitude_deg and altitude (m)\n";
const PHONE: &str = "\n# [[attachment]]  # rides on the hull and is taken off the result\n\
    # name = \"phone\"\n# mass = { value = 0.2, u = 0.001 }  # kg\n\
    # position = [0.0, 0.0, 0.0]  # m, forward, to port, up, from the mid-point of the suspension points\n";
const PLATFORM: &str = "\n# [[attachment]]  # what the body lies on\n\
    # name = \"platform\"\n# mass = { value = 5.0, u = 0.01 }  # kg\n\
    # position = [0.0, 0.0, -0.02]  # m, forward, to port, up, from the centre of the circle\n\
    # gyradii = [0.2, 0.2, 0.28]  # m, about its own centre\n";
const EXCITED: &str =
    "# excited = [\"yaw\", \"sway\"]  # what was set going: yaw, sway, surge, pitch, roll\n";
const HINTS: [(&str, &str); 7] = [
    (
        "line_length",
        "# line_length = { value = 3.0, u = 0.003 }  # m, of the lines\n",
    ),
    (
        "spacing",
        "# spacing = { value = 1.5, u = 0.002 }  # m, between the points on the hull\n",
    ),
    (
        "top_spacing",
        "# top_spacing = { value = 1.5, u = 0.002 }  # m, between the points above; without it, spacing\n",
    ),
    (
        "radius",
        "# radius = { value = 0.5, u = 0.001 }  # m, of the circle through the line ends on the platform\n",
    ),
    (
        "top_radius",
        "# top_radius = { value = 0.5, u = 0.001 }  # m, of that through the line ends above; without it, radius\n",
    ),
    (
        "hull_pitch_deg",
        "# hull_pitch_deg = { value = 0.0, u = 0.3 }  # degrees, bow up\n",
    ),
    (
        "axis_height",
        "# axis_height = { value = 0.5, u = 0.002 }  # m, of the axis above the suspension points\n",
    ),
];

/// The lines written so far.
#[derive(Default)]
struct Lines {
    text: String,
    /// Whether what is usual and not stated is written as a comment.
    is_to_fill_in: bool,
}

impl Lines {
    fn to_fill_in() -> Self {
        Self {
            is_to_fill_in: true,
            ..Self::default()
        }
    }

    fn header(&mut self, header: &str) {
        self.text.push('\n');
        self.subheader(header);
    }

    fn subheader(&mut self, header: &str) {
        self.text.push_str(header);
        self.text.push('\n');
    }

    fn key(&mut self, key: &str, value: String) {
        self.text.push_str(&format!("{key} = {value}\n"));
    }

    /// Lines that a reader may fill in.
    fn hint(&mut self, lines: &str) {
        if self.is_to_fill_in {
            self.text.push_str(lines);
        }
    }

    fn key_if<T>(&mut self, key: &str, value: Option<T>, write: impl Fn(T) -> String) {
        if let Some(value) = value {
            self.key(key, write(value));
        }
    }

    fn key_unless_empty(&mut self, key: &str, value: &str) {
        if !value.is_empty() {
            self.key(key, quoted(value));
        }
    }
}

fn body(text: &mut Lines, body: &Body, figures: &Figures) {
    text.header("[body]");
    text.key_unless_empty("name", &body.name);
    match body.mass_kg {
        Some(mass) => text.key("mass", figures.written("body.mass", mass)),
        None => text.hint(MASS),
    }
    text.key_if("length_overall", body.length_overall_m, number);
    text.key_if("density", body.density_kg_m3, number);
}

fn site(text: &mut Lines, site: &Site) {
    if *site == Site::default() {
        text.hint(SITE);
        return;
    }
    text.header("[site]");
    text.key_if("gravity", site.gravity_m_s2, quantity);
    text.key_if("latitude_deg", site.latitude_deg, number);
    text.key_if("altitude", site.altitude_m, number);
    text.key_if("air_density", site.air_density_kg_m3, number);
}

fn attachment(text: &mut Lines, attachment: &Attachment, mass: String) {
    text.header("[[attachment]]");
    text.key_unless_empty("name", &attachment.name);
    text.key("mass", mass);
    text.key(
        "position",
        format!(
            "{{ value = {}, u = {} }}",
            vector(attachment.position_m),
            number(attachment.position_u_m)
        ),
    );
    if attachment.gyradii_m != [0.0; 3] {
        text.key("gyradii", vector(attachment.gyradii_m));
    }
}

fn swing(text: &mut Lines, swing: &Swing, figures: &Figures, key: &str) {
    text.header("[[swing]]");
    text.key("id", quoted(&swing.id));
    swing_data(text, &swing.data, figures, key);
    if !swing.amplitude_deg.is_empty() {
        text.key(
            "amplitude_deg",
            by_mode(&swing.amplitude_deg, |_, degrees| number(degrees)),
        );
    }
    if swing.excited.is_empty() {
        text.hint(EXCITED);
    } else {
        let names = swing
            .excited
            .iter()
            .map(|one| quoted(name_of(*one, EXCITATIONS)));
        text.key(
            "excited",
            format!("[{}]", names.collect::<Vec<_>>().join(", ")),
        );
    }
    added_masses(text, &swing.added_masses, figures, key);
    suspension(text, swing, figures, key);
}

fn swing_data(text: &mut Lines, data: &SwingData, figures: &Figures, key: &str) {
    match data {
        SwingData::Recording(file) => text.key("recording", quoted(file)),
        SwingData::Displacement { file, at_m } => {
            text.key("displacement", quoted(file));
            text.key_if("at", *at_m, vector);
        }
        SwingData::Periods(file) => text.key("periods", quoted(file)),
        SwingData::PeriodsS(periods) => text.key(
            "periods_s",
            by_mode(periods, |mode, period| {
                figures.written(&format!("{key}.periods_s.{mode}"), period)
            }),
        ),
    }
}

fn added_masses(text: &mut Lines, masses: &[AddedMass], figures: &Figures, key: &str) {
    if masses.is_empty() {
        return;
    }
    text.subheader("added_mass = [");
    for (i, one) in masses.iter().enumerate() {
        let mass = format!("{key}.added_mass[{}].mass", i + 1);
        let line = format!(
            "  {{ mass = {}, position = {} }},",
            figures.written(&mass, one.mass_kg),
            vector(one.position_m)
        );
        text.subheader(&line);
    }
    text.subheader("]");
}

fn suspension(text: &mut Lines, swing: &Swing, figures: &Figures, key: &str) {
    text.subheader("[swing.suspension]");
    let suspension = &swing.suspension;
    let hung_as = figures.0.hung_as.get(&swing.id);
    let is_turned = |id: &str| {
        let first = figures.0.swings.iter().find(|one| one.id == id);
        first.is_some_and(|one| one.suspension.orientation != suspension.orientation)
    };
    match hung_as {
        Some(first) => text.key("same_as", quoted(&first.swing)),
        None => text.key("kind", quoted(name_of(suspension.kind, KINDS))),
    }
    // What is round has no direction but the one that somebody stated.
    if match hung_as {
        Some(first) => suspension.kind.has_direction() && is_turned(&first.swing),
        None => {
            suspension.kind.has_direction() || suspension.orientation != Orientation::Athwartships
        }
    } {
        text.key(
            "orientation",
            quoted(name_of(suspension.orientation, ORIENTATIONS)),
        );
    }
    let is_stated = |name: &str| hung_as.is_none_or(|first| first.but_for.contains(name));
    let points = suspension
        .points_m
        .as_ref()
        .filter(|_| is_stated("spacing"));
    if let Some(points) = points {
        let each: Vec<String> = points.iter().map(|point| vector(*point)).collect();
        text.key("points_m", format!("[{}]", each.join(", ")));
    }
    for name in suspension.kind.figures() {
        if !is_stated(name) {
            continue;
        }
        // The points say how far apart they are.
        if *name == "spacing" && suspension.points_m.is_some() {
            continue;
        }
        match suspension.figure(name) {
            Some(figure) => text.key(
                name,
                figures.written(&format!("{key}.suspension.{name}"), figure),
            ),
            None => text.hint(hint_of(name)),
        }
    }
}

/// The line that a figure of a suspension is to be filled in at.
fn hint_of(key: &str) -> &'static str {
    let hint = HINTS.iter().find(|(name, _)| *name == key);
    hint.map_or("", |(_, line)| line)
}

fn incline(text: &mut Lines, incline: &Incline, figures: &Figures, key: &str) {
    text.header("[[incline]]");
    let end = match incline.end {
        End::Bow => "bow",
        End::Stern => "stern",
    };
    text.key("end", quoted(end));
    let written = |name: &str, figure| figures.written(&format!("{key}.{name}"), figure);
    text.key("mass", written("mass", incline.mass_kg));
    text.key("arm", written("arm", incline.arm_m));
    text.key("depth", written("depth", incline.depth_m));
    match &incline.angle {
        InclineAngle::Stated(angle) => text.key("angle_deg", written("angle_deg", *angle)),
        InclineAngle::Recording(file) => text.key("recording", quoted(file)),
    }
}

fn recorded(text: &mut Lines, recorded: &Recorded) {
    text.header("[[recorded]]");
    text.key("file", quoted(&recorded.file));
    if recorded.origin_ns != 0 {
        text.key("origin_ns", recorded.origin_ns.to_string());
    }
    text.key_unless_empty("measured_on", &recorded.measured_on);
    text.key_unless_empty("phone", &recorded.phone);
    text.key_unless_empty("logger", &recorded.logger);
    text.key_if("bias", recorded.bias.as_deref(), quoted);
    if !recorded.notes.is_empty() {
        let each = recorded
            .notes
            .iter()
            .map(|(key, value)| format!("{} = {}", quoted_key(key), quoted(value)));
        text.key(
            "notes",
            format!("{{ {} }}", each.collect::<Vec<_>>().join(", ")),
        );
    }
    let sensors = recorded.sensors.iter().map(|sensor| {
        let scale = optional("full_scale", sensor.full_scale);
        format!(
            "{{ stream = {}, name = {}{scale} }}",
            quoted(&sensor.stream),
            quoted(&sensor.name)
        )
    });
    list(text, "sensors", sensors);
    let events = recorded.events.iter();
    list(
        text,
        "events",
        events.map(|e| format!("{{ t = {}, key = {} }}", number(e.t_s), quoted(&e.key))),
    );
    for one in &recorded.repairs {
        repair(text, one);
    }
}

fn repair(text: &mut Lines, repair: &RecordedRepair) {
    text.subheader("[[recorded.repair]]");
    text.key("text", quoted(&repair.text));
    text.key_if("kind", repair.kind, |kind| {
        quoted(name_of(kind, REPAIR_KINDS))
    });
    text.key_if("sensor", repair.sensor, |sensor| {
        quoted(name_of(sensor, SENSORS))
    });
    text.key_if("count", repair.count, |count| count.to_string());
    text.key_if("from", repair.from_s, number);
    text.key_if("to", repair.to_s, number);
}

fn list(text: &mut Lines, key: &str, entries: impl Iterator<Item = String>) {
    let lines: Vec<String> = entries.map(|entry| format!("  {entry},\n")).collect();
    if !lines.is_empty() {
        text.key(key, format!("[\n{}]", lines.concat()));
    }
}

fn optional(key: &str, value: Option<f64>) -> String {
    value
        .map(|value| format!(", {key} = {}", number(value)))
        .unwrap_or_default()
}

/// The shortest digits that read back to the same number; Rust's spelling of a finite f64 is valid
/// TOML.
fn number(value: f64) -> String {
    format!("{value:?}")
}

/// A number alone is read with the usual uncertainty of its kind: it is written so where u is NaN,
/// and u = 0 is written.
fn quantity(quantity: Quantity) -> String {
    if quantity.u.is_nan() {
        return number(quantity.value);
    }
    format!(
        "{{ value = {}, u = {} }}",
        number(quantity.value),
        number(quantity.u)
    )
}

fn vector(vector: [f64; 3]) -> String {
    let [x, y, z] = vector.map(number);
    format!("[{x}, {y}, {z}]")
}

fn quoted(text: &str) -> String {
    toml_edit::Value::from(text).to_string()
}

/// A key of any text.
fn quoted_key(key: &str) -> String {
    toml_edit::Key::new(key).to_string()
}

fn by_mode<T: Copy>(values: &BTreeMap<ModeName, T>, write: impl Fn(&str, T) -> String) -> String {
    let each = values.iter().map(|(mode, value)| {
        let name = name_of(*mode, MODES);
        format!("{name} = {}", write(name, *value))
    });
    format!("{{ {} }}", each.collect::<Vec<_>>().join(", "))
}
