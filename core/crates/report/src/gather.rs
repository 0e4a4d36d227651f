//! A report's source from an analysis: curves thinned, channels chosen, stated figures listed.

use std::f64::consts::TAU;

use super::source::{
    BodyFacts, Curve, Peak, PeriodsFigureData, RecordingFigureData, ReportSource, RigFigureData,
    SpectrumFigureData, StatedFigure, Trace,
};
use super::thin::{MOST_POINTS, thinned};
use super::words::{self, plain, say};
use gyradius_base::language::Language;
use gyradius_base::message::{Argument, Message};
use gyradius_identification::{Analysis, Evidence};
use gyradius_recording::{
    ChannelQuantity, InclineAngle, LoadedData, LoadedSession, PeriodList, Quantity, Session,
};
use gyradius_signal::{ChannelGroup, period_from_list, spectrum};

/// Cycles of the strongest mode in a close-up.
const CLOSE_UP_CYCLES: f64 = 6.0;
/// A close-up is shown where it is less than this share of the record.
const CLOSE_UP_SHARE: f64 = 0.6;
const AXES: [&str; 3] = ["x", "y", "z"];

impl ReportSource {
    /// Fills in everything that an analysis and its session tell, for a report in a language; a
    /// criticism, and a date where the session has none, are for the caller to add.
    pub fn from_analysis(
        analysis: &Analysis,
        loaded: Option<&LoadedSession>,
        language: Language,
    ) -> Self {
        let evidence = analysis.evidence.iter().flatten();
        let session = loaded.map(|loaded| &loaded.session);
        Self {
            language,
            measurement: analysis.measurement.clone(),
            criticism: None,
            body: session.map(body).unwrap_or_default(),
            stated: session
                .map(|session| stated(session, language))
                .unwrap_or_default(),
            rig: session.and_then(rig),
            recorded_by: session.map(recorded_by).unwrap_or_default(),
            recordings: evidence
                .map(|evidence| recording(evidence, language))
                .collect(),
            periods: loaded.map(lists).unwrap_or_default(),
            measured_on: session
                .map(|session| session.measured_on.clone())
                .filter(|date| !date.is_empty()),
            generated_by: concat!("gyradius ", env!("CARGO_PKG_VERSION")).into(),
        }
    }
}

/// Points of the curve of eq. (14) in each of its beats.
const POINTS_PER_BEAT: f64 = 24.0;

/// Every list of periods with the curve that it follows.
fn lists(loaded: &LoadedSession) -> Vec<PeriodsFigureData> {
    let each = loaded.data.iter().filter_map(|swing| match &swing.data {
        LoadedData::Periods(list) => periods(&swing.id, list),
        _ => None,
    });
    each.collect()
}

fn periods(id: &str, list: &PeriodList) -> Option<PeriodsFigureData> {
    let found = period_from_list(list).ok()?;
    let is_left_out = |i: usize| found.flagged.iter().any(|one| one.index == i);
    let entries = list.t_s.iter().copied().zip(list.period_s.iter().copied());
    let kept: Vec<(f64, f64)> = entries
        .enumerate()
        .filter(|(i, _)| !is_left_out(*i))
        .map(|(_, entry)| entry)
        .collect();
    let (first, last) = (kept.first()?.0, kept.last()?.0);
    let trend = &found.trend;
    let plain = |t_s: f64| trend.t0_s * (1.0 + trend.b_per_s * (t_s - first));
    let whole = |t_s: f64| trend.at(t_s - first); // (14)
    let beats = trend
        .modulation
        .map_or(1.0, |one| (last - first) / one.t_m_s);
    let points = (POINTS_PER_BEAT * beats)
        .ceil()
        .clamp(2.0, MOST_POINTS as f64) as usize;
    let at = |k: usize| first + (last - first) * k as f64 / (points - 1).max(1) as f64;
    Some(PeriodsFigureData {
        id: id.to_owned(),
        curve: Curve::of((0..points).map(|k| (at(k), whole(at(k))))),
        unmodulated: Curve::of([first, last].map(|t_s| (t_s, plain(t_s)))),
        residual: Curve::of(
            kept.iter()
                .map(|(t_s, period_s)| (*t_s, period_s - whole(*t_s))),
        ),
        listed: Curve::of(kept),
    })
}

fn body(session: &Session) -> BodyFacts {
    let body = &session.body;
    BodyFacts {
        name: body.name.clone(),
        mass_kg: body.mass_kg,
        length_overall_m: body.length_overall_m,
    }
}

/// The first hanging on two lines.
fn rig(session: &Session) -> Option<RigFigureData> {
    session.swings.iter().find_map(|swing| {
        let hung = &swing.suspension;
        Some(RigFigureData {
            swing: swing.id.clone(),
            line_length_m: hung.line_length_m?,
            spacing_m: hung.spacing_m?,
            top_spacing_m: hung.top_spacing_m,
        })
    })
}

/// Phone and recording program of the session.
fn recorded_by(session: &Session) -> Vec<String> {
    let names = [&session.phone, &session.logger].into_iter();
    names.filter(|name| !name.is_empty()).cloned().collect()
}

/// Every stated figure, the same figure of several swings once.
fn stated(session: &Session, language: Language) -> Vec<StatedFigure> {
    let name = |key: &str| say(language, key, []);
    let mut list = Stated::default();
    list.add(
        name("stated_gravity"),
        session.site.gravity_m_s2,
        "m/s²",
        None,
    );
    for swing in &session.swings {
        let hung = &swing.suspension;
        let id = Some(&*swing.id);
        list.add(name("stated_line_length"), hung.line_length_m, "m", id);
        list.add(name("stated_spacing"), hung.spacing_m, "m", id);
        list.add(name("stated_top_spacing"), hung.top_spacing_m, "m", id);
        list.add(name("stated_axis_height"), hung.axis_height_m, "m", id);
        list.add(name("stated_hull_pitch"), hung.hull_pitch_deg, "°", id);
        list.add(name("stated_hull_roll"), hung.hull_roll_deg, "°", id);
        list.add(name("stated_points_moved"), hung.points_moved_m, "m", id);
        swing
            .added_masses
            .iter()
            .for_each(|mass| list.add(name("added_mass"), Some(mass.mass_kg), "kg", id));
    }
    for attachment in &session.attachments {
        list.add(
            say(language, "mass_of", [("name", plain(&attachment.name))]),
            Some(attachment.mass_kg),
            "kg",
            None,
        );
    }
    for (i, incline) in session.inclines.iter().enumerate() {
        let number = plain((i + 1).to_string());
        let id = say(language, "incline_number", [("number", number)]);
        list.add(
            name("inclining_weight"),
            Some(incline.mass_kg),
            "kg",
            Some(&id),
        );
        list.add(name("its_arm"), Some(incline.arm_m), "m", Some(&id));
        list.add(name("its_depth"), Some(incline.depth_m), "m", Some(&id));
        if let InclineAngle::Stated(angle) = incline.angle {
            list.add(name("incline_angle"), Some(angle), "°", Some(&id));
        }
    }
    list.figures
}

#[derive(Default)]
struct Stated {
    figures: Vec<StatedFigure>,
}

impl Stated {
    fn add(&mut self, what: String, value: Option<Quantity>, unit: &str, id: Option<&str>) {
        let Some(value) = value else { return };
        let known = self
            .figures
            .iter_mut()
            .find(|figure| figure.what == what && figure.value == value);
        match (known, id) {
            (Some(figure), Some(id)) => {
                if figure.applies_to.last().is_none_or(|last| last != id) {
                    figure.applies_to.push(id.into());
                }
            }
            _ => self.figures.push(StatedFigure {
                what,
                value,
                unit: unit.into(),
                applies_to: id.into_iter().map(String::from).collect(),
            }),
        }
    }
}

/// One channel of a record with what the fit leaves of it.
struct Channel<'a> {
    evidence: &'a Evidence,
    language: Language,
    /// Counted through all groups.
    index: usize,
    t_s: &'a [f64],
    measured: &'a [f64],
    residual: &'a [f64],
    label: String,
    unit: &'static str,
}

fn recording(evidence: &Evidence, language: Language) -> RecordingFigureData {
    let left = evidence.residuals();
    let firsts = evidence.groups.iter().scan(0, |next, group| {
        let first = *next;
        *next += group.channels.len();
        Some(first)
    });
    let channels: Vec<Channel> = firsts
        .filter_map(|first| Channel::strongest((evidence, language), &left, first))
        .collect();
    RecordingFigureData {
        id: evidence.id.clone(),
        traces: channels.iter().map(Channel::trace).collect(),
        spectrum: channels.first().map(Channel::spectrum),
    }
}

impl<'a> Channel<'a> {
    /// The channel of the sensor that starts at `first` in which the modes are strongest.
    fn strongest(
        (evidence, language): (&'a Evidence, Language),
        left: &'a [ChannelGroup],
        first: usize,
    ) -> Option<Self> {
        let mut start = 0;
        let group = evidence.groups.iter().position(|group| {
            start += group.channels.len();
            start > first
        })?;
        let in_group = &evidence.groups[group];
        let first_of_group = start - in_group.channels.len();
        let energy = |c: &usize| -> f64 {
            evidence
                .found
                .modes
                .iter()
                .filter_map(|mode| mode.shape.get(*c))
                .map(|a| a.norm_sqr())
                .sum()
        };
        let index = (first..start).max_by(|a, b| energy(a).total_cmp(&energy(b)))?;
        let (label, unit) = label(evidence, index, language);
        Some(Self {
            evidence,
            language,
            index,
            t_s: &in_group.t_s,
            measured: &in_group.channels[index - first_of_group],
            residual: left.get(group)?.channels.get(index - first_of_group)?,
            label,
            unit,
        })
    }

    fn trace(&self) -> Trace {
        let model: Vec<f64> = self
            .measured
            .iter()
            .zip(self.residual)
            .map(|(y, left)| y - left)
            .collect();
        let close_up = self.close_up_end().map(|end| {
            let near = &self.t_s[..end];
            [
                thinned(near, &self.measured[..end]),
                thinned(near, &model[..end]),
            ]
        });
        Trace {
            label: self.label.clone(),
            unit: self.unit.into(),
            measured: thinned(self.t_s, self.measured),
            model: thinned(self.t_s, &model),
            residual: thinned(self.t_s, self.residual),
            noise: self.evidence.found.noise.get(self.index).copied(),
            close_up,
        }
    }

    /// Samples of a few cycles of the channel's strongest mode; none where the record is hardly
    /// longer.
    fn close_up_end(&self) -> Option<usize> {
        let size = |mode: &gyradius_signal::FittedMode| {
            mode.shape.get(self.index).map_or(0.0, |a| a.norm())
        };
        let strongest = self
            .evidence
            .found
            .modes
            .iter()
            .max_by(|a, b| size(a).total_cmp(&size(b)))?;
        let (first, last) = (self.t_s.first()?, self.t_s.last()?);
        let length = CLOSE_UP_CYCLES * strongest.period_s();
        (length < CLOSE_UP_SHARE * (last - first))
            .then(|| self.t_s.partition_point(|t| t - first <= length))
    }

    fn spectrum(&self) -> SpectrumFigureData {
        let curve = |y: &[f64]| {
            let found = spectrum(&[ChannelGroup {
                t_s: self.t_s.to_vec(),
                channels: vec![y.to_vec()],
            }]);
            Curve {
                x: found.freq_hz,
                y: found.amplitude.into_iter().next().unwrap_or_default(),
            }
        };
        let found = &self.evidence.found.modes;
        let peaks = found
            .iter()
            .zip(&self.evidence.named)
            .map(|(mode, named)| Peak {
                freq_hz: mode.omega_rad_s / TAU,
                name: words::mode_text(named.name, self.language),
            });
        SpectrumFigureData {
            label: self.label.clone(),
            unit: self.unit.into(),
            amplitude: curve(self.measured),
            residual: Some(curve(self.residual)),
            peaks: peaks.collect(),
        }
    }
}

fn label(evidence: &Evidence, index: usize, language: Language) -> (String, &'static str) {
    let along = |key: &str, axis: &str| {
        let axis = ("axis", Argument::Plain(axis.into()));
        Message::new(key, [axis]).in_language(language)
    };
    let name = evidence.channels.get(index).copied().unwrap_or_default();
    let axis = AXES.iter().find(|axis| name.ends_with(**axis));
    match (name.get(..1), axis) {
        (Some("g"), Some(axis)) => (along("critique.channel_turn", axis), "rad/s"),
        (Some("a" | "l"), Some(axis)) => (along("critique.channel_force", axis), "m/s²"),
        _ if name == ChannelQuantity::Angle.name() => (say(language, "angle", []), "rad"),
        _ if name == ChannelQuantity::Rate.name() => (say(language, "rate", []), "rad/s"),
        _ => (say(language, "displacement", []), "m"),
    }
}
