//! TOML tables read key by key, each error with file, line and full key.
//!
//! # Conventions
//! Lines and the entries of a list count from 1: `swing[1]` is the first `[[swing]]`.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::fmt::Display;

use toml_edit::{Item, Key, TableLike, Value};

use super::domain::{Domain, MOST};
use super::member_path::plain_member_path;
use super::quantity::Quantity;
use super::session::InstrumentKind;
use gyradius_base::error::{Error, Result};

/// A text with its name, for the lines of errors.
#[derive(Debug, Clone, Copy)]
pub struct Source<'a> {
    pub file: &'a str,
    pub text: &'a str,
    /// What was noted of figures beside their values.
    pub noted: &'a RefCell<Noted>,
}

/// What is noted of the figures of a text beside their values and uncertainties.
#[derive(Debug, Clone, Default)]
pub struct Noted {
    /// Figures that are stated without an uncertainty.
    pub assumed: Vec<AssumedU>,
    /// Figures that name an instrument.
    pub read_with: Vec<ReadWith>,
}

/// A figure that names the instrument it was read with.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadWith {
    /// The figure's full key.
    pub path: String,
    /// The line it stands in.
    pub line: Option<usize>,
    /// The instrument's id.
    pub instrument: String,
    /// What reads such figures; none of what no instrument reads.
    pub kind: Option<InstrumentKind>,
}

/// A figure that was stated without an uncertainty, and the usual one that it got.
#[derive(Debug, Clone, PartialEq)]
pub struct AssumedU {
    /// Its full key: `swing[1].suspension.spacing`.
    pub path: String,
    /// The standard uncertainty, unit of the figure.
    pub u: f64,
}

impl Source<'_> {
    pub fn line(&self, offset: usize) -> usize {
        let before = &self.text.as_bytes()[..offset.min(self.text.len())];
        1 + before.iter().filter(|&&byte| byte == b'\n').count()
    }

    pub fn malformed(
        &self,
        line: Option<usize>,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Error {
        Error::Malformed {
            file: self.file.into(),
            line,
            expected: expected.into(),
            found: found.into(),
        }
    }
}

/// One table: its place in the text, and the keys it may hold.
#[derive(Clone, Copy)]
pub(crate) struct Keys<'a> {
    source: Source<'a>,
    table: &'a dyn TableLike,
    line: Option<usize>,
    known: &'a [&'static str],
}

/// A table with its path; made by `Field::table` and friends.
pub struct Table<'a> {
    keys: Keys<'a>,
    path: String,
}

impl<'a> Table<'a> {
    /// Opens a table, refusing keys that are not among `known`.
    pub fn new(
        source: Source<'a>,
        path: String,
        line: Option<usize>,
        table: &'a dyn TableLike,
        known: &'a [&'static str],
    ) -> Result<Self> {
        let opened = Self {
            keys: Keys {
                source,
                table,
                line,
                known,
            },
            path,
        };
        opened.refuse_unknown()?;
        Ok(opened)
    }

    /// What was noted of the figures that were read so far.
    pub fn noted(&self) -> Noted {
        self.keys.source.noted.borrow().clone()
    }

    /// The table of a whole text, its keys not yet looked at.
    pub fn root(source: Source<'a>, table: &'a dyn TableLike, known: &'a [&'static str]) -> Self {
        Self {
            keys: Keys {
                source,
                table,
                line: None,
                known,
            },
            path: String::new(),
        }
    }

    /// Fails at the first key that the format does not know.
    pub fn refuse_unknown(&self) -> Result<()> {
        self.refuse_beside(self.keys.known)
    }

    /// Refuses keys that are not among `known`.
    pub fn refuse_beside(&self, known: &[&str]) -> Result<()> {
        let Keys { source, table, .. } = self.keys;
        match table
            .iter()
            .find(|(key, item)| !known.contains(key) && !item.is_none())
        {
            None => Ok(()),
            Some((key, _)) => Err(Error::UnknownKey {
                file: source.file.into(),
                line: self.get(key).and_then(|field| field.line),
                key: self.path_of(key),
                nearest: nearest(key, known.iter().copied()).map(String::from),
            }),
        }
    }

    /// A key with the tables that it stands in.
    pub fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() {
            key.into()
        } else {
            format!("{}.{key}", self.path)
        }
    }

    /// The value under a key, if it is there.
    pub fn get(&self, key: &str) -> Option<Field<'a>> {
        let Keys {
            source,
            table,
            line,
            ..
        } = self.keys;
        let (spelled, item) = table
            .get_key_value(key)
            .filter(|(_, item)| !item.is_none())?;
        let line = span_start(spelled, item)
            .map(|offset| source.line(offset))
            .or(line);
        Some(Field {
            source,
            key: key.into(),
            path: self.path_of(key),
            line,
            item,
        })
    }

    /// The value under a key that must be there.
    pub fn require(&self, key: &str, what: &str) -> Result<Field<'a>> {
        self.get(key).ok_or_else(|| {
            self.error(
                format!("`{}` ({what})", self.path_of(key)),
                format!("no key `{key}` in this table"),
            )
        })
    }

    /// An error about the table as a whole.
    pub fn error(&self, expected: impl Into<String>, found: impl Into<String>) -> Error {
        self.keys.source.malformed(self.keys.line, expected, found)
    }

    /// An error about a line of the text.
    pub fn error_at(
        &self,
        line: Option<usize>,
        expected: impl Into<String>,
        found: impl Into<String>,
    ) -> Error {
        self.keys.source.malformed(line, expected, found)
    }

    /// Refuses keys that have no meaning here although the format knows them.
    pub fn refuse(&self, keys: &[&str], why: &str) -> Result<()> {
        match keys.iter().find_map(|key| self.get(key)) {
            Some(field) => Err(field.error(format!("no `{}` ({why})", field.path), "it")),
            None => Ok(()),
        }
    }

    /// The one key of `keys` that is there.
    pub fn exactly_one(&self, keys: &[&str]) -> Result<Field<'a>> {
        let mut present = keys.iter().filter_map(|key| self.get(key));
        let expected = || {
            format!(
                "exactly one of {} in `{}`",
                listed(keys.iter().copied()),
                self.path
            )
        };
        match (present.next(), present.next()) {
            (None, _) => Err(self.error(expected(), "none")),
            (Some(one), None) => Ok(one),
            (Some(one), Some(two)) => {
                Err(two.error(expected(), format!("both `{}` and `{}`", one.key, two.key)))
            }
        }
    }

    /// A free text, empty where the key is absent.
    pub fn text_or_empty(&self, key: &str) -> Result<String> {
        self.get(key)
            .map_or(Ok(String::new()), |field| field.text().map(String::from))
    }

    /// A number, where the key is there.
    pub fn number(&self, key: &str, domain: Domain) -> Result<Option<f64>> {
        self.get(key).map(|field| field.number(domain)).transpose()
    }

    /// A quantity, where the key is there.
    pub fn quantity(&self, key: &str, domain: Domain) -> Result<Option<Quantity>> {
        self.get(key)
            .map(|field| field.quantity(domain))
            .transpose()
    }

    /// The tables of a list, none where the key is absent.
    pub fn tables(&self, key: &str, known: &'a [&'static str]) -> Result<Vec<Table<'a>>> {
        self.get(key)
            .map_or(Ok(Vec::new()), |field| field.tables(known))
    }

    /// The same, their keys not yet looked at.
    pub fn open_tables(&self, key: &str) -> Result<Vec<Table<'a>>> {
        self.get(key)
            .map_or(Ok(Vec::new()), |field| field.open_tables())
    }

    /// All values of the table, in file order.
    pub fn fields(&self) -> Vec<Field<'a>> {
        self.keys
            .table
            .iter()
            .filter_map(|(key, _)| self.get(key))
            .collect()
    }
}

/// One value, with its place.
pub struct Field<'a> {
    source: Source<'a>,
    pub(crate) key: String,
    pub(crate) path: String,
    pub(crate) line: Option<usize>,
    item: &'a Item,
}

impl<'a> Field<'a> {
    pub fn error(&self, expected: impl Into<String>, found: impl Into<String>) -> Error {
        self.source.malformed(self.line, expected, found)
    }

    fn expected(&self, what: impl Display) -> Error {
        self.error(format!("`{}` to be {what}", self.path), shown(self.item))
    }

    pub fn text(&self) -> Result<&'a str> {
        self.item
            .as_str()
            .ok_or_else(|| self.expected("a text in quotes"))
    }

    pub fn number(&self, domain: Domain) -> Result<f64> {
        match plain_number(self.item).filter(|&value| domain.holds(value)) {
            Some(value) => Ok(value),
            None if domain.reaches(MOST)
                && plain_number(self.item).is_some_and(|value| value.abs() > MOST) =>
            {
                Err(self.expected(format!("{domain}, at most {MOST:e}")))
            }
            None => Err(self.expected(domain)),
        }
    }

    /// A whole number.
    pub fn whole(&self) -> Result<i64> {
        self.item
            .as_integer()
            .ok_or_else(|| self.expected("a whole number"))
    }

    /// A table of texts by any key.
    pub fn texts(&self) -> Result<BTreeMap<String, String>> {
        let table = self
            .item
            .as_table_like()
            .ok_or_else(|| self.expected("a table of texts"))?;
        let keys = Keys {
            source: self.source,
            table,
            line: self.line,
            known: &[],
        };
        let fields = Table {
            keys,
            path: self.path.clone(),
        }
        .fields();
        fields
            .into_iter()
            .map(|field| Ok((field.key.clone(), field.text()?.to_owned())))
            .collect()
    }

    /// A number, `{ value, u }` or `{ value, u, instrument }`; without a u it gets the usual one of
    /// its kind, which is noted.
    pub fn quantity(&self, domain: Domain) -> Result<Quantity> {
        if plain_number(self.item).is_some() {
            return Ok(self.with_usual_u(self.number(domain)?, domain, false));
        }
        let what = format!("{domain}, as a number or as {{ value, u }}");
        if self.item.as_table_like().is_none() {
            return Err(self.expected(what));
        }
        let table = self.table(&["value", "u", "instrument"])?;
        let stated = table.require("value", &domain.to_string())?;
        let value = stated.number(domain)?;
        let instrument = table.get("instrument");
        if let Some(named) = &instrument {
            let read_with = ReadWith {
                path: self.path.clone(),
                line: named.line,
                instrument: named.text()?.to_owned(),
                kind: domain.instrument(),
            };
            self.source.noted.borrow_mut().read_with.push(read_with);
        }
        match table.number("u", Domain::UNCERTAINTY)? {
            Some(u) => Ok(Quantity::new(value, u)),
            None => Ok(stated.with_usual_u(value, domain, instrument.is_some())),
        }
    }

    /// A figure without an uncertainty gets the usual one of its kind, which is noted.
    pub fn with_usual_u(&self, value: f64, domain: Domain, has_instrument: bool) -> Quantity {
        let u = domain.usual_u(value, &self.item.to_string(), has_instrument);
        if u > 0.0 {
            let path = self.path.trim_end_matches(".value").to_owned();
            let assumed = AssumedU { path, u };
            self.source.noted.borrow_mut().assumed.push(assumed);
        }
        Quantity::new(value, u)
    }

    /// Three numbers, or `{ value = [x, y, z], u }` with one u for each; without a u they are as good
    /// as a tape reads the largest, which is noted.
    pub fn place(&self, domain: Domain) -> Result<([f64; 3], f64)> {
        let (stated, u) = match self.item.as_table_like() {
            None => (self.vector(domain)?, None),
            Some(_) => {
                let table = self.table(&["value", "u"])?;
                let stated = table.require("value", &format!("[x, y, z], each {domain}"))?;
                let u = table.number("u", Domain::UNCERTAINTY)?;
                (stated.vector(domain)?, u)
            }
        };
        let largest = stated.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        let usual = || self.with_usual_u(largest, domain, false).u;
        Ok((stated, u.unwrap_or_else(usual)))
    }

    /// Three numbers.
    pub fn vector(&self, domain: Domain) -> Result<[f64; 3]> {
        self.item
            .as_array()
            .and_then(|array| three(array, domain))
            .ok_or_else(|| self.expected(format!("[x, y, z], each {domain}")))
    }

    /// A list of three numbers each.
    pub fn vectors(&self, domain: Domain) -> Result<Vec<[f64; 3]>> {
        let read = |array: &toml_edit::Array| -> Option<Vec<[f64; 3]>> {
            let each = array.iter().map(|one| three(one.as_array()?, domain));
            each.collect()
        };
        self.item
            .as_array()
            .and_then(read)
            .ok_or_else(|| self.expected(format!("a list of [x, y, z], each {domain}")))
    }

    /// One of a list of names.
    pub fn choice<T: Copy>(&self, names: &[(&str, T)]) -> Result<T> {
        chosen(self.text()?, names)
            .ok_or_else(|| self.not_among(shown(self.item), self.text().ok(), names))
    }

    /// A list of names.
    pub fn choices<T: Copy>(&self, names: &[(&str, T)]) -> Result<Vec<T>> {
        let array = self.item.as_array().ok_or_else(|| {
            self.expected(format!(
                "a list of {}",
                listed(names.iter().map(|(name, _)| *name))
            ))
        })?;
        let read = |value: &Value| {
            let text = value.as_str();
            text.and_then(|text| chosen(text, names))
                .ok_or_else(|| self.not_among(value.to_string().trim().to_string(), text, names))
        };
        array.iter().map(read).collect()
    }

    fn not_among<T>(&self, found: String, text: Option<&str>, names: &[(&str, T)]) -> Error {
        let all = || names.iter().map(|(name, _)| *name);
        let hint = text.and_then(|text| nearest(text, all()));
        let hint = hint
            .map(|name| format!("; the nearest is `{name}`"))
            .unwrap_or_default();
        self.error(
            format!("`{}` to be one of {}", self.path, listed(all())),
            format!("{found}{hint}"),
        )
    }

    /// The name of a file inside the session.
    pub fn file_name(&self) -> Result<String> {
        plain_member_path(self.text()?).map_err(|found| {
            self.error(
                format!(
                    "`{}` to be a plain relative name of a file in the session, folders joined by /",
                    self.path
                ),
                found,
            )
        })
    }

    pub fn table(&self, known: &'a [&'static str]) -> Result<Table<'a>> {
        let table = self
            .item
            .as_table_like()
            .ok_or_else(|| self.expected("a table"))?;
        Table::new(self.source, self.path.clone(), self.line, table, known)
    }

    /// A table whose keys are names, `{ yaw = …, sway = … }`: each with its value.
    pub fn by_name<T: Copy>(&self, names: &[(&str, T)]) -> Result<Vec<(T, Field<'a>)>> {
        let table = self
            .item
            .as_table_like()
            .ok_or_else(|| self.expected("a table of names and numbers"))?;
        let keys = Keys {
            source: self.source,
            table,
            line: self.line,
            known: &[],
        };
        let fields = Table {
            keys,
            path: self.path.clone(),
        }
        .fields();
        let named = |field: Field<'a>| match chosen(&field.key, names) {
            Some(name) => Ok((name, field)),
            None => Err(Error::UnknownKey {
                file: field.source.file.into(),
                line: field.line,
                nearest: nearest(&field.key, names.iter().map(|(name, _)| *name)).map(String::from),
                key: field.path,
            }),
        };
        fields.into_iter().map(named).collect()
    }

    /// The tables of a list: `[[key]]`, or `key = [ { … }, … ]`.
    pub fn tables(&self, known: &'a [&'static str]) -> Result<Vec<Table<'a>>> {
        let tables = self.open_tables()?.into_iter();
        let opened = tables.map(|table| Table {
            keys: Keys {
                known,
                ..table.keys
            },
            path: table.path,
        });
        opened
            .map(|table| table.refuse_unknown().map(|()| table))
            .collect()
    }

    fn open_tables(&self) -> Result<Vec<Table<'a>>> {
        let open = |(index, (span, table)): (usize, (Option<usize>, &'a dyn TableLike))| {
            let line = span.map(|offset| self.source.line(offset)).or(self.line);
            let path = format!("{}[{}]", self.path, index + 1);
            Table {
                keys: Keys {
                    source: self.source,
                    table,
                    line,
                    known: &[],
                },
                path,
            }
        };
        Ok(self
            .listed_tables()?
            .into_iter()
            .enumerate()
            .map(open)
            .collect())
    }

    fn listed_tables(&self) -> Result<Vec<(Option<usize>, &'a dyn TableLike)>> {
        if let Some(list) = self.item.as_array_of_tables() {
            return Ok(list
                .iter()
                .map(|table| (start(table.span()), table as &dyn TableLike))
                .collect());
        }
        let wrong = || {
            self.expected(format!(
                "a list of tables, each under [[{}]] or in {{ }}",
                self.path
            ))
        };
        let array = self.item.as_array().ok_or_else(wrong)?;
        let entry = |value: &'a Value| {
            let table = value.as_inline_table().ok_or_else(wrong)?;
            Ok((start(value.span()), table as &dyn TableLike))
        };
        array.iter().map(entry).collect()
    }
}

fn start(span: Option<std::ops::Range<usize>>) -> Option<usize> {
    span.map(|range| range.start)
}

fn span_start(key: &Key, item: &Item) -> Option<usize> {
    start(key.span()).or_else(|| start(item.span()))
}

fn plain_number(item: &Item) -> Option<f64> {
    item.as_value().and_then(value_number)
}

fn value_number(value: &Value) -> Option<f64> {
    value
        .as_float()
        .or_else(|| value.as_integer().map(|whole| whole as f64))
}

fn chosen<T: Copy>(text: &str, names: &[(&str, T)]) -> Option<T> {
    names
        .iter()
        .find(|(name, _)| *name == text)
        .map(|(_, value)| *value)
}

/// The value as it stands in the text, cut where it is long.
fn shown(item: &Item) -> String {
    const LONGEST: usize = 60;
    let Some(value) = item.as_value() else {
        return format!("a {}", item.type_name());
    };
    let mut plain = value.clone();
    plain.decor_mut().clear();
    let text = plain.to_string().replace(['\n', '\r'], " ");
    if text.chars().count() <= LONGEST {
        return format!("{} ({})", text, value.type_name());
    }
    format!(
        "{}… ({})",
        text.chars().take(LONGEST).collect::<String>(),
        value.type_name()
    )
}

fn listed<'a>(names: impl Iterator<Item = &'a str>) -> String {
    names
        .map(|name| format!("`{name}`"))
        .collect::<Vec<_>>()
        .join(", ")
}

fn nearest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    known.min_by_key(|candidate| strsim::damerau_levenshtein(word, candidate))
}

/// Three numbers of an array, each in the domain.
fn three(array: &toml_edit::Array, domain: Domain) -> Option<[f64; 3]> {
    let numbers: Vec<f64> = array
        .iter()
        .filter_map(value_number)
        .filter(|&value| domain.holds(value))
        .collect();
    (array.len() == 3)
        .then(|| numbers.try_into().ok())
        .flatten()
}
