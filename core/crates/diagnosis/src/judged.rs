//! Class limits judged by all that is known: the measurement, and what its criticism found.

use gyradius_identification::routes::guard::{Limit, verdict};
use gyradius_identification::{Decision, Measurement, QuantityResult, Verdict};
use gyradius_recording::Quantity;

use super::result::{Critique, Status};

/// A measurement whose verdicts are those after its criticism; all else stays as it is.
///
/// To be called with the measurement itself, not with what this gave before: a probability would be
/// averaged twice.
pub fn judged_with(measurement: &Measurement, critique: &Critique) -> Measurement {
    let judged = |old: &Verdict| verdict_with(old, critique);
    Measurement {
        verdicts: measurement.verdicts.iter().map(judged).collect(),
        ..measurement.clone()
    }
}

/// The verdict of the extended simulation, where something was missing; undecided where that is one
/// guess among several and the base simulation decides otherwise.
fn verdict_with(base: &Verdict, critique: &Critique) -> Verdict {
    let extended = critique.extended.quantities.get(&base.quantity);
    let judged = |quantity: &QuantityResult| judged_again(base, quantity);
    let new = || extended.and_then(judged).unwrap_or_else(|| base.clone());
    match critique.verdict.status {
        Status::Adequate => base.clone(),
        Status::Explained => new(),
        Status::Ambiguous | Status::Unexplained => agreed(base, new()),
    }
}

/// What two models that may both be right say together: undecided where they do not decide alike.
/// Neither is known to be likelier, so their probabilities are averaged.
fn agreed(base: &Verdict, extended: Verdict) -> Verdict {
    let decision = match base.verdict == extended.verdict {
        true => base.verdict,
        false => Decision::Undecided,
    };
    let probability = 0.5 * (base.conformance_probability + extended.conformance_probability);
    Verdict {
        verdict: decision,
        conformance_probability: probability,
        ..extended
    }
}

fn judged_again(old: &Verdict, quantity: &QuantityResult) -> Option<Verdict> {
    let limit = Limit {
        quantity: old.quantity.to_string(),
        relation: old.relation,
        limit: old.limit,
    };
    let value = Quantity::new(quantity.value.scalar()?, quantity.u.scalar()?);
    verdict(value, &limit).ok()
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;
    use crate::result::{CauseVerdict, ModelResult};
    use gyradius_identification::{Method, QuantityName, Value};

    fn yaw(value: f64) -> BTreeMap<QuantityName, QuantityResult> {
        let quantity = QuantityResult {
            value: Value::Scalar(value),
            u: Value::Scalar(0.001),
            interval_95: None,
            method: Method::JointEstimate,
        };
        BTreeMap::from([(QuantityName::KYaw, quantity)])
    }

    fn measured(value: f64) -> Measurement {
        let limit: Limit = "k_yaw_m>=1.05".parse().unwrap();
        Measurement {
            quantities: yaw(value),
            verdicts: vec![verdict(Quantity::new(value, 0.001), &limit).unwrap()],
            ..Measurement::default()
        }
    }

    fn criticised(status: Status, value: f64) -> Critique {
        Critique {
            verdict: CauseVerdict {
                status,
                ..CauseVerdict::default()
            },
            extended: ModelResult {
                quantities: yaw(value),
                ..ModelResult::default()
            },
            ..Critique::default()
        }
    }

    #[test]
    fn a_guess_among_several_decides_nothing() {
        let (base, other) = (1.06, 1.04);
        for (status, expected) in [
            (Status::Adequate, Decision::Pass),
            (Status::Explained, Decision::Fail),
            (Status::Ambiguous, Decision::Undecided),
            (Status::Unexplained, Decision::Undecided),
        ] {
            let judged = judged_with(&measured(base), &criticised(status, other));
            assert_eq!(judged.verdicts[0].verdict, expected, "{status}");
            assert_eq!(judged.quantities, measured(base).quantities);
        }
        let judged = judged_with(&measured(base), &criticised(Status::Ambiguous, other));
        assert!((judged.verdicts[0].conformance_probability - 0.5).abs() < 1e-9);
    }

    #[test]
    fn models_that_decide_alike_decide() {
        let judged = judged_with(&measured(1.06), &criticised(Status::Ambiguous, 1.07));
        assert_eq!(judged.verdicts[0].verdict, Decision::Pass);
    }

    #[test]
    fn a_quantity_that_was_not_criticised_keeps_its_verdict() {
        let mut critique = criticised(Status::Unexplained, 1.04);
        critique.extended.quantities.clear();
        let judged = judged_with(&measured(1.06), &critique);
        assert_eq!(judged.verdicts, measured(1.06).verdicts);
    }
}
