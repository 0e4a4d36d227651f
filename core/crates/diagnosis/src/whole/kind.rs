//! What competes: every cause of the catalogue, and what has no name.

use super::super::cause_id::CauseId;
use super::super::causes::{
    Scales, TERMS, catalogue, knock_at, learned_force, line_slip_at, mounts, ringing, seconds,
    slip_at,
};
use super::super::look::Standing;
use super::super::moments::moments;
use super::super::point::{Cause, Form};
use super::super::search::PEAKS;
use super::super::selection;
use super::super::white::Left;
use gyradius_base::error::Result;

/// A cause, whatever of its numbers a look begins at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    Named(CauseId),
    /// A force over a coordinate.
    Force(usize),
    Knock,
    LineSlip,
    /// Another thing that moves inside.
    Second,
}

impl Kind {
    pub fn of(cause: &Cause) -> Self {
        match (cause.id, cause.form) {
            (CauseId::Unknown, Form::Force(coordinate)) => Self::Force(coordinate),
            (CauseId::Unknown, Form::Knock(_)) => Self::Knock,
            (CauseId::Unknown, Form::LineSlip(_)) => Self::LineSlip,
            (CauseId::Unknown, Form::Second) => Self::Second,
            (id, _) => Self::Named(id),
        }
    }

    fn id(self) -> CauseId {
        match self {
            Self::Named(id) => id,
            _ => CauseId::Unknown,
        }
    }
}

/// Every kind with how many numbers it has.
pub fn kinds(scales: &Scales) -> Vec<(Kind, selection::Form)> {
    let mut causes = named(scales);
    causes.push(slip_at(0, 0.0));
    causes.extend(forces(scales));
    causes.extend([knock_at(scales, 0, 0.0), line_slip_at(scales, 0, 0.0)]);
    causes.extend(seconds(scales, &[]));
    let mut all: Vec<(Kind, selection::Form)> = vec![];
    for cause in &causes {
        let kind = Kind::of(cause);
        if all.iter().all(|(known, _)| *known != kind) {
            let form = selection::Form {
                id: kind.id(),
                numbers: cause.parameters.len(),
                shows: true,
            };
            all.push((kind, form));
        }
    }
    all
}

fn named(scales: &Scales) -> Vec<Cause> {
    [catalogue(scales), mounts()].concat()
}

fn forces(scales: &Scales) -> Vec<Cause> {
    let force = |coordinate| learned_force(scales, coordinate, &TERMS);
    (0..4).map(force).collect()
}

/// What is looked at beside a model: from all that a look can begin at. Where nothing is left to see,
/// causes that move the body's figures though they are too weak to be seen themselves: of those that a
/// look sees by many strengths at once, evidence of none is left.
pub fn instances(standing: &Standing, left: &Left) -> Result<Vec<Cause>> {
    let model = &standing.model;
    let scales = Scales::of(model.base, &standing.fitted.point)?;
    let has = |kind: Kind| model.causes.iter().any(|cause| Kind::of(cause) == kind);
    let mut all = catalogue(&scales);
    if left.is_white() {
        all.retain(|cause| cause.look.is_none());
    } else {
        let peaks_hz = left.peaks_hz(PEAKS);
        all.extend(mounts());
        all.extend(ringing(&scales, &peaks_hz));
        all.extend(forces(&scales));
        if has(Kind::Named(CauseId::InternalMotion)) {
            all.extend(seconds(&scales, &peaks_hz));
        }
    }
    // What happens at one moment leaves little in any one band of a spectrum.
    all.extend(moments(standing)?.into_iter().map(|look| look.cause));
    all.retain(|cause| !has(Kind::of(cause)));
    Ok(all)
}
