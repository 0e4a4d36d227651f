//! The way to measure that reaches what is wanted with the least effort; where none does, the one
//! that comes nearest.

use super::design::{Design, rounded};
use super::hull::Hull;
use super::means::Means;
use super::optimum::Optima;
use super::predict::{expected, predicted, sets_going};
use super::step::{PlannedSwing, Step};
use super::wanted::Wanted;
use super::warnings::from_in_phase;
use gyradius_base::error::{Error, Result};
use gyradius_base::parallel::in_parallel;
use gyradius_identification::expected::Expected;
use gyradius_identification::{Input, InputKind, QuantityName};

/// Spacings that are thought of, over twice the yaw gyradius: near to it, and off it by enough for
/// a beat.
const SPACINGS: [f64; 4] = [0.85, 0.93, 1.07, 1.15];
/// Nearer to it yaw and sway hardly beat: n > 16 by (12).
const KEEPS_STEP: f64 = 0.03;
/// Lengths and spacings that differ by less are one.
const ALIKE: f64 = 0.03;
/// A tilt and a steep one, degrees: the paper's were 23° and 31°, and nearer to level the precision
/// deteriorates rapidly (beside (26)).
const TILTS_DEG: [f64; 2] = [25.0, 35.0];
/// Yaw this near to the in-phase mode is swung by itself, sway by itself.
const APART_FROM: f64 = 0.06;
/// Ways whose effort is within this of the least count as alike: the most certain of them is taken.
const ALIKE_EFFORT: f64 = 0.1;
/// Below this share of what is wanted more certainty is worth nothing: then the spacing nearest to
/// twice the gyradius is.
const COMFORT: f64 = 0.7;
/// So many of the leading ways are looked at by what their samples would say.
const LEADING: usize = 3;
/// A period's part in what is wanted, at most.
const PERIODS_PART: f64 = 1.0 / 3.0;
/// Bounds of the period uncertainty that is asked of a swing.
const PERIOD_U: (f64, f64) = (2e-6, 1e-3);
/// A recording is lengthened by so much at a time where its samples are what limits.
const LONGER: f64 = 2.0;

/// A way to measure, and what it is expected to give.
#[derive(Debug, Clone)]
pub struct Way {
    pub design: Design,
    pub steps: Vec<Step>,
    pub expected: Expected,
    /// The largest of the uncertainties over those wanted.
    pub worst: f64,
    pub effort_s: f64,
    /// Distance of the spacing from twice the yaw gyradius, as a logarithm.
    from_gyradius: f64,
}

/// The best way.
///
/// # Errors
/// Where the hull can be hung in none of the ways thought of.
pub fn search(hull: &Hull, means: &Means, wanted: &[Wanted], optima: &Optima) -> Result<Way> {
    let programmes = programmes(means, wanted);
    let judge = |designs: Vec<Design>| {
        in_parallel(designs.len(), |i| {
            Way::of(hull, means, wanted, &designs[i], false)
        })
    };
    let simplest = programmes
        .first()
        .map_or_else(Vec::new, |first| designs(hull, means, first, optima));
    let (mut ways, errors) = parted(judge(simplest));
    let reason = || {
        Error::no_result(
            "plan",
            "the hull can be hung in none of the ways thought of",
        )
    };
    if ways.is_empty() {
        return Err(errors.into_iter().next().unwrap_or_else(reason));
    }
    in_order(&mut ways);
    // What more can be done is thought of for the best dimensions alone.
    let best: Vec<Design> = ways
        .iter()
        .take(LEADING)
        .map(|way| way.design.clone())
        .collect();
    let more = programmes
        .iter()
        .skip(1)
        .flat_map(|programme| best.iter().filter_map(|d| programme.sized(d, means)));
    ways.extend(parted(judge(more.collect())).0);
    in_order(&mut ways);
    ways.truncate(LEADING);
    let mut by_samples: Vec<Way> = Vec::new();
    for way in &ways {
        let Ok(looked_at) = Way::of(hull, means, wanted, &way.design, true) else {
            continue;
        };
        let longer = looked_at.lengthened(hull, means, wanted);
        let is_enough = longer.worst <= 1.0;
        by_samples.push(longer);
        if is_enough {
            break;
        }
    }
    in_order(&mut by_samples);
    let mut best = by_samples.into_iter().next().ok_or_else(reason)?;
    best.fill(hull, means, wanted)?;
    Ok(best)
}

/// Those that reach what is wanted first, by effort; then the others, the nearest to it first.
fn in_order(ways: &mut [Way]) {
    let least = ways
        .iter()
        .filter(|w| w.worst <= 1.0)
        .map(|w| w.effort_s)
        .fold(f64::INFINITY, f64::min);
    let rank = |way: &Way| match (
        way.worst <= 1.0,
        way.effort_s <= (1.0 + ALIKE_EFFORT) * least,
    ) {
        (true, true) => (0, way.worst.max(COMFORT) + way.from_gyradius),
        (true, false) => (1, way.effort_s),
        // Ways that come as near as no matter go by effort.
        (false, _) => (2, way.worst * (1.0 + 1e-5 * way.effort_s)),
    };
    ways.sort_by(|a, b| {
        let (a, b) = (rank(a), rank(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
}

impl Way {
    fn of(
        hull: &Hull,
        means: &Means,
        wanted: &[Wanted],
        design: &Design,
        by_samples: bool,
    ) -> Result<Self> {
        let mut design = design.clone();
        let mut steps = design.steps(hull, means);
        let shown = predicted(hull, means, &steps)?;
        let is_near = shown
            .iter()
            .filter_map(|s| from_in_phase(&s.periods_s))
            .any(|a| a.abs() < APART_FROM);
        if is_near && design.is_level {
            design.is_apart = true;
            steps = design.steps(hull, means);
        }
        let expected = expected(hull, means, &steps, by_samples)?;
        let worst = wanted
            .iter()
            .map(|w| over_wanted(&expected, hull, w))
            .fold(0.0, f64::max);
        let effort_s = design.effort_s(&steps);
        let from_gyradius = (0.5 * design.spacing_m / hull.k_yaw_m.value).ln().abs();
        Ok(Self {
            design,
            steps,
            expected,
            worst,
            effort_s,
            from_gyradius,
        })
    }

    /// With longer recordings where their samples are what limits.
    fn lengthened(self, hull: &Hull, means: &Means, wanted: &[Wanted]) -> Self {
        let mut best = self;
        while best.worst > 1.0 && best.is_limited_by_samples(hull, wanted) {
            let duration_s = (LONGER * best.design.duration_s).min(means.most_duration_s);
            if duration_s <= best.design.duration_s {
                break;
            }
            let design = Design {
                duration_s,
                ..best.design.clone()
            };
            match Way::of(hull, means, wanted, &design, true) {
                Ok(longer) if longer.worst < best.worst => best = longer,
                _ => break,
            }
        }
        best
    }

    fn is_limited_by_samples(&self, hull: &Hull, wanted: &[Wanted]) -> bool {
        wanted
            .iter()
            .filter(|w| over_wanted(&self.expected, hull, w) > 1.0)
            .any(|w| {
                let budget = self.expected.budget.get(&w.quantity);
                budget
                    .and_then(|lines| lines.first())
                    .is_some_and(|line| line.input.kind == InputKind::Samples)
            })
    }

    /// Puts into the swings the periods to expect and the uncertainty of a period that is enough.
    fn fill(&mut self, hull: &Hull, means: &Means, wanted: &[Wanted]) -> Result<()> {
        let shown = predicted(hull, means, &self.steps)?;
        let by_periods = expected(hull, means, &self.steps, false).unwrap_or_default();
        let swinging = self.steps.iter_mut().filter_map(|step| match step {
            Step::Swing(swing) => Some(swing),
            Step::Incline(_) => None,
        });
        for (swing, shown) in swinging.zip(shown) {
            swing.periods_s = shown.periods_s;
            swing.period_u_wanted = period_u_wanted(hull, means, swing, wanted, &by_periods);
        }
        Ok(())
    }
}

/// The expected uncertainty of a quantity over that wanted; infinite where it is not determined.
pub fn over_wanted(expected: &Expected, hull: &Hull, wanted: &Wanted) -> f64 {
    let u = expected
        .quantities
        .get(&wanted.quantity)
        .and_then(|q| q.u.scalar());
    u.map_or(f64::INFINITY, |u| u / wanted.u_of(hull))
}

/// The relative uncertainty of a swing's periods at which none takes more than its part of what is
/// wanted.
fn period_u_wanted(
    hull: &Hull,
    means: &Means,
    swing: &PlannedSwing,
    wanted: &[Wanted],
    by_periods: &Expected,
) -> f64 {
    let bound =
        |mode| super::predict::period_u(means, swing, mode, swing.periods_s.get(&mode).copied()?);
    let is_going = |mode| swing.excited.iter().any(|e| sets_going(*e, mode));
    let going = || {
        swing
            .periods_s
            .keys()
            .copied()
            .filter(|mode| is_going(*mode))
    };
    let allowed = |w: &Wanted| {
        let lines = by_periods.budget.get(&w.quantity)?;
        let of_mode = |mode| {
            let label = Input::period(mode, &swing.id);
            let line = lines.iter().find(|line| line.input == label)?;
            Some(bound(mode)? * PERIODS_PART * w.u_of(hull) / line.u_contribution)
        };
        going().filter_map(of_mode).min_by(f64::total_cmp)
    };
    wanted
        .iter()
        .filter_map(allowed)
        .fold(PERIOD_U.1, f64::min)
        .max(PERIOD_U.0)
}

fn parted(judged: Vec<Result<Way>>) -> (Vec<Way>, Vec<Error>) {
    let (mut ways, mut errors) = (Vec::new(), Vec::new());
    for way in judged {
        match way {
            Ok(way) => ways.push(way),
            Err(error) => errors.push(error),
        }
    }
    (ways, errors)
}

/// A programme at all dimensions that are thought of.
fn designs(hull: &Hull, means: &Means, programme: &Design, optima: &Optima) -> Vec<Design> {
    let spacings = spacings(hull, means);
    let lengths = lengths(
        means,
        optima,
        programme.is_fore_and_aft && !programme.is_level,
    );
    let at = |line_length_m: f64| {
        spacings.iter().map(move |spacing_m| Design {
            line_length_m,
            spacing_m: *spacing_m,
            ..programme.clone()
        })
    };
    lengths.into_iter().flat_map(at).collect()
}

impl Design {
    /// This programme at the dimensions of another; `None` where there is no room for a second
    /// length.
    fn sized(&self, like: &Design, means: &Means) -> Option<Self> {
        let second_length_m = match self.second_length_m {
            Some(_) => Some(second_length(means, like.line_length_m)?),
            None => None,
        };
        let (line_length_m, spacing_m) = (like.line_length_m, like.spacing_m);
        Some(Design {
            line_length_m,
            spacing_m,
            second_length_m,
            ..self.clone()
        })
    }
}

/// What may be done, dimensions left open.
fn programmes(means: &Means, wanted: &[Wanted]) -> Vec<Design> {
    let wants = |name: QuantityName| wanted.iter().any(|w| w.quantity == name);
    let bare = Design {
        line_length_m: 0.0,
        second_length_m: None,
        spacing_m: 0.0,
        is_level: wants(QuantityName::KYaw)
            || wants(QuantityName::KPitch)
            || wants(QuantityName::Psi)
            || !wants(QuantityName::KRoll),
        is_fore_and_aft: wants(QuantityName::KRoll),
        tilts_deg: vec![],
        is_inclined: false,
        duration_s: means.least_duration_s,
        is_apart: false,
        with_pitch: wants(QuantityName::KPitch)
            || wants(QuantityName::CmDepth)
            || wants(QuantityName::Psi),
    };
    let mut list = vec![bare.clone()];
    if wants(QuantityName::Psi) {
        list.clear();
        for tilt in TILTS_DEG {
            let one = Design {
                tilts_deg: vec![-tilt],
                is_fore_and_aft: true,
                ..bare.clone()
            };
            let both = Design {
                tilts_deg: vec![tilt, -tilt],
                ..bare.clone()
            };
            let all = Design {
                is_fore_and_aft: true,
                ..both.clone()
            };
            list.extend([one, both, all]);
        }
    }
    if wants(QuantityName::CmDepth) || wants(QuantityName::KPitch) || wants(QuantityName::KRoll) {
        let with_incline = |d: &Design| Design {
            is_inclined: true,
            ..d.clone()
        };
        let inclined: Vec<Design> = list.iter().take(1).map(with_incline).collect();
        let twice = |d: &Design| Design {
            second_length_m: Some(0.0),
            ..d.clone()
        };
        let twice: Vec<Design> = list
            .iter()
            .take(1)
            .filter(|d| d.is_level)
            .map(twice)
            .collect();
        list.extend(inclined.into_iter().chain(twice));
    }
    list
}

/// The best lengths, the longest there is room for, and one between.
fn lengths(means: &Means, optima: &Optima, for_roll: bool) -> Vec<f64> {
    let (least, most) = (means.least_line_length_m, means.most_line_length_m);
    let best = if for_roll {
        [
            optima.line_length_roll_joint_m,
            optima.line_length_roll_depth_known_m,
        ]
    } else {
        [optima.line_length_joint_m, optima.line_length_depth_known_m]
    };
    let between = best[1].map_or(least, |known| (known.clamp(least, most) * most).sqrt());
    let all = best.into_iter().flatten().chain([between, most]);
    unlike(all.map(|length| rounded(length).clamp(least, most)))
}

fn second_length(means: &Means, first_m: f64) -> Option<f64> {
    let (least, most) = (means.least_line_length_m, means.most_line_length_m);
    let other = if first_m > (least * most).sqrt() {
        0.5 * first_m
    } else {
        2.0 * first_m
    };
    let other = rounded(other).clamp(least, most);
    ((other / first_m).ln().abs() > 0.2).then_some(other)
}

/// Spacings within reach: near to twice the gyradius but off it, the narrowest and the widest.
fn spacings(hull: &Hull, means: &Means) -> Vec<f64> {
    let (least, most) = means.spacings_m(hull.beam_m);
    let best = 2.0 * hull.k_yaw_m.value;
    let near = SPACINGS
        .iter()
        .map(|s| s * best)
        .filter(|s| (least..=most).contains(s));
    let all = unlike(
        near.chain([most, least])
            .map(|spacing| rounded(spacing).clamp(least, most)),
    );
    let beats = |spacing: &f64| (spacing / best - 1.0).abs() > KEEPS_STEP;
    let beating: Vec<f64> = all.iter().copied().filter(beats).collect();
    if beating.is_empty() { all } else { beating }
}

fn unlike(lengths: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut list: Vec<f64> = Vec::new();
    for length in lengths {
        if list.iter().all(|known| (length / known).ln().abs() > ALIKE) {
            list.push(length);
        }
    }
    list
}
