//! The search for causes: a first look at all, the leading few fitted in full, the best taken, and
//! again while it pays.

use nalgebra::DVector;

use gyradius_base::error::{Error, Result};
use gyradius_base::parallel::in_parallel;
use gyradius_base::progress::{Progress, tell};

use super::cause_id::CauseId;
use super::causes::{
    GUSTS, Scales, TERMS, catalogue, gust, learned_force, mounts, ringing, seconds,
};
use super::evidence::{DOUBTFUL, FURTHER_GAIN, LEAST_GAIN, asked, gain, is_missed, pays};
use super::fitting::{CONVERGED_SHARE, Derivatives, Fitted, Places};
use super::found::{Found, Looked, Round, Tried};
use super::look::{Look, RIVAL_SHARE, Standing, looks_at};
use super::moments::moments;
use super::parameter_id::ParameterName;
use super::point::{Cause, Form, Model, Part, Point};
use super::trial::least_cost;
use super::verdict::{parameters, simplest_first};
use super::white::Left;

pub const MOST_CAUSES: usize = 3;
/// What is being done when the leading causes are tried.
const FULL: &str = "fitting the leading causes in full";
/// So many are fitted in full in a round.
const LEADING: usize = 4;
/// And in a further round.
const FURTHER: usize = 3;
/// A wind that gains this share of what the best cause does may gain more than that by its gusts.
const GUSTY: f64 = 0.15;
/// A cause that takes less than this share of what is left leaves room for gusts of a wind that
/// blows no other way.
const TAKEN: f64 = 0.5;
/// A law that bends to what follows another leaves a hundredth of it or more; one that leaves a
/// third of that has its own …
const BENT: f64 = 3e-3;
/// … where so much (χ²) was there to bend to: of that a hundredth is seen in any bands, which show
/// from about thirty.
const PLAIN: f64 = 1e5;
/// A wind that hardly blows but in gusts brakes by this share of what is expected of winds before
/// its gusts are fitted.
const FAINT: f64 = 0.1;
/// Gusts that make up for less than this share of what a wind lacks are not looked for anew beside
/// each other.
const MADE_UP: f64 = 0.5;
/// Gusts that come so often in a recording at most make no line in what is left.
const SLOW_GUSTS: u32 = 8;
/// Gusts are looked for up to this frequency, Hz: faster ones act on a part of the hull only.
const FASTEST_GUST_HZ: f64 = 0.35;
/// Something that rings inside is looked for at so many frequencies where most is left.
pub const PEAKS: usize = 4;
/// Derivatives without a cause can put the logarithm of its evidence off by so much: 3 of it were
/// seen, and 4.6 are what a verdict turns on.
const CLOSE: f64 = 15.0;
/// … this is what was seen.
const SEEN_OFF: f64 = 3.0;
/// Shapes without a name come first where they leave less than this share of what the best cause
/// does.
pub const UNNAMED_LEAVES: f64 = 0.1;

/// Squares of standard deviations that a cause's strengths must be from zero to be beyond doubt:
/// thirty of them.
const SURE: f64 = 1e3;

/// Names of the parameters that say when something happened and what shows only while it does: how
/// fast it went, and how far a phone was pushed along, which its place shows a hundred times less
/// than the push.
const OF_MOMENT: [ParameterName; 5] = [
    ParameterName::AtS,
    ParameterName::OverS,
    ParameterName::ShiftXM,
    ParameterName::ShiftYM,
    ParameterName::ShiftZM,
];
/// … and how far they may move, shares of what was known of them before, while what they are
/// judged by is held out.
const PINNED: f64 = 1e-5;
/// A fit to a part of the recordings that gained more of χ² than this for each row in its last step
/// has not arrived: the fifth digit of what is left in noises.
const UNSETTLED: f64 = 2e-5;

/// Searches from a fitted base and from where its fit began.
pub fn search<'a>(
    base: Model<'a>,
    begin: Point,
    fitted: Fitted,
    progress: &Progress,
) -> Result<Found<'a>> {
    let mut found = Found::begun(base, begin, fitted)?;
    while found.model.named().count() < MOST_CAUSES {
        let n = found.rounds.len();
        let done = 0.3 + 0.2 * n as f64;
        tell(
            progress,
            done,
            if n == 0 {
                "looking at every cause"
            } else {
                "looking for a further cause"
            },
        )?;
        let looked = found.looks()?;
        tell(progress, done + 0.08, FULL)?;
        let mut tried = found.tried(foremost(&looked.looks), &|| {
            tell(progress, done + 0.13, FULL)
        })?;
        if let Some(wind) = found.may_blow(&tried, &looked.looks) {
            tell(progress, done + 0.16, "looking for gusts")?;
            if found.blows_better(&mut tried, wind) {
                found.rounds.push(Round::of(tried, true, None));
                if found.is_unexplained() || found.left.is_white() {
                    continue;
                }
                break;
            }
        }
        let taken = tried.first().filter(|best| found.pays(best)).cloned();
        let Some(best) = taken else {
            found.rounds.push(Round::of(tried, false, Some(looked)));
            break;
        };
        found.rounds.push(Round::of(tried, true, None));
        found.take(best);
    }
    found.prune();
    found.learn();
    tell(progress, 0.87, "fitting once more with all derivatives")?;
    found.polish();
    Ok(found)
}

impl<'a> Found<'a> {
    /// Nothing found yet.
    pub fn begun(base: Model<'a>, begin: Point, fitted: Fitted) -> Result<Self> {
        let base_left = Left::of(&base, &fitted.point)?;
        Ok(Self {
            looked_from: fitted.point.clone(),
            base: fitted.clone(),
            left: base_left.clone(),
            base_left,
            model: base,
            fitted,
            rounds: vec![],
            begin,
        })
    }
}

impl Found<'_> {
    /// A cause by its name beside what was taken: that of its forms that promises most, fitted in
    /// full.
    pub fn by_name(&self, id: CauseId) -> Result<Tried> {
        let scales = Scales::of(self.model.base, &self.fitted.point)?;
        let all: Vec<Cause> = catalogue(&scales).into_iter().chain(mounts()).collect();
        let forms: Vec<Cause> = all.iter().filter(|cause| cause.id == id).cloned().collect();
        if forms.is_empty() {
            let mut names: Vec<&str> = all
                .iter()
                .filter(|cause| cause.id != CauseId::Unknown)
                .map(|cause| cause.id.name())
                .collect();
            names.dedup();
            return Err(Error::argument(
                "cause",
                format!("one of {}", names.join(", ")),
                id,
            ));
        }
        let looks = looks_at(&Standing::of(&self.model, &self.fitted.point)?, &forms);
        let best = looks.into_iter().max_by(|a, b| a.gain.total_cmp(&b.gain));
        let reason = || Error::no_result(id.name(), "it cannot be fitted to this session");
        self.fit(&best.ok_or_else(reason)?, f64::INFINITY, false)
            .ok_or_else(reason)
    }

    fn take(&mut self, best: Tried) {
        self.model.causes = best.causes;
        (self.fitted, self.left, self.looked_from) = (best.fitted, best.left, best.from);
    }

    /// A wind that is the best of those tried, or that a better one leaves room for: gusts may be
    /// what that lacks. Where none takes much of what is left, or where something seems to move
    /// inside as slowly as gusts come, a wind that hardly blows but in gusts.
    fn may_blow(&self, tried: &[Tried], looks: &[Look]) -> Option<Tried> {
        let best = tried.first();
        let steady = tried.iter().find(|t| t.cause.id == CauseId::Wind);
        let is_taken = self
            .model
            .causes
            .iter()
            .any(|cause| cause.id == CauseId::Wind);
        let is_new = !is_taken && !self.left.is_white();
        if is_new && !best.is_some_and(|best| takes_much(&best.left, &self.left)) {
            let of_looks = || {
                let winds = looks.iter().filter(|look| look.cause.id == CauseId::Wind);
                self.fit(
                    winds.max_by(|a, b| a.gain.total_cmp(&b.gain))?,
                    f64::INFINITY,
                    false,
                )
            };
            let steady = steady
                .cloned()
                .or_else(of_looks)
                .filter(|wind| wind.gain > LEAST_GAIN);
            return steady.or_else(|| self.in_gusts_alone(best));
        }
        let best = best.filter(|best| best.gain > LEAST_GAIN)?;
        let has_its_law = has_its_law(&best.left, &self.left);
        let leaves_some = best.cause.id == CauseId::Wind
            || !(has_its_law || best.left.is_next_to_nothing(&self.base_left));
        let steady = steady
            .filter(|wind| leaves_some && wind.gain > GUSTY * best.gain)
            .cloned();
        let is_alike = !is_taken && slow_hz(best).is_some() && !has_its_law;
        steady.or_else(|| is_alike.then(|| self.in_gusts_alone(Some(best))).flatten())
    }

    /// A faint wind, as it is before any fit: the one whose gusts promise most, slow ones, those
    /// where most is left, and one as slow as what the best of those tried has inside. None where
    /// they promise little beside what that gains.
    fn in_gusts_alone(&self, best: Option<&Tried>) -> Option<Tried> {
        let least_gain = GUSTY * best.map_or(0.0, |best| best.gain);
        let scales = Scales::of(self.model.base, &self.fitted.point).ok()?;
        let peaks_hz = self
            .left
            .peaks_hz(PEAKS)
            .into_iter()
            .filter(|hz| *hz < FASTEST_GUST_HZ);
        let lowest_hz = (1..=SLOW_GUSTS).map(|k| f64::from(k) / self.longest_s());
        let tones = self.tones(
            GUSTS[0],
            lowest_hz.chain(peaks_hz).chain(best.and_then(slow_hz)),
        );
        let winds = catalogue(&scales)
            .into_iter()
            .filter(|cause| cause.id == CauseId::Wind);
        let each = winds.filter_map(|wind| {
            let model = self.model.with(&wind);
            let mut point = self.fitted.point.clone();
            let mut values = wind.start(model.base.swings.len());
            values[0] = FAINT * wind.parameters[0].prior.1;
            point.causes.push(values);
            let fitted = model.unmoved(&point).ok()?;
            let looks = looks_at(&Standing::of(&model, &point).ok()?, &tones);
            let gain = looks
                .iter()
                .map(|look| look.gain)
                .fold(f64::NEG_INFINITY, f64::max);
            (gain > least_gain.max(FURTHER_GAIN)).then_some((gain, wind, model, fitted))
        });
        let (_, wind, model, fitted) = each.max_by(|a, b| a.0.total_cmp(&b.0))?;
        self.weighed_up(&wind, model, fitted)
    }

    /// Takes a wind and its gusts where they are the best; else all stays as it was.
    fn blows_better(&mut self, tried: &mut Vec<Tried>, wind: Tried) -> bool {
        let best_gain = tried.first().map_or(0.0, |best| best.gain);
        let blows = wind.gain > GUSTY * best_gain;
        let pays = tried
            .first()
            .is_some_and(|best| best.cause.id == CauseId::Wind && self.pays(best));
        let takes_enough =
            |best: &Tried| self.left.is_white() || takes_much(&best.left, &self.left);
        let is_instead = tried
            .first()
            .is_some_and(|best| slow_hz(best).is_some() && takes_enough(best));
        let kept = (
            self.model.clone(),
            self.fitted.clone(),
            self.left.clone(),
            self.looked_from.clone(),
        );
        self.take(wind.clone());
        let with_gusts = wind.gain + self.blow(best_gain - wind.gain, is_instead);
        // One that does not must account for what is left by its gusts: in the place of something
        // inside for much of what that leaves too.
        let before = if is_instead {
            tried.first().map_or(&kept.2, |best| &best.left)
        } else {
            &kept.2
        };
        let takes = self.left.is_white() || takes_much(&self.left, before);
        let accounts = blows || takes;
        if pays || (accounts && with_gusts > best_gain.max(LEAST_GAIN)) {
            tried.retain(|t| t.cause.id != CauseId::Wind);
            tried.insert(
                0,
                Tried {
                    gain: with_gusts,
                    left: self.left.clone(),
                    ..wind
                },
            );
            return true;
        }
        (self.model, self.fitted, self.left, self.looked_from) = kept;
        false
    }

    /// A wind that was taken may come in gusts: tones of it are added while something is left, or
    /// less is gained than it lacks in the place of something else, or a shape without a name
    /// stands for what they may account for, and they pay. What cannot make up for what the wind
    /// lacks beside the best of those tried is left at that. Their gain.
    pub fn blow(&mut self, lacking: f64, is_instead: bool) -> f64 {
        let wanted = if is_instead { lacking } else { 0.0 };
        let (mut gained, mut most): (f64, f64) = (0.0, f64::INFINITY);
        let has_unnamed = self
            .model
            .causes
            .iter()
            .any(|cause| cause.id == CauseId::Unknown);
        for (n, tone) in GUSTS.into_iter().enumerate() {
            let is_enough = self.left.is_white() && gained >= wanted && !has_unnamed;
            let is_hopeless = gained + most * (GUSTS.len() - n) as f64 <= lacking;
            if is_enough || is_hopeless {
                break;
            }
            let tried = self
                .best_gust(tone)
                .filter(|tried| tried.gain > FURTHER_GAIN);
            let Some(tried) = tried else { break };
            gained += tried.gain;
            most = if n == 0 {
                tried.gain
            } else {
                most.max(tried.gain)
            };
            self.take(tried);
        }
        if gained > MADE_UP * lacking {
            gained + self.blow_anew()
        } else {
            gained
        }
    }

    /// The first gusts that were fitted had bent themselves to what all do: while something is left
    /// each is looked for anew beside the others. What that gains.
    fn blow_anew(&mut self) -> f64 {
        let before = self.fitted.cost;
        let gusts = self
            .model
            .causes
            .iter()
            .filter(|cause| cause.form == Form::Gust)
            .count();
        for tone in GUSTS.into_iter().take(gusts) {
            // Those that were looked for anew come last: the first is the one that was longest ago.
            let first = self
                .model
                .causes
                .iter()
                .position(|cause| cause.form == Form::Gust);
            let Some(first) = first.filter(|_| gusts > 1 && !self.left.is_white()) else {
                break;
            };
            let Some(found) = self.anew(first, tone) else {
                break;
            };
            self.take(found);
        }
        0.5 * (before - self.fitted.cost)
    }

    /// A gust left out and looked for anew, or where it was if nothing better is found.
    fn anew(&self, gust: usize, tone: [&'static str; 3]) -> Option<Tried> {
        let (mut model, mut point) = (self.model.clone(), self.fitted.point.clone());
        let cause = model.causes.remove(gust);
        let values = point.causes.remove(gust);
        let beside = Found::begun(
            model.clone(),
            self.begin.clone(),
            model.unmoved(&point).ok()?,
        )
        .ok()?;
        if let Some(found) = beside
            .best_gust(tone)
            .filter(|found| found.fitted.cost < self.fitted.cost - LEAST_GAIN)
        {
            return Some(found);
        }
        let model = model.with(&cause);
        point.causes.push(values);
        let fitted = model.unmoved(&point).ok()?;
        beside.weighed_up(&cause, model, fitted)
    }

    /// The gust that promises most, fitted.
    fn best_gust(&self, tone: [&'static str; 3]) -> Option<Tried> {
        let looks = looks_at(
            &Standing::of(&self.model, &self.fitted.point).ok()?,
            &self.all_tones(tone),
        );
        let best = looks.into_iter().max_by(|a, b| a.gain.total_cmp(&b.gain));
        self.fit_to_its_end(&best?)
    }

    /// Gusts of all frequencies that the longest swing resolves.
    fn all_tones(&self, tone: [&'static str; 3]) -> Vec<Cause> {
        let resolved_hz = self.longest_s().recip();
        let count = (FASTEST_GUST_HZ / resolved_hz) as usize;
        self.tones(tone, (1..=count).map(|k| k as f64 * resolved_hz))
    }

    /// Gusts of given frequencies.
    fn tones(
        &self,
        tone: [&'static str; 3],
        frequencies_hz: impl Iterator<Item = f64>,
    ) -> Vec<Cause> {
        let duration_s = self.longest_s();
        frequencies_hz
            .map(|hz| gust(tone, hz, duration_s))
            .collect()
    }

    /// Duration of the longest swing, s.
    fn longest_s(&self) -> f64 {
        self.model
            .base
            .swings
            .iter()
            .map(|fitted_swing| fitted_swing.samples.duration_s)
            .fold(0.0, f64::max)
    }

    /// A cause taken first may owe its gain to one that was taken later, and one taken later to a
    /// first whose fit had ended elsewhere: without it nothing is then lost, and it goes.
    fn prune(&mut self) {
        for k in (0..self.model.causes.len()).rev() {
            if self.model.causes.len() == 1
                || self.model.causes[k].form == Form::Gust
                || self.is_sure_of(k)
            {
                continue;
            }
            let mut model = self.model.clone();
            let cause = model.causes.remove(k);
            let mut start = self.fitted.point.clone();
            start.causes.remove(k);
            let Ok(without) = model.fit(&start, &|_| false) else {
                continue;
            };
            let Some(lost) = gain(&without, &self.fitted) else {
                continue;
            };
            let Ok(left) = Left::of(&model, &without.point) else {
                continue;
            };
            if !is_missed(lost, &left, &self.left) {
                (self.model, self.fitted, self.left) = (model, without, left);
                let of_it = |round: &&mut Round| {
                    round.tried.first().is_some_and(|t| t.cause.id == cause.id)
                };
                self.rounds
                    .iter_mut()
                    .filter(|round| round.taken)
                    .find(of_it)
                    .into_iter()
                    .for_each(|round| {
                        round.taken = false;
                    });
            }
        }
    }

    /// Whether a cause's strengths are beyond doubt where all that shows is accounted for: no fit
    /// without it is then needed (Wald's test).
    fn is_sure_of(&self, k: usize) -> bool {
        let Some(covariance) = self.fitted.covariance().filter(|_| self.left.is_white()) else {
            return false;
        };
        let swings = self.model.base.swings.len();
        let before: usize = self.model.causes[..k]
            .iter()
            .map(|cause| cause.size(swings))
            .sum();
        let first = Places::of(&self.model).first_cause() + before;
        let cause = self.model.causes[k].expanded(swings);
        let strengths: Vec<usize> = (0..cause.len())
            .filter(|i| cause[*i].0.is_strength)
            .collect();
        let places: Vec<usize> = strengths.iter().map(|i| first + i).collect();
        let values = DVector::from_fn(strengths.len(), |i, _| {
            self.fitted.point.causes[k][strengths[i]]
        });
        let own = covariance
            .select_rows(&places)
            .select_columns(&places)
            .cholesky();
        own.is_some_and(|own| values.dot(&own.solve(&values)) > SURE)
    }

    /// Where structure remains, the model is extended even without a name for it: by what leaves
    /// least of all that was tried without one, beside the causes that had been taken before.
    fn learn(&mut self) {
        if !self.is_unexplained() || self.model.causes.iter().any(|c| c.id == CauseId::Unknown) {
            return;
        }
        let tried = self
            .rounds
            .iter()
            .enumerate()
            .flat_map(|(n, round)| round.tried.iter().map(move |t| (n, t)));
        let unnamed = tried.filter(|(_, t)| t.cause.id == CauseId::Unknown);
        let Some((n, best)) = unnamed.min_by(|a, b| a.1.fitted.cost.total_cmp(&b.1.fitted.cost))
        else {
            return;
        };
        if best.fitted.cost + 2.0 * LEAST_GAIN > self.fitted.cost {
            return;
        }
        let best = best.clone();
        self.rounds.truncate(n + 1);
        let round = &mut self.rounds[n];
        round.tried.retain(|t| t.cause.id != CauseId::Unknown);
        round.tried.insert(0, best.clone());
        round.taken = true;
        self.take(best);
    }

    /// Derivatives taken without a cause, or over long steps, lead near the best fit, and say too
    /// much or too little of how near: the last fit has all of them.
    fn polish(&mut self) {
        self.model.fine = true;
        if self.fitted.is_fine {
            return;
        }
        let Ok(fitted) = self.model.whole().fit(&self.fitted.point, &|_| false) else {
            return;
        };
        let Ok(left) = Left::of(&self.model, &fitted.point) else {
            return;
        };
        (self.fitted, self.left) = (fitted, left);
    }

    /// First looks at every cause that is not in the model yet, the most promising first.
    fn looks(&self) -> Result<Looked> {
        let scales = Scales::of(self.model.base, &self.fitted.point)?;
        let is_new = |cause: &Cause| !self.model.causes.iter().any(|known| known.id == cause.id);
        let standing = Standing::of(&self.model, &self.fitted.point)?;
        let mut causes = catalogue(&scales);
        let peaks_hz = self.left.peaks_hz(PEAKS);
        let mut looks: Vec<Look> = Vec::new();
        if !self.left.is_white() {
            causes.extend(mounts());
            causes.extend(ringing(&scales, &peaks_hz));
            causes.extend((0..4).map(|coordinate| learned_force(&scales, coordinate, &TERMS)));
        }
        // What happens at one moment leaves little in any one band of a spectrum.
        looks.extend(
            moments(&standing)?
                .into_iter()
                .filter(|look| is_new(&look.cause)),
        );
        if self
            .model
            .causes
            .iter()
            .any(|cause| cause.id == CauseId::InternalMotion)
        {
            causes.extend(seconds(&scales, &peaks_hz));
        }
        causes.retain(is_new);
        looks.extend(looks_at(&standing, &causes));
        looks.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        let fitted = Fitted {
            jacobians: vec![],
            ..standing.fitted
        };
        Ok(Looked { looks, fitted })
    }

    /// Fits the leading causes in full, the best first. Where they leave something, shapes without
    /// a name are tried as well.
    fn tried(&self, looks: Vec<Look>, half_way: &dyn Fn() -> Result<()>) -> Result<Vec<Tried>> {
        let (unnamed, named): (Vec<Look>, Vec<Look>) = looks
            .into_iter()
            .partition(|l| l.cause.id == CauseId::Unknown);
        // What promises more than all names may keep it, even where one of them leaves nothing: a
        // line that slips turns a phone with the hull.
        let promised = named.iter().map(|look| look.gain).fold(0.0, f64::max);
        // What else moves inside follows the law of what was found to move there: it may promise
        // most, and then sets the measure for the names.
        if unnamed
            .first()
            .is_some_and(|look| look.cause.form == Form::Second && look.gain > promised)
        {
            // Its other frequencies are forms of it.
            let second = unnamed.into_iter().take(1).collect();
            let found = self.unnamed_in_full(second, |look| self.promises(look), self.fitted.cost);
            let tried =
                self.fitted_in_full(named, least_cost(&found, self.fitted.cost), half_way)?;
            return Ok(self.with_unnamed(tried, found));
        }
        let tried = self.fitted_in_full(named, f64::INFINITY, half_way)?;
        let left = tried.first().map_or(&self.left, |best| &best.left);
        // Little may be left by the names, and a second thing inside still be seen.
        let much = !left.is_next_to_nothing(&self.base_left);
        let named_gain = tried.first().map_or(0.0, |best| best.gain);
        let may_be =
            |look: &Look| look.cause.form == Form::Second || look.gain > named_gain.min(promised);
        let worth_it = |look: &Look| self.promises(look) && (much || may_be(look));
        let limit = tried
            .first()
            .map_or(self.fitted.cost, |best| best.fitted.cost);
        let found = self.unnamed_in_full(unnamed, worth_it, limit);
        Ok(self.with_unnamed(tried, found))
    }

    /// Fits the leading two of the shapes without a name that are worth it, the best last.
    fn unnamed_in_full(
        &self,
        looks: Vec<Look>,
        worth_it: impl Fn(&Look) -> bool,
        limit: f64,
    ) -> Vec<Tried> {
        let leading: Vec<Look> = looks.into_iter().filter(worth_it).take(2).collect();
        let found = in_parallel(leading.len(), |k| self.fit(&leading[k], limit, true));
        let mut found: Vec<Tried> = found.into_iter().flatten().collect();
        found.sort_by(|a, b| a.gain.total_cmp(&b.gain));
        found
    }

    /// Causes led to their ends, and shapes without a name (the best last, which puts it before the
    /// others) among them: such a one comes first where it takes nearly all that the named ones
    /// leave.
    fn with_unnamed(&self, tried: Vec<Tried>, mut found: Vec<Tried>) -> Vec<Tried> {
        let named_gain = tried.first().map_or(0.0, |best| best.gain);
        // What else moves inside has a law, and goes on to its end as those with names do.
        let is_best_of_all = |t: &&mut Tried| t.cause.form == Form::Second && t.gain > named_gain;
        if let Some(second) = found.last_mut().filter(is_best_of_all)
            && let Some(end) = self.led_on(second, second.gain, false)
        {
            *second = end;
        }
        let mut tried =
            self.led_to_their_ends(tried, found.last().map_or(0.0, |unknown| unknown.gain));
        let named_gain = tried.first().map_or(0.0, |best| best.gain);
        let left = tried.first().map_or(&self.left, |best| &best.left).excess();
        for unknown in found {
            let beats = tried.first().is_none_or(|best| unknown.gain > best.gain);
            let takes_all = unknown.left.excess() < UNNAMED_LEAVES * left;
            // A line's slip is a law as sharp as those that have names; others may bend to what a
            // name leaves.
            let is_as_good =
                matches!(unknown.cause.form, Form::LineSlip(_)) || unknown.left.excess() <= left;
            let is_clear = is_as_good && unknown.gain > named_gain + LEAST_GAIN;
            // What moves inside beside another has the law of that one: it bends no more than a
            // name does.
            let is_law = unknown.cause.form == Form::Second;
            let place = if is_clear || (beats && (takes_all || is_law)) {
                0
            } else {
                tried.len()
            };
            tried.insert(place, unknown);
        }
        tried
    }

    /// The best of those with names is led to its end, and so is what is close behind, and what was
    /// still on its way and may yet be better: than it, or than what has no name and gained so
    /// much. That is where a fit used up its steps on the way, or where derivatives were taken
    /// apart in a close race.
    fn led_to_their_ends(&self, mut tried: Vec<Tried>, unnamed_gain: f64) -> Vec<Tried> {
        let best_gain = tried.first().map_or(0.0, |t| t.gain);
        let is_near = |t: &Tried| best_gain > LEAST_GAIN && best_gain - t.gain < CLOSE;
        let is_race = tried.iter().skip(1).any(is_near);
        let may_be_better = |k: usize, t: &Tried| {
            k == 0 || is_near(t) || (t.is_on_its_way() && t.gain > RIVAL_SHARE * best_gain)
        };
        let is_short_of_its_end = |t: &Tried| {
            let model = self.fine(t);
            t.is_on_its_way() || (is_race && is_near(t) && model.is_apart())
        };
        let to_beat = |k: usize| {
            if k == 0 {
                unnamed_gain
            } else {
                unnamed_gain.max(best_gain)
            }
        };
        // Where nothing more is to be seen, what gains too little to be taken is good enough for
        // what it leaves open.
        let may_pay = !self.left.is_white() || best_gain + SEEN_OFF > asked(self.first_gain());
        let ends = in_parallel(tried.len(), |k| {
            let t = &tried[k];
            let goes_on = may_be_better(k, t) && is_short_of_its_end(t) && may_pay;
            goes_on.then(|| self.led_on(t, to_beat(k), k > 0)).flatten()
        });
        for (t, end) in tried.iter_mut().zip(ends) {
            if let Some(end) = end {
                *t = end;
            }
        }
        tried.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        simplest_first(&mut tried, parameters);
        tried
    }

    /// Whether a look promises enough for a full fit.
    fn promises(&self, look: &Look) -> bool {
        look.gain > if self.left.is_white() { DOUBTFUL } else { 0.0 }
    }

    /// Fits the leading causes in full, the best first; those that fall far behind a cost that was
    /// reached already are given up.
    fn fitted_in_full(
        &self,
        looks: Vec<Look>,
        limit: f64,
        half_way: &dyn Fn() -> Result<()>,
    ) -> Result<Vec<Tried>> {
        let most = if self.rounds.is_empty() {
            LEADING
        } else {
            FURTHER
        };
        let leading: Vec<Look> = looks
            .into_iter()
            .filter(|look| self.promises(look))
            .take(most)
            .collect();
        // The first two set the measure, the first of them for the second.
        let (first, others) = leading.split_at(leading.len().min(2));
        let mut tried: Vec<Tried> = Vec::new();
        for look in first {
            let best = least_cost(&tried, limit);
            tried.extend(self.fit(look, best, true));
        }
        tried.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        half_way()?;
        let best = least_cost(&tried, limit);
        // Beside a cause that leaves next to nothing, only those count that promise nearly as much.
        let nearly_all = |t: &&Tried| t.left.is_next_to_nothing(&self.left);
        let enough = tried
            .first()
            .filter(nearly_all)
            .map_or(0.0, |t| RIVAL_SHARE * t.gain);
        let others: Vec<&Look> = others.iter().filter(|look| look.gain > enough).collect();
        let fitted = in_parallel(others.len(), |k| self.fit(others[k], best, true));
        tried.extend(fitted.into_iter().flatten());
        tried.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        Ok(tried)
    }

    /// What the first cause that was taken gained.
    fn first_gain(&self) -> Option<f64> {
        let first = self.rounds.first().filter(|round| round.taken);
        first
            .and_then(|round| round.tried.first())
            .map(|first| first.gain)
    }

    fn pays(&self, best: &Tried) -> bool {
        // Beside what was found to move inside another has the same law, and what a fitted law
        // leaves is nothing for it to pick up.
        if best.cause.form == Form::Second && self.left.is_white() {
            return best.gain > FURTHER_GAIN;
        }
        // Winds are irregular: what a steady one and a few tones leave is nothing for another to
        // pick up either, and nothing to bend.
        let taken = self
            .rounds
            .iter()
            .filter(|round| round.taken)
            .filter_map(|round| round.tried.first());
        let wind = taken
            .filter(|t| t.cause.id == CauseId::Wind)
            .map(|t| t.gain)
            .max_by(f64::total_cmp);
        if let Some(wind) = wind.filter(|_| self.left.is_white()) {
            let is_clean = best.cause.id != CauseId::Unknown && best.left.is_white();
            return is_clean && best.gain > FURTHER_GAIN.max(GUSTY * wind);
        }
        pays(self.first_gain(), best.gain, &best.left, &self.left)
    }
}

/// Whether so little is left of what was left before that there is no room for gusts.
fn takes_much(left: &Left, before: &Left) -> bool {
    left.excess() < TAKEN * before.excess()
}

/// Whether so much is taken so wholly that another law would have left more to see.
fn has_its_law(left: &Left, before: &Left) -> bool {
    left.excess() <= BENT * before.excess() && before.excess() > PLAIN
}

/// Frequency of what was tried, where that is something inside that moves as slowly as gusts come,
/// Hz.
fn slow_hz(tried: &Tried) -> Option<f64> {
    let of_inside = Some(tried).filter(|tried| tried.cause.id == CauseId::InternalMotion);
    let frequency_hz = parameters(of_inside?)
        .remove(&ParameterName::FrequencyHz.into())?
        .value;
    Some(frequency_hz).filter(|hz| *hz < FASTEST_GUST_HZ)
}

/// The first of each name, and of what else moves inside, with those of its other forms that
/// promise nearly as much.
fn foremost(looks: &[Look]) -> Vec<Look> {
    let mut leading: Vec<Look> = Vec::new();
    for look in looks {
        let is_form_of = |known: &Cause| {
            let has_law =
                known.id != CauseId::Unknown || [known.form, look.cause.form] == [Form::Second; 2];
            known.id == look.cause.id && has_law
        };
        match leading.iter_mut().find(|known| is_form_of(&known.cause)) {
            None => leading.push(look.clone()),
            Some(best) => best.keep(look),
        }
    }
    leading
}

impl<'a> Found<'a> {
    /// A model fitted to the stretches that are not held out, and its χ² and number of rows in
    /// those that are.
    pub fn held_out(model: &Model<'a>, fitted: &Fitted) -> Result<(f64, usize)> {
        let mut fitting = Model {
            part: Part::Fitted,
            ..model.whole()
        };
        // What happened in a stretch held out cannot be found from the others: it stays where all
        // of them put it.
        for (cause, values) in fitting.causes.iter_mut().zip(&fitted.point.causes) {
            for (parameter, value) in cause.parameters.iter_mut().zip(values) {
                if OF_MOMENT.contains(&parameter.name) {
                    parameter.prior = (*value, PINNED * parameter.prior.1);
                }
            }
        }
        // The fit to all was nearly there, and its derivatives are good enough for what is left of
        // the way.
        let kept = Derivatives::Kept(fitting.of_part(&fitted.jacobians));
        let settled = fitting.fit_with(&fitted.point, kept, CONVERGED_SHARE, &|_| false)?;
        let fitting = if settled.last_gained < UNSETTLED * settled.rows as f64 {
            settled
        } else {
            fitting.fit(&settled.point, &|_| false).unwrap_or(settled)
        };
        let mut there = fitting.point.clone();
        // Moments are fitted on the true clock; it is on the phone's that they stay.
        for (cause, values) in model.causes.iter().zip(&mut there.causes) {
            let at = cause
                .parameters
                .iter()
                .position(|parameter| parameter.name == ParameterName::AtS);
            if let (Some(swing), Some(at)) = (cause.form.swing(), at) {
                values[at] *=
                    model.clock(&fitted.point, swing)? / model.clock(&fitting.point, swing)?;
            }
        }
        let judging = Model {
            part: Part::HeldOut,
            ..model.clone()
        };
        let rows = (0..model.base.swings.len())
            .map(|s| 3 * judging.blocks(s).len())
            .sum();
        Ok((judging.chi2(&there)?, rows))
    }
}
