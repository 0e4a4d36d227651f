//! The plain data of the core as UniFFI sees them, one file for each module; the procedure's are
//! three.
//!
//! `#[uniffi::remote]` stands before a copy of a type's fields: no type is made, the core's own
//! crosses. Where a name would clash with one of Foundation, SwiftUI or Kotlin, an alias gives it
//! another. Tuples, arrays and sorted maps, which UniFFI does not have, cross as the records and
//! lists of this file.

pub mod critique;
pub mod inertia;
pub mod live;
pub mod names;
pub mod plan;
pub mod procedure;
pub mod readings;
pub mod recorder;
pub mod recording;
pub mod report;
pub mod sentence;

use std::collections::{BTreeMap, HashMap};

use gyradius_core::identification::{BudgetLine, QuantityName, QuantityResult, Route};
use gyradius_core::planning::PredictedQuantity;
use gyradius_core::recording::ModeName;

/// A number of things.
pub type Count = usize;
uniffi::custom_type!(Count, u64, {
    remote,
    lower: |count| count as u64,
    try_lift: |count| Ok(count.try_into()?),
});

/// Three components along x, y and z.
#[derive(Debug, Clone, Copy, PartialEq, uniffi::Record)]
pub struct Axes {
    /// Along x.
    pub x: f64,
    /// Along y.
    pub y: f64,
    /// Along z.
    pub z: f64,
}

/// A vector of the core.
pub type Vector3 = [f64; 3];
uniffi::custom_type!(Vector3, Axes, {
    remote,
    lower: |v| Axes { x: v[0], y: v[1], z: v[2] },
    try_lift: |v| Ok([v.x, v.y, v.z]),
});

/// From one number to another.
#[derive(Debug, Clone, Copy, PartialEq, uniffi::Record)]
pub struct Interval {
    /// Its lower end.
    pub low: f64,
    /// Its upper end.
    pub high: f64,
}

/// An interval of the core.
pub type Ends = [f64; 2];
uniffi::custom_type!(Ends, Interval, {
    remote,
    lower: |ends| Interval { low: ends[0], high: ends[1] },
    try_lift: |interval| Ok([interval.low, interval.high]),
});

/// A figure by the name of what it is of; lists of them are in the order of the names.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct NamedNumber {
    /// Of what.
    pub name: String,
    /// The figure.
    pub value: f64,
}

/// A word or sentence by name.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct NamedText {
    /// Of what.
    pub name: String,
    /// What it says.
    pub text: String,
}

/// A quantity by name: `k_yaw_m`, `cm_depth_m`, `psi_deg` …
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct NamedQuantity {
    /// The quantity, unit included.
    pub name: String,
    /// What it was found to be.
    pub quantity: QuantityResult,
}

/// What a plan is expected to give for one quantity.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct NamedPrediction {
    /// The quantity, unit included.
    pub name: String,
    /// How well it will be known.
    pub quantity: PredictedQuantity,
}

/// The budget of one quantity.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct NamedBudget {
    /// The quantity.
    pub name: String,
    /// Contributions of each input, largest first.
    pub lines: Vec<BudgetLine>,
}

/// The single routes to one quantity.
#[derive(Debug, Clone, PartialEq, uniffi::Record)]
pub struct NamedRoutes {
    /// The quantity.
    pub name: String,
    /// The routes.
    pub routes: Vec<Route>,
}

/// Declares that a map of the core, sorted by name, crosses as a list of records in that order.
macro_rules! by_name {
    ($alias:ident, $key:ty, $value:ty, $record:ident, $field:ident) => {
        #[doc = concat!("`", stringify!($record), "`s as the core holds them.")]
        pub type $alias = BTreeMap<$key, $value>;
        uniffi::custom_type!($alias, Vec<$record>, {
            remote,
            lower: |map| {
                let named = |(name, $field): ($key, $value)| $record { name: name.to_string(), $field };
                map.into_iter().map(named).collect()
            },
            try_lift: |list| {
                let keyed = |one: $record| Ok((one.name.parse()?, one.$field));
                list.into_iter().map(keyed).collect()
            },
        });
    };
}

by_name!(NumbersByName, String, f64, NamedNumber, value);
by_name!(TextsByName, String, String, NamedText, text);
by_name!(
    QuantitiesByName,
    QuantityName,
    QuantityResult,
    NamedQuantity,
    quantity
);
by_name!(ShiftsByName, QuantityName, f64, NamedNumber, value);
by_name!(SourcesByName, QuantityName, String, NamedText, text);
by_name!(
    PredictionsByName,
    QuantityName,
    PredictedQuantity,
    NamedPrediction,
    quantity
);
by_name!(
    BudgetsByName,
    QuantityName,
    Vec<BudgetLine>,
    NamedBudget,
    lines
);
by_name!(RoutesByName, QuantityName, Vec<Route>, NamedRoutes, routes);

/// A number for each mode.
pub type NumbersByMode = BTreeMap<ModeName, f64>;
uniffi::custom_type!(NumbersByMode, HashMap<ModeName, f64>, {
    remote,
    lower: |map| map.into_iter().collect(),
    try_lift: |map| Ok(map.into_iter().collect()),
});
