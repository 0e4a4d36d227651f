//! The text of a session that may still lack dimensions.

use toml_edit::{DocumentMut, InlineTable, Item, TableLike, TomlError, Value, value};

use super::grow::Growth;
use gyradius_base::error::{Error, Result};
use gyradius_recording::{
    Orientation, Quantity, Session, Suspension, SuspensionKind, read_session,
};

/// A session as far as it is filled in.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Draft {
    pub session: Session,
    /// Whether a swing lacks a dimension that it must have.
    lacks: bool,
    /// `swing` or `recorded`, where it is a list in one line.
    pub in_line: Option<&'static str>,
}

impl Draft {
    /// Whether the session can be measured.
    pub fn is_complete(&self) -> bool {
        !self.lacks
    }
}

/// Reads a session; dimensions of suspensions may be missing, all else must be right.
pub(crate) fn read_draft(text: &str, file: &str) -> Result<Draft> {
    let in_line = document(text, file).ok().and_then(|document| {
        let lists = ["swing", "recorded"];
        lists
            .into_iter()
            .find(|list| document.get(list).is_some_and(Item::is_value))
    });
    let draft = |session, lacks| Draft {
        session,
        lacks,
        in_line,
    };
    let refused = match read_session(text, file) {
        Ok(session) => return Ok(draft(session, false)),
        Err(refused) => refused,
    };
    let Ok(mut filled) = document(text, file) else {
        return Err(refused);
    };
    let gaps: Vec<Vec<&str>> = suspensions(&mut filled)
        .into_iter()
        .map(fill_gaps)
        .collect();
    if gaps.iter().all(Vec::is_empty) {
        return Err(refused);
    }
    let mut session = read_session(&filled.to_string(), file)?;
    for (swing, gaps) in session.swings.iter_mut().zip(gaps) {
        let hung = &mut swing.suspension;
        for gap in gaps {
            match gap {
                LINE_LENGTH => hung.line_length_m = None,
                SPACING => hung.spacing_m = None,
                _ => hung.axis_height_m = None,
            }
        }
    }
    for i in 0..session.swings.len() {
        if let Some(first) = session.same_hanging(i) {
            session.swings[i].suspension = session.swings[first].suspension.clone();
        }
    }
    Ok(draft(session, true))
}

const LINE_LENGTH: &str = "line_length";
const SPACING: &str = "spacing";
const AXIS_HEIGHT: &str = "axis_height";

/// Gives a suspension the dimensions that it must have and lacks; their keys.
fn fill_gaps(suspension: &mut dyn TableLike) -> Vec<&'static str> {
    let kind = suspension.get("kind").and_then(Item::as_str);
    let needed: &[&str] = match kind {
        Some("bifilar") => &[LINE_LENGTH, SPACING],
        Some("compound") => &[AXIS_HEIGHT],
        _ => &[],
    };
    let gaps: Vec<&str> = needed
        .iter()
        .copied()
        .filter(|key| !suspension.contains_key(key))
        .collect();
    for key in &gaps {
        suspension.insert(key, value(1.0));
    }
    gaps
}

/// The suspensions of the swings, in order.
fn suspensions(document: &mut DocumentMut) -> Vec<&mut dyn TableLike> {
    match document.get_mut("swing") {
        Some(Item::ArrayOfTables(swings)) => swings
            .iter_mut()
            .filter_map(|swing| swing.get_mut("suspension")?.as_table_like_mut())
            .collect(),
        Some(Item::Value(Value::Array(swings))) => swings
            .iter_mut()
            .filter_map(|swing| {
                let table = swing.as_inline_table_mut()?.get_mut("suspension")?;
                Some(table.as_inline_table_mut()? as &mut dyn TableLike)
            })
            .collect(),
        _ => Vec::new(),
    }
}

/// The text with the dimensions of one swing that are stated; all else stands as it was.
pub(crate) fn set_stated(
    text: &str,
    swing: usize,
    stated: &Suspension,
    growth: &Growth,
) -> Result<String> {
    let choice = |name: Option<&'static str>| name.map(Value::from);
    let dimension = |stated: Option<Quantity>| stated.map(of_quantity);
    let keys = [
        ("kind", choice(growth.kind.map(SuspensionKind::name))),
        (
            "orientation",
            choice(growth.orientation.map(Orientation::name)),
        ),
        (LINE_LENGTH, dimension(stated.line_length_m)),
        (SPACING, dimension(stated.spacing_m)),
        ("top_spacing", dimension(stated.top_spacing_m)),
        ("hull_pitch_deg", dimension(stated.hull_pitch_deg)),
        ("points_moved", dimension(stated.points_moved_m)),
        (AXIS_HEIGHT, dimension(stated.axis_height_m)),
    ];
    if keys.iter().all(|(_, stated)| stated.is_none()) {
        return Ok(text.to_owned());
    }
    let (mark, bare) = match text.strip_prefix(BYTE_ORDER_MARK) {
        Some(bare) => (BYTE_ORDER_MARK, bare),
        None => ("", text),
    };
    let mut document = document(bare, gyradius_recording::SESSION_FILE)?;
    if let Some(suspension) = suspensions(&mut document).into_iter().nth(swing) {
        for (key, stated) in keys {
            if let Some(stated) = stated {
                set(suspension, key, stated);
            }
        }
    }
    Ok(format!("{mark}{document}"))
}

const BYTE_ORDER_MARK: &str = "\u{feff}";

/// Sets a value; what stands around the old one, a comment for example, stays.
fn set(table: &mut dyn TableLike, key: &str, mut new: Value) {
    match table.get_mut(key) {
        Some(Item::Value(old)) => {
            *new.decor_mut() = old.decor().clone();
            *old = new;
        }
        _ => {
            table.insert(key, Item::Value(new));
        }
    }
}

/// A number alone where nobody states an uncertainty.
fn of_quantity(quantity: Quantity) -> Value {
    if quantity.u.is_nan() {
        return quantity.value.into();
    }
    let pairs = [("value", quantity.value), ("u", quantity.u)];
    Value::InlineTable(pairs.into_iter().collect::<InlineTable>())
}

fn document(text: &str, file: &str) -> Result<DocumentMut> {
    let text = text.strip_prefix(BYTE_ORDER_MARK).unwrap_or(text);
    text.parse().map_err(|error: TomlError| Error::Malformed {
        file: file.to_owned(),
        line: None,
        expected: "TOML".to_owned(),
        found: error.message().replace('\n', ", "),
    })
}
