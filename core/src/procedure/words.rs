//! Sentences by key, in English: the one place where they stand. Other languages have the same
//! keys.
//!
//! What the live estimator says has its own sentences (`live::sentences`); their keys begin with
//! `live.` here.

use super::german::GERMAN;
use crate::error::Error;
use crate::language::{self, Argument, Language, Text, entry};
use crate::live::{self, Advice, Parameter};
use crate::recording::Sensor;
use crate::{critique, inertia, plan};

/// What the keys of the live estimator begin with.
const OF_LIVE: &str = "live.";

/// Sentences by key; `{name}` stands for an argument.
const ENGLISH: [(&str, &str); 85] = [
    (
        "start",
        "Measure {title}: {steps} steps, about {minutes} minutes of recording. Tape the phone to the hull where it cannot slip, and do not move it until the end. Then begin.",
    ),
    (
        "level_flat",
        "Hang the hull so that it is level: bow up {bow_up_deg}°, starboard down {starboard_down_deg}°. Accept when both are near 0 and it hangs quietly.",
    ),
    (
        "level_reference",
        "Hang the hull level by a spirit level, and say when it is: tilts count from there. Now it is {angle_deg}° from there. Accept when it hangs level and quiet.",
    ),
    (
        "level_nothing",
        "Hang the hull level by a spirit level, and say when it is: the phone alone cannot know, as nobody has told it how it sits.",
    ),
    (
        "level_no_gravity",
        "Hang the hull level. The accelerometer gives no reading of gravity yet.",
    ),
    (
        "rest",
        "Let the hull hang, touch nothing: {still_s} of {wanted_s} s of stillness.",
    ),
    (
        "rest_moving",
        "The hull moves, by {rate_deg_s} °/s and {tilt_deg}° of tilt: steady it with your hands, let go slowly. Stillness counts from then.",
    ),
    (
        "rest_found",
        "Rest is taken: gyroscope {gyroscope_hz} Hz, noise {noise_mrad_s} mrad/s, bias {bias_mrad_s} mrad/s. Accept it.",
    ),
    (
        "hang",
        "Step {id}: hang the hull with lines of {line_length_m} m, {spacing_m} m apart {orientation}, {extras}. Then measure length and spacing from knot to knot and type them in.",
    ),
    (
        "hang_compound",
        "Step {id}: hang the hull in two inverted Vs with the axis {axis_height_m} m above the points, {orientation}, {extras}. Then measure that height and type it in.",
    ),
    (
        "hang_incline",
        "Step {id}: hang {mass_kg} kg from the {end}, {arm_m} m from the suspension points and {depth_m} m below them. Measure all three and type them in.",
    ),
    ("no_extras", "level, nothing added"),
    ("extra_bow_up", "the bow {pitch_deg}° up"),
    ("extra_bow_down", "the bow {pitch_deg}° down"),
    (
        "extra_points_forward",
        "the points moved forward until it hangs so, by some {points_m} m: measure how far",
    ),
    (
        "extra_points_aft",
        "the points moved aft until it hangs so, by some {points_m} m: measure how far",
    ),
    ("extra_masses", "{count} added masses fixed on"),
    (
        "ready",
        "Hold the hull aside for {excited}: {amplitude_deg}°. Start the recording, wait 3 s, let go without a push, and step back. It runs {duration_s} s and ends by itself.",
    ),
    (
        "ready_incline",
        "Let the hull come to rest with the weight on. Start the recording and step back; it ends by itself after {wanted_s} s of stillness.",
    ),
    ("waiting", "Let go without a push, and step back."),
    ("swinging", "Do not touch anything: {left_s} s to go."),
    (
        "still",
        "Do not touch anything: {still_s} of {wanted_s} s of stillness.",
    ),
    (
        "interrupted",
        "The recording of {id} was cut off after {recorded_s} s. Go on with it if the hull has swung freely all the while; keep what was recorded; or repeat it.",
    ),
    (
        "interrupted_ended",
        "The recording of {id} had just ended, after {recorded_s} s, when the app stopped. Keep it, or repeat it.",
    ),
    (
        "interrupted_restarted",
        "The recording of {id} was cut off after {recorded_s} s, and the phone was switched off meanwhile: it cannot go \
         on. Keep what was recorded, or repeat it.",
    ),
    (
        "interrupted_empty",
        "The recording of {id} was cut off before anything was recorded. Repeat it.",
    ),
    ("judge_accept", "{id} is good: accept it."),
    (
        "judge_repeat",
        "{id} should be repeated. Repeat it, or accept it all the same.",
    ),
    (
        "measure",
        "All steps are done. The session is being written and measured.",
    ),
    (
        "failed",
        "No result: {reason}. Open a step again and repeat it, or try once more.",
    ),
    (
        "critique",
        "The result is there. What the simulation gets wrong is being looked for; this takes minutes, and can be left out.",
    ),
    (
        "suggest",
        "One more swing would tell {count} causes apart that these swings cannot: lines of {line_length_m} m, {spacing_m} m apart, {extras}; {excited} by {amplitude_deg}° for {duration_s} s. Make it, or leave it.",
    ),
    (
        "suggest_compound",
        "One more swing would tell {count} causes apart that these swings cannot: the axis {axis_height_m} m above the points, {extras}; {excited} by {amplitude_deg}° for {duration_s} s. Make it, or leave it.",
    ),
    ("done", "Done. The session is in {session}."),
    (
        "reason_no_swing",
        "no free swing of four periods was found in it",
    ),
    (
        "reason_slip",
        "the phone moved on the hull at {at_s} s, by {tilt_deg}°: tape it on anew",
    ),
    ("reason_slip_seen", "the phone was seen to slip"),
    (
        "reason_touched",
        "the swing was disturbed at {at_s} s, and the part before is too short to make up for it",
    ),
    (
        "reason_sway",
        "{kind} of {percent} % of the main motion (period {period_s} s) was set going that nobody asked for: release it more gently",
    ),
    (
        "reason_period",
        "noise leaves the period uncertain by {u_ppm} ppm, and {wanted_ppm} ppm are wanted: let it swing longer, or release it farther",
    ),
    (
        "reason_small",
        "it was released at {released_deg}° instead of {wanted_deg}°",
    ),
    (
        "reason_large",
        "it was released at {released_deg}° instead of {wanted_deg}°, where drag and finite amplitude count for more",
    ),
    (
        "reason_saturated",
        "{samples} samples of the {sensor} stand at its limit: release it less far",
    ),
    ("reason_gaps", "the {sensor} has a gap of {longest_s} s"),
    ("reason_silent", "the {sensor} fell silent"),
    ("reason_moving", "the hull was not still for {wanted_s} s"),
    (
        "reason_no_tilt",
        "the tilt cannot be told: no rest was taken with an accelerometer",
    ),
    (
        "reason_far",
        "the hull tilted by {angle_deg}°, and {expected_deg}° were expected: check weight and arm",
    ),
    (
        "note_touched",
        "the swing was disturbed at {at_s} s; what swung freely before it or after it is long enough, and is used",
    ),
    (
        "note_period",
        "noise leaves the period uncertain by {u_ppm} ppm; {wanted_ppm} ppm were allowed",
    ),
    (
        "note_amplitude",
        "released at {released_deg}°, {left_deg}° at the end",
    ),
    ("note_tilt", "the weight tilts the hull by {angle_deg}°"),
    (
        "note_gaps",
        "the {sensor} has {gaps} gaps, the longest of {longest_s} s",
    ),
    ("note_interrupted", "the recording was cut off and went on"),
    (
        "advice_small",
        "It swings by {amplitude_deg}° instead of {wanted_deg}°: stop, and release it farther.",
    ),
    (
        "advice_large",
        "It swings by {amplitude_deg}° instead of {wanted_deg}°: stop, and release it less far.",
    ),
    (
        "advice_moving",
        "The hull still moves: wait, or steady it slowly.",
    ),
    (
        "warn_silent",
        "No samples have come for {silent_s} s: keep the app on the screen.",
    ),
    (
        "warn_sensor_stopped",
        "The phone's system stopped the {sensor}.",
    ),
    (
        "warn_disk",
        "The disk is full. What was recorded so far is kept: free some space, then go on with it, keep it as it is, or repeat it.",
    ),
    (
        "warn_unwritable",
        "The recording cannot be written: {reason}",
    ),
    (
        "warn_journal_cut",
        "The journal's last {bytes} bytes were not whole and were cut off: the last decision is asked for again.",
    ),
    (
        "warn_unused",
        "{files} recordings in the folder belong to no step; they are kept.",
    ),
    (
        "warn_no_rest",
        "No rest was taken: bias, noise and rates are not known beforehand.",
    ),
    ("warn_critique", "There is no criticism: {reason}"),
    ("yaw", "yaw"),
    ("sway", "sway"),
    ("surge", "surge"),
    ("pitch", "pitch"),
    ("roll", "roll"),
    ("turn", "another turn"),
    ("bow", "bow"),
    ("stern", "stern"),
    ("incline", "incline"),
    ("extra", "extra"),
    ("up", "up"),
    ("down", "down"),
    ("athwartships", "athwartships"),
    ("fore_and_aft", "fore and aft"),
    ("gyroscope", "gyroscope"),
    ("accelerometer", "accelerometer"),
    ("gravity-free_accelerometer", "gravity-free accelerometer"),
    ("rangefinder", "rangefinder"),
    ("timer", "timer"),
    (
        "reason_lines_unknown",
        "line length and spacing are not known",
    ),
];

impl Text {
    /// The sentence of a key with what it names.
    pub(super) fn new<'a>(
        key: &str,
        arguments: impl IntoIterator<Item = (&'a str, Argument)>,
    ) -> Self {
        let arguments = arguments
            .into_iter()
            .map(|(name, value)| (name.to_owned(), value))
            .collect();
        Self::of(key.to_owned(), arguments, sentence)
    }

    /// The sentence in a language, with what it names.
    pub fn in_language(&self, language: Language) -> String {
        self.told(language, sentence)
    }
}

/// The id of a step or a swing in a language; in English it stands as it is.
pub fn id_in(id: &str, language: Language) -> String {
    language::id_in(id, language, sentence)
}

impl From<&Advice> for Text {
    fn from(advice: &Advice) -> Self {
        let argument = |(name, value): (&str, Parameter)| {
            let value = match value {
                Parameter::Number(value, decimals) => Argument::Number(value, decimals as u8),
                Parameter::Sensor(which) => sensor(which),
            };
            (name.to_owned(), value)
        };
        let arguments = advice.parameters().into_iter().map(argument).collect();
        Self::of(format!("{OF_LIVE}{}", advice.key()), arguments, sentence)
    }
}

/// Why a recording cannot be written.
pub(super) fn not_written(error: &Error) -> Text {
    match error {
        Error::DiskFull { .. } => Text::new("warn_disk", []),
        other => Text::new("warn_unwritable", [("reason", plain(other.to_string()))]),
    }
}

/// A sensor's name, a word with a key.
pub(super) fn sensor(sensor: Sensor) -> Argument {
    Argument::Word(sensor.name().replace(' ', "_"))
}

/// A number with its decimals.
pub(super) fn number(value: f64, decimals: u8) -> Argument {
    Argument::Number(value, decimals)
}

/// Words with keys, in a row.
pub(super) fn words<'a>(keys: impl Iterator<Item = &'a str>) -> Argument {
    let keys: Vec<&str> = keys.collect();
    Argument::Word(keys.join(" "))
}

/// The id of a step or a swing.
pub(super) fn id(id: impl Into<String>) -> Argument {
    Argument::Id(id.into())
}

pub(super) fn plain(text: impl Into<String>) -> Argument {
    Argument::Plain(text.into())
}

/// Sentences and words by key in a language, without those of the live estimator.
pub fn sentences(language: Language) -> &'static [(&'static str, &'static str)] {
    match language {
        Language::English => &ENGLISH,
        Language::German => &GERMAN,
    }
}

/// The sentence of a key, where there is one: the procedure's own or another room's.
fn sentence(key: &str, language: Language) -> Option<String> {
    let other_rooms = [critique::sentence, plan::sentence, inertia::sentence];
    if let Some(found) = other_rooms
        .iter()
        .find_map(|sentence| sentence(key, language))
    {
        return Some(found);
    }
    let (all, key) = match key.strip_prefix(OF_LIVE) {
        Some(key) => (live::sentences(language), key),
        None => (sentences(language), key),
    };
    entry(all, key)
}
