//! The sentences of the advice in English: the one place where they stand. Other languages have the
//! same keys.

use super::german::GERMAN;
use crate::language::Language;

/// Sentences by key; `{name}` stands for a parameter.
const ENGLISH: [(&str, &str); 12] = [
    (
        "sensor_silent",
        "The {sensor} has given no samples since {since_s} s: stop and start the recording again.",
    ),
    (
        "sensor_absent",
        "The {sensor} gives no samples: stop and start the recording again.",
    ),
    (
        "phone_moved",
        "The phone moved at {at_s} s and now sits {tilt_deg}° another way: tape it on and start again.",
    ),
    (
        "touched",
        "Something touched the hull at {at_s} s: let it swing freely, or release it again.",
    ),
    (
        "saturated",
        "{samples} samples of the {sensor} stand at its limit: release with a smaller amplitude.",
    ),
    (
        "gaps",
        "The {sensor} has {gaps} gaps, the longest of {longest_s} s: close other apps and keep the screen on.",
    ),
    (
        "amplitude_low",
        "The amplitude is {amplitude_deg}°, below 2°: stop, or release again.",
    ),
    (
        "sway",
        "Sway (period {period_s} s) is {percent} % of the main motion: steady the hull and release it again.",
    ),
    (
        "other_turn",
        "A turn about another axis (period {period_s} s) is {percent} % of the main motion: steady the hull and \
         release it again.",
    ),
    (
        "same_turn",
        "A second motion (period {period_s} s) is {percent} % of the main one: steady the hull and release it again.",
    ),
    (
        "out_of_reach",
        "The swing will die down before the period is as certain as wanted: release it again.",
    ),
    (
        "long_enough",
        "The recording is long enough: stop when you like.",
    ),
];

/// Sentences by key in a language.
pub fn sentences(language: Language) -> &'static [(&'static str, &'static str)] {
    match language {
        Language::English => &ENGLISH,
        Language::German => &GERMAN,
    }
}
