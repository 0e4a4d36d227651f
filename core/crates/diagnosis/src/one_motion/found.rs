//! What the selection of causes comes to: those asked for, what they leave, what others may stand in
//! their place.

use std::collections::BTreeMap;

use gyradius_base::error::Result;
use gyradius_base::parallel::in_parallel;
use gyradius_base::progress::{Progress, tell};

use super::super::cause_id::CauseId;
use super::super::decision::{Decided, Decision, decide};
use super::super::parameter_id::ParameterId;
use super::super::result::{CauseResult, CauseVerdict, ParameterResult};
use super::super::selection::{Competing, Set, select};
use super::super::verdict::{MOST_LEFT_RMS, judged};
use super::super::white::{Left, in_record};
use super::competing::{Model, Swings};
use super::swing::Swing;

/// What was found.
pub struct Found<'a> {
    pub swings: &'a [Swing<'a>],
    pub decision: Decision<Model>,
    /// What each leaves.
    pub base_left: Left,
    pub left: Left,
}

/// Selects; `None` where no simulation can be fitted to a swing.
pub fn find<'a>(swings: &'a [Swing<'a>], progress: &Progress) -> Result<Option<Found<'a>>> {
    tell(progress, 0.3, "weighing every set of causes")?;
    let measured = swings[0].measured_set();
    let mut learned = measured.clone();
    learned.extend(swings[0].form_of(CauseId::Unknown));
    let all = Swings(swings);
    let Some(selection) = select(&all, &[measured, learned]) else {
        return Ok(None);
    };
    tell(progress, 0.9, "judging by samples held out")?;
    let found = decide(&all, selection).and_then(|decision| {
        Some(Found {
            base_left: left(swings, &decision.base)?,
            left: left(swings, &decision.best)?,
            swings,
            decision,
        })
    });
    Ok(found)
}

impl Decided for Swings<'_> {
    fn held_out(&self, model: &Model) -> Option<(f64, usize)> {
        let of_swing = |s: usize| {
            let swing = &self.0[s];
            let rows = swing.held_out(&swing.fittings(&model.set), &model.swings[s].x)?;
            Some((rows.norm_squared(), rows.len()))
        };
        let parts = in_parallel(self.0.len(), of_swing);
        let parts = parts.into_iter().collect::<Option<Vec<_>>>()?;
        let sum = |(a, b): (f64, usize), (c, d): (f64, usize)| (a + c, b + d);
        Some(parts.into_iter().fold((0.0, 0), sum))
    }

    fn without(&self, set: &Set, larger: &Model) -> Option<Model> {
        let mut from = larger.clone();
        from.set = set.clone();
        for (swing, one) in self.0.iter().zip(&mut from.swings) {
            let mut kept = one.x[..swing.first_cause()].to_vec();
            for (form, _, places) in swing.causes_of(&larger.set) {
                if set.contains(&form) {
                    kept.extend(&one.x[places]);
                }
            }
            one.x = kept;
        }
        self.fitted(set, Some(&from))
    }

    fn chi2(&self, model: &Model) -> f64 {
        model.swings.iter().map(|one| one.chi2).sum()
    }
}

/// What a model leaves of the blocks beside white noise.
fn left(swings: &[Swing], model: &Model) -> Option<Left> {
    let mut left = Left::default();
    for (s, (swing, one)) in swings.iter().zip(&model.swings).enumerate() {
        let rows = swing.left(&model.set, &one.x)?;
        let bands = in_record(
            (s, 0),
            &swing.block_times_s(),
            rows.as_slice(),
            swings.len(),
        );
        left.bands.extend(bands);
    }
    Some(left)
}

/// Numbers of a cause in a model, swing by swing.
fn parameters(
    swings: &[Swing],
    model: &Model,
    id: CauseId,
) -> BTreeMap<ParameterId, ParameterResult> {
    let mut all = BTreeMap::new();
    for (s, (swing, one)) in swings.iter().zip(&model.swings).enumerate() {
        let of_cause = swing.causes_of(&model.set);
        for (_, cause, places) in of_cause.filter(|(_, cause, _)| cause.id == id) {
            let own = (swings.len() > 1).then_some(s);
            for (place, parameter) in places.zip(&cause.parameters) {
                let u = one.covariance.as_ref();
                let u = u.map_or(f64::INFINITY, |c| c[(place, place)].max(0.0).sqrt());
                let name = ParameterId::of(parameter.name, own);
                all.insert(name, parameter.result(one.x[place], u));
            }
        }
    }
    all
}

impl Found<'_> {
    /// Whether structure remains that nothing with a name accounts for.
    pub fn is_unexplained(&self) -> bool {
        let is_noise = self.rms(&self.decision.best) <= MOST_LEFT_RMS;
        self.decision.is_unknown || !is_noise || !self.left.is_next_to_nothing(&self.base_left)
    }

    /// Causes that do as well in the place of those asked for, the best first.
    pub fn instead(&self) -> Vec<CauseId> {
        if self.is_unexplained() {
            return vec![];
        }
        let of = |model: &Model, id| parameters(self.swings, model, id);
        self.decision.instead(of)
    }

    pub fn verdict(&self) -> CauseVerdict {
        judged(
            self.decision.all_names(),
            self.instead(),
            self.is_unexplained(),
        )
    }

    /// Every cause with its share of the posterior.
    pub fn causes(&self) -> Vec<CauseResult> {
        let left = self.is_unexplained().then(|| self.left.excess());
        let of = |model: &Model, id| parameters(self.swings, model, id);
        self.decision.causes(of, left, None)
    }

    /// Residual over noise of a model.
    pub fn rms(&self, model: &Model) -> f64 {
        let scaled = self.swings.iter().zip(&model.swings);
        let square = |(swing, one): (&Swing, &super::competing::One)| {
            one.chi2 * (swing.noise / swing.readings().noise).powi(2)
        };
        let rows: usize = self.swings.iter().map(|s| s.readings().blocks.len()).sum();
        (scaled.map(square).sum::<f64>() / rows.max(1) as f64).sqrt()
    }
}
