//! Names of the core, which are enumerations there and cross as the text that files have.

use gyradius_core::diagnosis::{CauseId, DiscrepancyKind, ForceCoordinate, Status, Unit};
use gyradius_core::identification::{
    AmplitudeUnit, Decision, FindingKind, Input, Method, QuantityName, Relation, RouteMethod,
    Severity, Subject,
};

/// Declares that a type of the core crosses as its text.
macro_rules! by_text {
    ($($(#[$about:meta])* $alias:ident = $kind:ty),+ $(,)?) => {$(
        $(#[$about])*
        pub type $alias = $kind;
        uniffi::custom_type!($alias, String, {
            remote,
            lower: |name| name.to_string(),
            try_lift: |text| Ok(text.parse()?),
        });
    )+};
}

by_text! {
    /// A quantity, unit included: `k_yaw_m`.
    QuantityKey = QuantityName,
    /// How a quantity was got.
    MethodName = Method,
    /// A closed-form estimator.
    RouteName = RouteMethod,
    /// `rad`, `m`, or `rad/s` where only the rate is known.
    AmplitudeUnitName = AmplitudeUnit,
    /// `>=` or `<=`.
    RelationSign = Relation,
    /// `pass`, `fail` or `undecided`.
    DecisionName = Decision,
    /// An input of a budget.
    InputName = Input,
    /// A stated dimension, or a quantity.
    SubjectName = Subject,
    /// A kind of finding.
    KindOfFinding = FindingKind,
    /// `noted`, `refused`, `warned` or `widened`.
    SeverityName = Severity,
    /// A cause that the criticism tries.
    CauseName = CauseId,
    /// The verdict in one word.
    CauseStatus = Status,
    /// What a learned force acts on.
    CoordinateName = ForceCoordinate,
    /// A kind of discrepancy.
    KindOfDiscrepancy = DiscrepancyKind,
    /// A unit of the criticism's figures.
    UnitText = Unit,
}
