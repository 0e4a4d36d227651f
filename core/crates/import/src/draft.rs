//! The text of a session that may still lack dimensions.

use std::collections::{BTreeMap, BTreeSet};

use toml_edit::{DocumentMut, InlineTable, Item, TableLike, TomlError, Value, value};

use super::hanging::Hanging;
use gyradius_base::error::{Error, Result};
use gyradius_recording::{
    Orientation, ParsedSession, Quantity, Session, Suspension, SuspensionKind, parse_session,
};

/// A session as far as it is filled in.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Draft {
    pub session: Session,
    /// Keys of the figures that are stated without an uncertainty.
    assumed: BTreeSet<String>,
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

    /// How a swing hung, as it is stated: u is NaN where nobody states it; and the instruments that
    /// its figures were read with, by the key of the figure.
    pub fn hung(&self, swing: usize) -> Option<(Suspension, BTreeMap<String, String>)> {
        let mut hung = self.session.swings.get(swing)?.suspension.clone();
        let mut read_with = BTreeMap::new();
        for key in hung.kind.figures() {
            let full = figure_key(self.session.measured_at(swing, key), key);
            if let Some(instrument) = self.session.read_with.get(&full) {
                read_with.insert((*key).to_owned(), instrument.clone());
            }
            let figure = hung.figure(key);
            if let Some(stated) = figure.filter(|_| self.assumed.contains(&full)) {
                hung.set_figure(key, Some(Quantity::new(stated.value, f64::NAN)));
            }
        }
        Some((hung, read_with))
    }
}

/// The key of a figure of a swing's suspension in the whole session; swings count from 0.
pub(crate) fn figure_key(swing: usize, key: &str) -> String {
    format!("swing[{}].suspension.{key}", swing + 1)
}

/// Reads a session; dimensions of suspensions may be missing, all else must be right.
pub(crate) fn read_draft(text: &str, file: &str) -> Result<Draft> {
    let in_line = document(text, file).ok().and_then(|document| {
        let lists = ["swing", "recorded"];
        lists
            .into_iter()
            .find(|list| document.get(list).is_some_and(Item::is_value))
    });
    let draft = |parsed: ParsedSession, lacks| Draft {
        session: parsed.session,
        assumed: parsed.assumed.into_iter().map(|one| one.path).collect(),
        lacks,
        in_line,
    };
    let refused = match parse_session(text, file) {
        Ok(parsed) => return Ok(draft(parsed, false)),
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
    let mut parsed = parse_session(&filled.to_string(), file)?;
    for (swing, gaps) in parsed.session.swings.iter_mut().zip(gaps) {
        for gap in gaps {
            swing.suspension.set_figure(gap, None);
        }
    }
    let session = &mut parsed.session;
    for i in 0..session.swings.len() {
        if let Some(first) = session.same_hanging(i) {
            let stated = session.hung_as.get(&session.swings[i].id);
            let stated = stated.map(|hung| hung.but_for.clone()).unwrap_or_default();
            let kept = &session.swings[first].suspension;
            session.swings[i].suspension = kept.but_for(&stated, &session.swings[i].suspension);
        }
    }
    Ok(draft(parsed, true))
}

/// Lines so long reach from any point to any other, m.
const FILLER_M: f64 = 1e6;

/// Gives a suspension the dimensions that it must have and lacks; their keys.
fn fill_gaps(suspension: &mut dyn TableLike) -> Vec<&'static str> {
    let kind = suspension.get("kind").and_then(Item::as_str);
    let needed = kind
        .and_then(SuspensionKind::named)
        .map_or(&[][..], SuspensionKind::needs);
    let gaps: Vec<&str> = needed
        .iter()
        .copied()
        .filter(|key| !suspension.contains_key(key))
        // The points say how far apart they are.
        .filter(|key| *key != "spacing" || !suspension.contains_key("points_m"))
        .collect();
    for key in &gaps {
        // Nothing but a figure that fits whatever stands beside it: it is taken out again.
        let above = suspension.get(&format!("top_{key}")).cloned();
        suspension.insert(key, above.unwrap_or_else(|| value(FILLER_M)));
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

/// The text with the dimensions of one swing that are stated; all else stands as it was. Of
/// another kind, it loses the figures that this one does not have. What hangs as an earlier swing
/// does keeps saying so unless its kind or direction is another: then its figures are written out.
pub(crate) fn set_stated(
    text: &str,
    swing: usize,
    old: &Suspension,
    stated: &Hanging,
) -> Result<String> {
    let hung = stated.over(old)?;
    let kind = hung.kind;
    let is_other = kind != old.kind || hung.orientation != old.orientation;
    let choices = [
        ("kind", stated.kind.map(SuspensionKind::name)),
        ("orientation", stated.orientation.map(Orientation::name)),
    ];
    let choices = choices.map(|(key, name)| (key, name.map(Value::from)));
    let figures = kind
        .figures()
        .iter()
        .map(|key| (*key, stated.figures.get(*key).copied().map(of_quantity)));
    let keys: Vec<(&str, Option<Value>)> = choices.into_iter().chain(figures).collect();
    if keys.iter().all(|(_, stated)| stated.is_none()) {
        return Ok(text.to_owned());
    }
    let (mark, bare) = match text.strip_prefix(BYTE_ORDER_MARK) {
        Some(bare) => (BYTE_ORDER_MARK, bare),
        None => ("", text),
    };
    let mut document = document(bare, gyradius_recording::SESSION_FILE)?;
    if let Some(suspension) = suspensions(&mut document).into_iter().nth(swing) {
        let foreign = |key: &&&str| !kind.figures().contains(*key);
        for key in old.kind.figures().iter().filter(foreign) {
            suspension.remove(key);
        }
        if hung.points_m.is_none() {
            suspension.remove("points_m");
        }
        let mut keys = keys;
        if suspension.contains_key("same_as") {
            if is_other {
                suspension.remove("same_as");
                keys = whole(&hung);
            } else {
                keys.retain(|(key, _)| !["kind", "orientation"].contains(key));
            }
        }
        for (key, stated) in keys {
            if let Some(stated) = stated {
                set(suspension, key, stated);
            }
        }
    }
    Ok(format!("{mark}{document}"))
}

/// All that is stated of a suspension, by key.
fn whole(hung: &Suspension) -> Vec<(&'static str, Option<Value>)> {
    let mut all = vec![
        ("kind", Some(hung.kind.name().into())),
        ("orientation", Some(hung.orientation.name().into())),
    ];
    if let Some(points) = &hung.points_m {
        let each = points
            .iter()
            .map(|point| Value::Array(point.iter().copied().collect()));
        all.push(("points_m", Some(Value::Array(each.collect()))));
    }
    let is_told = |key: &str| key == "spacing" && hung.points_m.is_some();
    let figures = hung.kind.figures().iter().filter(|key| !is_told(key));
    all.extend(figures.map(|key| (*key, hung.figure(key).map(of_quantity))));
    all
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
