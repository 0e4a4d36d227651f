//! The sentences of the criticism in English: the one place where they stand, but for what the
//! catalogues say of causes. Other languages have the same keys.
//!
//! A cause has a sentence (`cause.…`; where periods alone were judged, `periods.…`) and a short
//! name (`name.…`); `id.…` is its name as the format spells it.

use super::by_periods::CAUSES;
use super::causes::UNKNOWN;
use super::german::GERMAN;
use crate::dynamics::{effects, sensors};
use crate::inertia::words::{mode_text, spaced};
use crate::language::{Argument, Language, Text};
use crate::recording::ModeName;

/// What all keys of the criticism begin with.
const OF_CRITIQUE: &str = "critique.";

/// Sentences by key; `{name}` stands for an argument.
const ENGLISH: [(&str, &str); 64] = [
    (
        "adequate",
        "The simulation accounts for everything that the recordings show.",
    ),
    ("explained", "What the simulation left out: {causes}."),
    (
        "ambiguous",
        "What the simulation left out: {causes}; but these recordings cannot tell that from: {others}.",
    ),
    (
        "unexplained",
        "Something acts on the hull or the phone that no known cause accounts for.",
    ),
    (
        "many",
        "It takes {count} causes together to account for what the recordings show ({causes}): more likely something acts that is not known.",
    ),
    (
        "remains",
        "The simulation left out that {causes}; and something remains that no known cause accounts for.",
    ),
    ("and_also", "{one}, and {other}"),
    ("or_also", "{one}; or: {other}"),
    ("row", "{one}, {other}"),
    ("and", "{one} and {other}"),
    ("or", "{one} or {other}"),
    ("cause", "{^cause}."),
    (
        "next_lines",
        "swing {excited}{hull} at {amplitude_deg}° on lines of {line_length_m} m, {spacing_m} m apart, for {duration_s} s: {one} and {other} then differ by {sigma} standard deviations",
    ),
    ("next_bow_up", " with the bow {pitch_deg}° up"),
    ("next_bow_down", " with the bow {pitch_deg}° down"),
    (
        "next_same",
        "the same hanging, released at {amplitude_deg}°, for {duration_s} s: {one} and {other} then differ by {sigma} standard deviations",
    ),
    (
        "next_periods",
        "A swing on lines of {line_length_m} m, {spacing_m} m apart, {excited} set going, would tell {causes} from {others} ({modes} periods, at least {sigma} standard deviations).{left}",
    ),
    ("next_leaves", " It leaves {causes} open."),
    ("channel_turn", "turn rate about the phone's {axis}"),
    ("channel_force", "acceleration along the phone's {axis}"),
    ("channel_swing", "turn rate about the axis of the swing"),
    (
        "structure",
        "{swing}: the simulation leaves {rms} times the noise, and what it leaves is not noise",
    ),
    (
        "line",
        "{swing}: about {middle_hz} Hz {channel} moves by {size} times its noise more than simulated",
    ),
    ("line_gyroscope", "the gyroscope's {axis} axis"),
    ("line_accelerometer", "the accelerometer's {axis} axis"),
    ("line_swing", "the turn about the swing's axis"),
    (
        "first_half",
        "{swing}: the first half of the recording is further from the simulation than the second: {more} against {less} times the noise",
    ),
    (
        "second_half",
        "{swing}: the second half of the recording is further from the simulation than the first: {more} against {less} times the noise",
    ),
    (
        "at_ends",
        "{swing}: more is left where the {motion} turns round than at its middle: {more} against {less} times the noise",
    ),
    (
        "at_middle",
        "{swing}: more is left where the {motion} passes its middle than at its ends: {more} against {less} times the noise",
    ),
    (
        "growth",
        "{swing}: from {from_deg}° to {to_deg}° the {motion} period grows by {measured} ± {u} %, the simulation says {simulated} %",
    ),
    ("decay", "{swing}: in {motion} each swing loses {losses}"),
    (
        "loss",
        "{measured} ± {u} % at {amplitude_deg}° (simulated {simulated} %)",
    ),
    (
        "across",
        "{swing}: across the axis of the swing the phone turns by {percent} % of the swing, most at {most_hz} Hz; a motion in one angle has none of it",
    ),
    (
        "clock",
        "the swings want the phone's clock {ppm} ppm off: {sigma} times its stated uncertainty",
    ),
    (
        "pulled",
        "{name}: stated as {stated} {unit}, the swings want {change} {unit}: {sigma} times its stated uncertainty",
    ),
    ("saturated", "{swing}: {repair}"),
    (
        "longer",
        "The {what} is {percent} % longer than the rest of the session implies: {sigma} standard uncertainties{as_if}.",
    ),
    (
        "shorter",
        "The {what} is {percent} % shorter than the rest of the session implies: {sigma} standard uncertainties{as_if}.",
    ),
    (
        "larger",
        "The {what} is {percent} % larger than the rest of the session implies: {sigma} standard uncertainties{as_if}.",
    ),
    (
        "smaller",
        "The {what} is {percent} % smaller than the rest of the session implies: {sigma} standard uncertainties{as_if}.",
    ),
    ("period_of", "{motion} period of {swing}"),
    ("as_if_longer", ", as if its lines were {mm} mm longer"),
    ("as_if_shorter", ", as if its lines were {mm} mm shorter"),
    (
        "stated",
        "The {name}{swings} is stated as {stated}; the rest of the session implies {implied}: {sigma} standard uncertainties.",
    ),
    ("of_swings", " of {swings}"),
    (
        "nothing_shown",
        "{^cause}: the session shows nothing of it.",
    ),
    ("with_figures", "{^cause}: {figures}."),
    ("figure", "{name} {figure}"),
    (
        "contradictions",
        "Contradictions remain that no known cause accounts for (χ² = {chi2} with {dof} degrees of freedom).{hint}",
    ),
    (
        "without_one",
        " Without the swing {swing}{with} χ² would be {chi2} with {dof} degrees of freedom: of {count} swings left out in turn this one takes off the most, which is a hint and no more.",
    ),
    ("with_one", " and with one cause ({cause})"),
    (
        "nothing_shown_inside",
        "{cause}: the session shows nothing of it",
    ),
    ("with_figures_inside", "{cause}: {figures}"),
    (
        "periods_adequate",
        "Periods and dimensions agree within their uncertainties: nothing is missing.",
    ),
    (
        "periods_explained",
        "The contradictions go away with {causes}, and with nothing else that was tried.",
    ),
    (
        "periods_ambiguous",
        "The contradictions go away with {causes}; these periods cannot tell it from {others}.{hangs}",
    ),
    (
        "periods_contradiction",
        "The session contradicts itself, and no known cause accounts for it.",
    ),
    (
        "periods_remain",
        "Most of the contradictions go away with {causes}{instead}, but more remain than chance leaves.{hangs}",
    ),
    (
        "periods_instead",
        ", which these periods cannot tell from {others}",
    ),
    (
        "periods_hang",
        " The yaw gyradius hangs on it: {least} by one, {most} by another.",
    ),
    (
        "periods_alone",
        "The session holds periods alone: what shows within a swing (damping, drift, a loose phone) was not looked for.",
    ),
    (
        "no_fit",
        "no simulation of all swings together could be fitted to the samples: their periods were judged",
    ),
    (
        "turns_alone",
        "No swing was recorded by gyroscope and accelerometer on two lines: each was criticised in its strongest motion alone, by its turn.",
    ),
];

/// A sentence of the criticism with what it names.
pub fn said<'a>(key: &str, arguments: impl IntoIterator<Item = (&'a str, Argument)>) -> Text {
    let arguments = arguments
        .into_iter()
        .map(|(name, value)| (name.to_owned(), value))
        .collect();
    Text::of(format!("{OF_CRITIQUE}{key}"), arguments, sentence)
}

/// A word or sentence without arguments, as an argument.
pub fn word(key: &str) -> Argument {
    Argument::Word(format!("{OF_CRITIQUE}{key}"))
}

/// One sentence as an argument, or nothing.
pub fn part(text: Option<Text>) -> Argument {
    Argument::Texts(text.into_iter().collect())
}

/// A number with its decimals.
pub fn number(value: f64, decimals: u8) -> Argument {
    Argument::Number(value, decimals)
}

/// The id of a swing.
pub fn id(id: &str) -> Argument {
    Argument::Id(id.to_owned())
}

/// A figure as it is written.
pub fn written(figure: impl Into<String>) -> Argument {
    Argument::Figure(figure.into())
}

/// A mode of motion.
pub fn motion(mode: ModeName) -> Argument {
    word(&format!("mode.{}", mode_text(mode).replace(' ', "_")))
}

/// A row of arguments, two joined by `last` in the end and all before by `between`: keys of
/// sentences of `one` and `other`.
pub fn row(mut all: Vec<Argument>, between: &str, last: &str) -> Argument {
    let Some(end) = all.pop() else {
        return Argument::Texts(vec![]);
    };
    let joined = |key: &str, one: Argument, other: Argument| {
        Argument::Texts(vec![said(key, [("one", one), ("other", other)])])
    };
    match all
        .into_iter()
        .reduce(|row, next| joined(between, row, next))
    {
        None => end,
        Some(row) => joined(last, row, end),
    }
}

/// Short names of causes, in a row.
pub fn names<'a>(ids: impl IntoIterator<Item = &'a str>, last: &str) -> Argument {
    row(
        ids.into_iter()
            .map(|id| word(&format!("name.{id}")))
            .collect(),
        "row",
        last,
    )
}

/// The sentence of a key of the criticism in a language; absent where the key is another room's, or
/// unknown.
pub fn sentence(key: &str, language: Language) -> Option<String> {
    let key = key.strip_prefix(OF_CRITIQUE)?;
    match language {
        Language::English => english(key),
        Language::German => german(key),
    }
}

/// The short name of a cause.
pub fn cause_name(id: &str, language: Language) -> String {
    sentence(&format!("{OF_CRITIQUE}name.{id}"), language).unwrap_or_else(|| spaced(id))
}

fn english(key: &str) -> Option<String> {
    let Some((kind, id)) = key.split_once('.') else {
        return ENGLISH
            .iter()
            .find(|(known, _)| *known == key)
            .map(|(_, text)| (*text).to_owned());
    };
    Some(match (kind, id) {
        ("id", _) => id.to_owned(),
        ("cause", _) => described(id).to_owned(),
        ("periods", _) => CAUSES
            .iter()
            .find(|cause| cause.id == id)?
            .sentence
            .to_owned(),
        ("name", UNKNOWN) => "nothing known".to_owned(),
        ("name", "bearing_friction") => "dry bearing friction".to_owned(),
        ("name", "off_centre_cm") => "off-centre centre of mass".to_owned(),
        _ => spaced(id),
    })
}

fn german(key: &str) -> Option<String> {
    let of = |key: &str| {
        GERMAN
            .iter()
            .find(|(known, _)| *known == key)
            .map(|(_, text)| (*text).to_owned())
    };
    match key.split_once('.') {
        Some(("id", id)) => of(&format!("name.{id}")),
        _ => of(key),
    }
}

/// What a cause is.
fn described(id: &str) -> &'static str {
    if id == UNKNOWN {
        return "something that no known cause accounts for";
    }
    let known = effects::catalogue()
        .into_iter()
        .chain(sensors::catalogue())
        .find(|kind| kind.id == id);
    known.map_or("a cause without a description", |kind| kind.sentence)
}

/// Every sentence and word of the criticism by its key in a language.
pub fn sentences(language: Language) -> Vec<(String, String)> {
    let catalogue = || {
        effects::catalogue()
            .into_iter()
            .chain(sensors::catalogue())
            .map(|kind| kind.id)
    };
    let causes = || catalogue().chain([UNKNOWN]);
    let sentences = ENGLISH.iter().map(|(key, _)| (*key).to_owned());
    let keys = sentences
        .chain(causes().map(|id| format!("cause.{id}")))
        .chain(causes().map(|id| format!("name.{id}")))
        .chain(CAUSES.iter().map(|cause| format!("periods.{}", cause.id)));
    keys.filter_map(|key| {
        let key = format!("{OF_CRITIQUE}{key}");
        let text = sentence(&key, language)?;
        Some((key, text))
    })
    .collect()
}
