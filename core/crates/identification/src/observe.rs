//! From a swing's data to named modes with periods: the step from signal to physics.

use super::names::AmplitudeUnit;
use std::ops::Range;

use crate::modes::{ChannelMap, Hanging, NamedMode, PhoneMotion, name_modes, up_direction};
use gyradius_base::constants::STANDARD_GRAVITY_M_S2;
use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;
use gyradius_base::message::{Argument, Message};
use gyradius_recording::{
    ChannelQuantity, Excitation, ModeName, Recording, Repair, RepairKind, Sensor, SuspensionKind,
    Swing, Track,
};
use gyradius_signal::{ChannelGroup, Decomposition, FittedMode, FreeSpan, SpanNoteKind, residuals};

use super::breaks::{Free, free_part};
use super::channels::Channels;
use super::findings::clear_of_limit;
use super::one_motion::{OneMotion, Turn};
use super::samples::{WHITE, inside};
use super::sentences::{message, motion};
use super::words::mode_text;

/// A parasitic motion is worth a warning from this share of the strongest, dB.
const PARASITIC_DB: f64 = -30.0;

/// Axes of a gyroscope that see so much of a turn about the vertical, squared, see the turn: its
/// angle is at most a twentieth too small.
const MOSTLY_VERTICAL: f64 = 0.9;
/// What is told where the modes are not named by their shapes: with the operator's word, without.
const NO_GRAVITY: [&str; 2] = ["yaw_by_word", "no_shapes"];
const AXES_MISSING: [&str; 2] = ["yaw_by_word_axes", "no_shapes_axes"];
/// The name of a single rate's channel.
const RATE: &str = ChannelQuantity::Rate.name();

/// Everything found in one record.
#[derive(Debug, Clone)]
pub struct Evidence {
    /// The swing's id or the recording's name.
    pub id: String,
    /// The channels of the free swing.
    pub groups: Vec<ChannelGroup>,
    /// Names of the channels, counted through all groups: `gx`, `rate`, `y`.
    pub channels: Vec<&'static str>,
    /// Which channels are those of a whole sensor.
    pub map: ChannelMap,
    /// Free part of the record.
    pub span: FreeSpan,
    /// What was found in it.
    pub found: Decomposition,
    /// Names and sizes of its modes, in the same order.
    pub named: Vec<NamedMode>,
    /// The vertical in phone axes, where an accelerometer saw it.
    pub up: Option<Vec3>,
    /// The swing as one motion about a fixed axis, where one was fitted.
    pub motion: Option<OneMotion>,
    /// The damped oscillations of the record alone, where a motion took the place of some of them.
    pub spectrum: Option<Decomposition>,
    /// What its only channel measured, where it has one alone.
    pub single: Option<ChannelQuantity>,
    /// Unit of the modes' amplitude: `rad` or `m`.
    pub amplitude_unit: AmplitudeUnit,
    /// Repairs, those of the reader and what was trimmed.
    pub repairs: Vec<Repair>,
    /// Sensors whose readings came to the end of their range: `repairs` names one sensor of several
    /// that share a fault.
    pub saturated: Vec<Sensor>,
    /// Share of the samples that were lost at a sensor's limit.
    pub lost_at_limit: f64,
    /// Whether a sensor is at its limit time and again to the end.
    pub is_at_limit: bool,
    /// Where the record was cut because up to there a sensor was at its limit, s.
    pub cut_at_limit_s: Option<f64>,
    /// The gap where it was cut because no motion goes across, s.
    pub cut_at_gap_s: Option<f64>,
    /// What a reader must know of it.
    pub warnings: Vec<Message>,
}

impl Evidence {
    /// The turn as the sensor tells it that sees it, and the part of the record by its clock, s, that
    /// is used; `None` where none tells the angle or its rate.
    pub fn turn(&self) -> Option<(Turn<'_>, (f64, f64))> {
        let is_angle = self.single == Some(ChannelQuantity::Angle);
        // Some axes of a gyroscope need not see the turn.
        let is_told =
            is_angle || self.single == Some(ChannelQuantity::Rate) || self.map.gyroscope.is_some();
        let turn = Turn {
            group: self.groups.first().filter(|_| is_told)?,
            found: self.spectrum.as_ref().unwrap_or(&self.found),
            is_angle,
        };
        let (start_s, duration_s) = inside(self);
        Some((turn, (start_s, start_s + duration_s)))
    }

    /// With the strongest turn as one motion, where that describes it: lines of the spectrum that it
    /// explains are none of their own.
    fn with_motion(mut self, is_pendulum: bool) -> Self {
        let Some((turn, span_s)) = self.turn() else {
            return self;
        };
        let Some(motion) = OneMotion::of(&turn, span_s, is_pendulum) else {
            return self;
        };
        if !motion.is_described {
            self.motion = Some(motion);
            return self;
        }
        let main = motion.mode();
        let mut modes = vec![motion.as_mode(&turn)];
        let mut named = vec![self.named[main].clone()];
        for (place, mode) in self.found.modes.iter().enumerate() {
            let name = self.named[place].name;
            if place == main {
                continue;
            }
            if !motion.explains(&turn, mode) {
                modes.push(mode.clone());
                named.push(self.named[place].clone());
            } else if named[0].name == ModeName::Other {
                // The name that shapes or the operator's word gave to a part of the motion is its own.
                named[0].name = name;
            }
        }
        named[0].angle_rad = Some(motion.amplitude_rad);
        self.spectrum = Some(self.found.clone());
        let of_spectrum = std::mem::take(&mut self.found.warnings);
        self.warnings.retain(|said| !of_spectrum.contains(said));
        self.found.rms_over_noise = motion.rms_over_noise;
        (self.found.modes, self.named) = (modes, named);
        self.found.tones.clear();
        self.motion = Some(motion);
        self
    }

    /// Whether shapes tell what its modes are: both whole sensors, gravity among what they read.
    pub fn has_shapes(&self) -> bool {
        let map = self.map;
        let has_both = map.gyroscope.is_some() && map.accelerometer.is_some();
        has_both && !map.gravity_free && self.up.is_some()
    }

    /// Yaw as one motion, where the strongest turn is yaw and one motion explains it as a simulation
    /// has to.
    pub fn with_yaw_motion(&self) -> Option<Self> {
        let is_yaw =
            |mode: usize| self.named[mode].name == ModeName::Yaw || self.turns_about_vertical(mode);
        if !is_yaw(largest(&self.named, |_| true)?) {
            return None;
        }
        let mut found = self.clone().with_motion(false);
        let is_explained =
            |motion: &&OneMotion| is_yaw(motion.mode()) && motion.rms_over_noise.powi(2) <= WHITE;
        found.one_motion().filter(is_explained)?;
        // There is one yaw; it is the first.
        let others = found.named.iter_mut();
        let others = others.filter(|one| one.name == ModeName::Yaw);
        others.for_each(|other| other.name = ModeName::Other);
        found.named.first_mut()?.name = ModeName::Yaw;
        Some(found)
    }

    /// The line that joins the suspension points, in phone axes, either way: pitch and roll of a body on
    /// two lines turn about it, and a sway goes along it. Of the largest of these motions; none where
    /// there is none.
    pub fn along_suspension(&self) -> Option<Vec3> {
        use ModeName::*;
        let tells = |name| {
            matches!(
                name,
                Sway | PitchInPhase | PitchOutOfPhase | RollInPhase | RollOutOfPhase
            )
        };
        let largest = largest(&self.named, tells)?;
        let (up, motion) = self.phone_motion(largest)?;
        let along = match self.named[largest].name {
            Sway => motion.acceleration_m_s2?,
            _ => motion.rotation_rad?,
        };
        PhoneMotion::principal_direction(&along, &up)
    }

    /// Whether a mode turns more about the vertical than across it.
    fn turns_about_vertical(&self, mode: usize) -> bool {
        let motion = self.phone_motion(mode);
        let split = motion.and_then(|(up, motion)| motion.rotation_split(&up));
        split.is_some_and(|(about, across)| about > across)
    }

    /// The vertical in phone axes, and the phone's motion in a mode; none where the vertical is unknown.
    pub fn phone_motion(&self, mode: usize) -> Option<(Vec3, PhoneMotion)> {
        let (up, mode) = (self.up?, self.found.modes.get(mode)?);
        let motion = PhoneMotion::of(mode, self.map, STANDARD_GRAVITY_M_S2, Some(up));
        Some((up, motion))
    }

    /// The channels that tell how fast it turns: the axes of a gyroscope that were recorded, or a
    /// single rate. They are the first ones; empty where there are none.
    pub fn rates(&self) -> Range<usize> {
        let is_rate = |name: &&&str| name.starts_with('g') || **name == RATE;
        0..self.channels.iter().take_while(is_rate).count()
    }

    /// How far a mode turns by the channels that tell it, rad: the least that it can be where axes
    /// are missing.
    pub fn turn_rad(&self, mode: &FittedMode) -> Option<f64> {
        let norm = |channels: Range<usize>| {
            let seen = channels.filter_map(|c| mode.shape.get(c));
            seen.map(|c| c.norm_sqr()).sum::<f64>().sqrt()
        };
        let rates = self.rates();
        match self.single {
            Some(ChannelQuantity::Angle) => Some(norm(0..1)),
            _ if rates.is_empty() => None,
            _ => Some(norm(rates) / mode.undamped_omega_rad_s()),
        }
    }

    /// The swing as one motion, where that describes it: then it is the first mode.
    pub fn one_motion(&self) -> Option<&OneMotion> {
        self.motion.as_ref().filter(|motion| motion.is_described)
    }

    /// What is left of the channels: by the motion where there is one, else by the damped
    /// oscillations.
    pub fn residuals(&self) -> Vec<ChannelGroup> {
        let mut left = residuals(&self.groups, self.spectrum.as_ref().unwrap_or(&self.found));
        let of_motion = |motion: &OneMotion| motion.residuals(self.groups.first()?);
        if let (Some(turn), Some(first)) = (self.one_motion().and_then(of_motion), left.first_mut())
        {
            *first = turn;
        }
        left
    }

    /// Share of a turn about the vertical that the recorded axes of a gyroscope see, squared; where
    /// the vertical is unknown they are taken to see it all.
    fn vertical_seen(&self) -> f64 {
        let Some(up) = self.up else { return 1.0 };
        let axis = |name: &&str| ["gx", "gy", "gz"].iter().position(|axis| axis == name);
        let seen = self.channels[self.rates()].iter().filter_map(axis);
        seen.map(|axis| up[axis].powi(2)).sum()
    }
}

/// The part of each group between two times.
pub(crate) fn clipped(groups: &[ChannelGroup], start_s: f64, end_s: f64) -> Vec<ChannelGroup> {
    groups
        .iter()
        .map(|group| {
            let first = group.t_s.partition_point(|t| *t < start_s);
            let end = group.t_s.partition_point(|t| *t <= end_s);
            ChannelGroup {
                t_s: group.t_s[first..end].to_vec(),
                channels: group
                    .channels
                    .iter()
                    .map(|c| c[first..end].to_vec())
                    .collect(),
            }
        })
        .collect()
}

/// What the free part of a record holds; no mode has its name yet.
fn found_in(
    id: &str,
    channels: &Channels,
    amplitude_unit: AmplitudeUnit,
    repairs: &[Repair],
    (disturbed_s, at_limit_s): (&[f64], &[f64]),
) -> Result<Evidence> {
    let all = channels.groups.as_slice();
    let (clear_s, lost_at_limit) = clear_of_limit(all, at_limit_s);
    let rest;
    let cut_at_limit_s = clear_s.filter(|t| t.is_finite());
    let all = match cut_at_limit_s {
        None => all,
        Some(from_s) => {
            rest = clipped(all, from_s, f64::INFINITY);
            rest.as_slice()
        }
    };
    let Free {
        span,
        groups,
        found,
        cut_at_s,
    } = free_part(all, disturbed_s, repairs)?;
    let mut warnings = found.warnings.clone();
    let saturated = saturated(repairs);
    let mut repairs = merged(repairs);
    repairs.extend(trimmed(&span, &mut warnings));
    let (id, named, up) = (id.into(), vec![], None);
    Ok(Evidence {
        single: None,
        motion: None,
        spectrum: None,
        id,
        groups,
        channels: channels.names.clone(),
        map: channels.map,
        span,
        found,
        named,
        up,
        amplitude_unit,
        repairs,
        saturated,
        lost_at_limit,
        is_at_limit: clear_s.is_none(),
        cut_at_limit_s,
        cut_at_gap_s: cut_at_s,
        warnings,
    })
}

fn saturated(repairs: &[Repair]) -> Vec<Sensor> {
    let at_limit = repairs.iter().filter(|r| r.kind == RepairKind::Saturation);
    at_limit.map(|repair| repair.sensor).collect()
}

/// Analyses a phone's recording.
pub fn observe_recording(
    id: &str,
    recording: &Recording,
    gravity_m_s2: f64,
    hanging: &Hanging,
    swing: Option<&Swing>,
) -> Result<Evidence> {
    let evidence = spectrum_of(id, recording, gravity_m_s2, hanging, swing)?;
    // On two and three lines a body need not turn about one axis.
    Ok(match swing.map(|swing| swing.suspension.kind) {
        Some(SuspensionKind::Compound) => evidence.with_motion(true),
        Some(SuspensionKind::Free) | None => evidence.with_motion(false),
        Some(SuspensionKind::Bifilar | SuspensionKind::Trifilar) => evidence,
    })
}

/// The damped oscillations of a phone's recording.
fn spectrum_of(
    id: &str,
    recording: &Recording,
    gravity_m_s2: f64,
    hanging: &Hanging,
    swing: Option<&Swing>,
) -> Result<Evidence> {
    let channels = Channels::of(recording);
    let map = channels.map;
    let mut evidence = found_in(
        id,
        &channels,
        AmplitudeUnit::Radian,
        &recording.repairs,
        (&recording.disturbed_s, &recording.at_limit_s),
    )?;
    evidence.single = recording.lone_quantity();
    let up = up_direction(&evidence.found, map).map(|(up, _)| up);
    // Of a sensor that lacks axes no motion has a shape.
    let is_rate_whole = evidence.rates().is_empty() || map.gyroscope.is_some();
    let has_whole = map.gyroscope.is_some() || map.accelerometer.is_some();
    if !(is_rate_whole && has_whole) {
        evidence.up = up;
        name_without_shapes(&mut evidence, swing);
        return Ok(evidence);
    }
    let found = &evidence.found;
    let motions: Vec<PhoneMotion> = found
        .modes
        .iter()
        .map(|m| PhoneMotion::of(m, map, gravity_m_s2, up))
        .collect();
    let mut named = name_modes(&motions, up, gravity_m_s2, hanging);
    if up.is_none() {
        evidence
            .warnings
            .extend(name_by_hint(&mut named, swing, 1.0, NO_GRAVITY));
    }
    Ok(Evidence {
        named,
        up,
        ..evidence
    })
}

/// The same fault of both sensors, which share their rows in most files, is one line.
fn merged(repairs: &[Repair]) -> Vec<Repair> {
    let mut list: Vec<Repair> = Vec::new();
    for repair in repairs {
        let (name, what) = repair.text.split_once(": ").unwrap_or(("", &repair.text));
        let same = |r: &Repair| {
            (r.kind, r.count, r.first_s, r.last_s)
                == (repair.kind, repair.count, repair.first_s, repair.last_s)
        };
        match list.iter_mut().find(|r| same(r) && r.text.ends_with(what)) {
            Some(known) => known.text = known.text.replacen(": ", &format!(" and {name}: "), 1),
            None => list.push(repair.clone()),
        }
    }
    list
}

/// Names the modes of channels that show no shapes, and gives them their angles.
fn name_without_shapes(evidence: &mut Evidence, swing: Option<&Swing>) {
    let modes = evidence.found.modes.iter();
    let angles: Vec<Option<f64>> = modes.map(|mode| evidence.turn_rad(mode)).collect();
    let unnamed = |angle_rad| NamedMode {
        name: ModeName::Other,
        angle_rad,
    };
    let mut named: Vec<NamedMode> = angles.into_iter().map(unnamed).collect();
    let vertical = evidence.vertical_seen();
    // An accelerometer's axis may show twice the frequency of the motion.
    let turns = evidence.single.is_some() || !evidence.rates().is_empty();
    let why = match evidence.single {
        Some(_) => NO_GRAVITY,
        None => AXES_MISSING,
    };
    let told = name_by_hint(&mut named, swing.filter(|_| turns), vertical, why);
    evidence.warnings.extend(told);
    evidence.named = named;
}

/// Without gravity in the record a shape has no name. On a fixed axis there is one motion, else the
/// strongest turn takes the operator's word.
fn name_by_hint(
    named: &mut [NamedMode],
    swing: Option<&Swing>,
    vertical_seen: f64,
    [yaw_by_word, no_shapes]: [&str; 2],
) -> Option<Message> {
    let Some(strongest) = largest(named, |_| true) else {
        return Some(message(no_shapes, []));
    };
    let Some(swing) = swing else {
        return Some(message(no_shapes, []));
    };
    if swing.suspension.kind == SuspensionKind::Compound {
        named[strongest].name = ModeName::Compound;
        return None;
    }
    if swing.excited.first() == Some(&Excitation::Yaw) && vertical_seen > MOSTLY_VERTICAL {
        named[strongest].name = ModeName::Yaw;
        return Some(message(yaw_by_word, []));
    }
    Some(message(no_shapes, []))
}

fn trimmed(span: &FreeSpan, warnings: &mut Vec<Message>) -> Vec<Repair> {
    span.notes
        .iter()
        .filter_map(|note| {
            warnings.push(note.message.clone());
            (note.kind == SpanNoteKind::SecondSwing).then(|| Repair {
                kind: RepairKind::SecondSwing,
                sensor: Sensor::Gyroscope,
                count: 1,
                first_s: note.from_s,
                last_s: note.to_s,
                text: note.message.english.clone(),
            })
        })
        .collect()
}

/// Whether a mode is what this excitation means.
pub fn is_meant(excitation: Excitation, mode: ModeName) -> bool {
    use ModeName::*;
    match excitation {
        Excitation::Yaw => mode == Yaw,
        // Sideways on an athwartships suspension is the line pendulum; on a fore-and-aft one the
        // roll double pendulum.
        Excitation::Sway => matches!(mode, Sway | RollInPhase | RollOutOfPhase),
        Excitation::Surge => matches!(mode, Sway | PitchInPhase | PitchOutOfPhase),
        Excitation::Pitch => matches!(mode, PitchInPhase | PitchOutOfPhase | Compound),
        Excitation::Roll => matches!(mode, RollInPhase | RollOutOfPhase | Compound),
    }
}

/// The excitation is a hint only; where the data contradict it, that is said aloud.
pub fn hints_contradicted(named: &[NamedMode], swing: Option<&Swing>) -> Vec<Message> {
    let Some(swing) = swing else { return vec![] };
    let is_seen = |e: &Excitation| named.iter().any(|n| is_meant(*e, n.name));
    let not_seen = |e: &Excitation| {
        message(
            "not_seen",
            [("motion", motion(&format!("{e:?}").to_lowercase()))],
        )
    };
    let mut all: Vec<Message> = swing
        .excited
        .iter()
        .filter(|e| !is_seen(e))
        .map(not_seen)
        .collect();
    let strongest = named.iter().max_by(|a, b| size(a).total_cmp(&size(b)));
    if let Some(strongest) =
        strongest.filter(|n| n.name != ModeName::Other && !swing.excited.is_empty())
        && !swing.excited.iter().any(|e| is_meant(*e, strongest.name))
    {
        all.push(message(
            "not_meant",
            [("motion", motion(mode_text(strongest.name)))],
        ));
    }
    all
}

/// The largest of the modes with such names.
fn largest(named: &[NamedMode], is_wanted: impl Fn(ModeName) -> bool) -> Option<usize> {
    let wanted = (0..named.len()).filter(|mode| is_wanted(named[*mode].name));
    wanted.max_by(|a, b| size(&named[*a]).total_cmp(&size(&named[*b])))
}

/// A mode's angle, 0 where unknown.
pub fn size(named: &NamedMode) -> f64 {
    named.angle_rad.unwrap_or(0.0)
}

/// Relative sizes, dB below the largest, and which of them nobody meant; with a warning for those
/// that matter.
pub fn parasites(
    named: &[NamedMode],
    swing: Option<&Swing>,
    warnings: &mut Vec<Message>,
) -> Vec<(f64, bool)> {
    let largest = named.iter().map(size).fold(0.0, f64::max);
    named
        .iter()
        .map(|mode| {
            let db = if largest > 0.0 {
                20.0 * (size(mode) / largest).max(1e-12).log10()
            } else {
                0.0
            };
            let meant = swing.is_none_or(|s| {
                s.excited.is_empty() || s.excited.iter().any(|e| is_meant(*e, mode.name))
            });
            if !meant && db > PARASITIC_DB {
                let percent = Argument::Number(100.0 * 10f64.powf(db / 20.0), 1);
                let arguments = [
                    ("motion", motion(mode_text(mode.name))),
                    ("percent", percent),
                ];
                warnings.push(message("parasitic", arguments));
            }
            (db, !meant)
        })
        .collect()
}

/// Analyses a rangefinder's track. One point's displacement has no shape: the mode whose period is
/// that of the lines is the sway, the other the yaw (or what the operator meant).
pub fn observe_track(
    id: &str,
    track: &Track,
    hanging: &Hanging,
    swing: &Swing,
) -> Result<Evidence> {
    let mut evidence = found_in(
        id,
        &Channels::of_track(track),
        AmplitudeUnit::Metre,
        &track.repairs,
        (&[], &[]),
    )?;
    evidence.warnings.push(message("track_alone", []));
    evidence.named = name_track_modes(&evidence.found, hanging, swing);
    Ok(evidence)
}

fn name_track_modes(found: &Decomposition, hanging: &Hanging, swing: &Swing) -> Vec<NamedMode> {
    let names = names_by_period(
        &found.modes.iter().map(|m| m.period_s()).collect::<Vec<_>>(),
        hanging,
        swing,
    );
    found
        .modes
        .iter()
        .zip(names)
        .map(|(mode, name)| NamedMode {
            name,
            angle_rad: mode.shape.first().map(|c| c.norm()),
        })
        .collect()
}

/// How near a period is to that of the lines to be the sway, as a logarithm.
pub const NEAR_SWAY: f64 = 0.05;

/// Names for periods alone. The stated length fixes the sway period to a few percent (the paper's
/// was 4 % off).
pub fn names_by_period(periods_s: &[f64], hanging: &Hanging, swing: &Swing) -> Vec<ModeName> {
    let mut names = vec![ModeName::Other; periods_s.len()];
    let meant = |e: Excitation| swing.excited.contains(&e);
    let distance = |t: f64| {
        hanging
            .sway_period_s
            .map_or(f64::INFINITY, |sway| (t / sway).ln().abs())
    };
    let nearest = (0..periods_s.len())
        .min_by(|a, b| distance(periods_s[*a]).total_cmp(&distance(periods_s[*b])));
    let sway = nearest.filter(|i| {
        distance(periods_s[*i]) < NEAR_SWAY && (meant(Excitation::Sway) || !meant(Excitation::Yaw))
    });
    sway.into_iter().for_each(|i| names[i] = ModeName::Sway);
    let rest = (0..periods_s.len()).find(|i| Some(*i) != sway);
    if let Some(i) = rest.filter(|_| meant(Excitation::Yaw) || swing.excited.is_empty()) {
        names[i] = ModeName::Yaw;
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The same readings of both sensors at their limits are told as one, and known as two.
    #[test]
    fn a_fault_of_both_sensors_is_one_line_and_both_are_known() {
        let repairs = [Sensor::Gyroscope, Sensor::Accelerometer].map(|sensor| Repair {
            kind: RepairKind::Saturation,
            sensor,
            count: 12,
            first_s: 3.0,
            last_s: 4.0,
            text: format!(
                "{}: 12 samples are at the sensor's limit; left out",
                sensor.name()
            ),
        });
        let told = merged(&repairs);
        assert_eq!(told.len(), 1);
        assert!(told[0].text.contains(" and "), "{}", told[0].text);
        assert_eq!(
            saturated(&repairs),
            [Sensor::Gyroscope, Sensor::Accelerometer]
        );
    }
}
