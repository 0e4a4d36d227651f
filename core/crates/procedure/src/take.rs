//! A recording: written as it comes, followed as it goes, judged when it ends.

use std::path::{Path, PathBuf};

use super::event::{Batch, Channel, PhoneInfo};
use super::judgement::{Heard, Judgement};
use super::release::{Follows, Release};
use super::rest::{Rest, RestReader};
use gyradius_base::error::Result;
use gyradius_base::frames::Vec3;
use gyradius_base::named;
use gyradius_planning::{PlannedSwing, Step};
use gyradius_recording::Sensor;
use gyradius_recording::recorder::{END, Event as Mark, Piece, Reader, Stream, Writer};
use gyradius_signal::online::{Live, LiveOptions};

/// Folder of the recordings inside the procedure's.
pub(super) const TAKES: &str = "takes";
/// Stillness that an incline is read from, s.
pub(super) const INCLINE_STILL_S: f64 = 10.0;

named! {
    /// Marks in the recorder's file.
    TakeMark: "mark" {
        /// The swing was disturbed (`recording::DISTURBED`).
        Disturbed = "disturbed",
        /// The hull was let go.
        Release = "release",
        /// The accelerometer gives no more samples.
        AccelerometerStopped = "sensor stopped accelerometer",
        /// The gyroscope gives no more samples.
        GyroscopeStopped = "sensor stopped gyroscope",
        /// The operator saw a line slip.
        SlipSeen = "slip seen",
    }
}

/// File of a recording, inside the procedure's folder: step and take, both from 1.
pub(super) fn file_of(step: usize, id: &str, take: usize) -> PathBuf {
    let plain: String = id
        .chars()
        .map(|c| if c.is_ascii_alphanumeric() { c } else { '-' })
        .collect();
    Path::new(TAKES).join(format!("{:02}-{plain}.{take}.gyr", step + 1))
}

/// What is known before a recording.
#[derive(Debug, Clone, Default)]
pub(super) struct Before {
    pub phone: PhoneInfo,
    pub rest: Option<Rest>,
}

/// First and newest stamp of a recording, ns.
#[derive(Debug, Clone, Copy, Default)]
struct Span(Option<(i64, i64)>);

impl Span {
    fn take(&mut self, stamps_ns: &[i64]) {
        for &stamp in stamps_ns {
            let (first, newest) = self.0.unwrap_or((stamp, stamp));
            self.0 = Some((first, newest.max(stamp)));
        }
    }

    /// The stamp so long after the first.
    fn at_ns(self, after_s: f64) -> Option<i64> {
        self.0
            .map(|(first, _)| first.saturating_add((after_s * 1e9) as i64))
    }

    fn length_s(self) -> f64 {
        self.0.map_or(0.0, |(first, newest)| {
            newest.saturating_sub(first) as f64 / 1e9
        })
    }
}

/// What a recording shows, whether it is being made or read again.
pub(super) struct Follow {
    pub live: Live,
    pub release: Release,
    pub still: RestReader,
    planned: Step,
    span: Span,
    slip_seen: bool,
    stopped: Vec<Sensor>,
    resumed: bool,
}

impl Follow {
    fn new(planned: &Step, before: &Before) -> Result<Self> {
        let (wanted, follows) = match planned {
            Step::Swing(swing) => (swing.period_u_wanted, follows(swing)),
            Step::Incline(_) => (LiveOptions::default().wanted, Follows::Turn),
        };
        let live = Live::new(LiveOptions {
            wanted,
            gyroscope_full_scale_rad_s: before.phone.full_scale(Channel::Gyroscope),
            accelerometer_full_scale_m_s2: before.phone.full_scale(Channel::Accelerometer),
        })?;
        Ok(Self {
            live,
            release: Release::new(follows, before.rest.as_ref()),
            still: RestReader::new(INCLINE_STILL_S),
            planned: planned.clone(),
            span: Span::default(),
            slip_seen: false,
            stopped: Vec::new(),
            resumed: false,
        })
    }

    /// The file read again from its start.
    pub fn replayed(file: &Path, planned: &Step, before: &Before) -> Result<Self> {
        let mut follow = Self::new(planned, before)?;
        let mut reader = Reader::open(file)?;
        while let Some(piece) = reader.next_piece()? {
            match piece {
                Piece::Header(_) => {}
                Piece::Samples(samples) => {
                    let channel = match samples.stream {
                        Stream::Gyroscope => Channel::Gyroscope,
                        Stream::Accelerometer => Channel::Accelerometer,
                        Stream::GyroscopeBias => Channel::GyroscopeBias,
                    };
                    follow.push(channel, &samples.stamps_ns, &samples.values)?;
                }
                Piece::Event(mark) => {
                    // Others may have marks of their own.
                    mark.key
                        .parse()
                        .into_iter()
                        .for_each(|mark| follow.mark(mark));
                }
                Piece::Resumed { .. } => follow.resumed = true,
            }
        }
        Ok(follow)
    }

    fn push(&mut self, channel: Channel, stamps_ns: &[i64], values: &[[f64; 3]]) -> Result<()> {
        let sensor = match channel {
            Channel::Gyroscope => Sensor::Gyroscope,
            Channel::Accelerometer => Sensor::Accelerometer,
            Channel::GyroscopeBias => return Ok(()),
        };
        self.span.take(stamps_ns);
        match self.planned {
            Step::Swing(_) => {
                self.live.push(sensor, stamps_ns, values)?;
                self.release.push(channel, stamps_ns, values);
            }
            Step::Incline(_) => self.still.push(channel, stamps_ns, values),
        }
        Ok(())
    }

    fn mark(&mut self, mark: TakeMark) {
        let sensor = match mark {
            TakeMark::SlipSeen => {
                self.slip_seen = true;
                return;
            }
            TakeMark::AccelerometerStopped => Sensor::Accelerometer,
            TakeMark::GyroscopeStopped => Sensor::Gyroscope,
            TakeMark::Disturbed | TakeMark::Release => return,
        };
        if !self.stopped.contains(&sensor) {
            self.stopped.push(sensor);
        }
    }

    pub fn recorded_s(&self) -> f64 {
        self.span.length_s()
    }

    pub fn last_ns(&self) -> i64 {
        self.span.0.map_or(0, |(_, newest)| newest)
    }

    /// Start of the free swing, ns: as the live estimator has it, or where motion began.
    pub fn free_from_ns(&self) -> Option<i64> {
        let first_s = self.live.estimate().swing.map(|swing| swing.from_s);
        first_s.map_or(self.release.moving_ns(), |from_s| self.span.at_ns(from_s))
    }

    /// When something last disturbed the swing, ns.
    fn disturbed_ns(&self) -> Option<i64> {
        self.span.at_ns(self.live.touched_s()?)
    }

    /// Since when it swings, s.
    pub fn swinging_s(&self) -> Option<f64> {
        let moving = self.release.moving_ns()?;
        Some(self.last_ns().saturating_sub(moving) as f64 / 1e9)
    }

    /// So much is still to come, s.
    pub fn left_s(&self) -> Option<f64> {
        match &self.planned {
            Step::Swing(swing) => Some((swing.duration_s - self.swinging_s()?).max(0.0)),
            Step::Incline(_) => Some((self.still.wanted_s() - self.still.still_s()).max(0.0)),
        }
    }

    pub fn judgement(&self, level: Option<Vec3>) -> Judgement {
        match &self.planned {
            Step::Swing(planned) => Judgement::of_swing(
                planned,
                &Heard {
                    estimate: &self.live.estimate(),
                    recorded_s: self.recorded_s(),
                    released_deg: self.release.released_deg(self.free_from_ns()),
                    slip_seen: self.slip_seen,
                    stopped: &self.stopped,
                    resumed: self.resumed,
                },
            ),
            Step::Incline(planned) => {
                Judgement::of_incline(planned, &self.still, level, self.recorded_s())
            }
        }
    }
}

fn follows(swing: &PlannedSwing) -> Follows {
    if swing.excited.is_empty() || swing.excited.iter().any(|one| one.turns()) {
        Follows::Turn
    } else {
        Follows::Lines
    }
}

/// A recording being made.
pub(super) struct Running {
    writer: Writer,
    pub follow: Follow,
    released: bool,
    /// The last disturbance that is marked, ns.
    disturbed_ns: Option<i64>,
}

impl Running {
    pub fn begin(file: &Path, planned: &Step, id: &str, before: &Before) -> Result<Self> {
        let mut header = before.phone.header();
        header.notes.insert("step".to_owned(), id.to_owned());
        Ok(Self {
            writer: Writer::create(file, &header)?,
            follow: Follow::new(planned, before)?,
            released: false,
            disturbed_ns: None,
        })
    }

    /// Goes on with a recording that was cut off.
    pub fn resume(file: &Path, planned: &Step, before: &Before) -> Result<Self> {
        let mut follow = Follow::replayed(file, planned, before)?;
        follow.resumed = true;
        let released = follow.release.moving_ns().is_some();
        Ok(Self {
            writer: Writer::resume(file)?,
            follow,
            released,
            disturbed_ns: None,
        })
    }

    pub fn push(&mut self, batch: &Batch) -> Result<()> {
        self.writer
            .push(batch.channel.into(), &batch.stamps_ns, &batch.values)?;
        self.follow
            .push(batch.channel, &batch.stamps_ns, &batch.values)?;
        if let (false, Some(stamp_ns)) = (self.released, self.follow.release.moving_ns()) {
            self.released = true;
            self.writer.mark(&Mark {
                stamp_ns,
                key: TakeMark::Release.to_string(),
            })?;
        }
        let disturbed_ns = self.follow.disturbed_ns();
        if let Some(stamp_ns) = disturbed_ns.filter(|_| disturbed_ns != self.disturbed_ns) {
            self.disturbed_ns = disturbed_ns;
            self.mark(stamp_ns, TakeMark::Disturbed)?;
        }
        Ok(())
    }

    pub fn slip_seen(&mut self, stamp_ns: i64) -> Result<()> {
        self.mark(stamp_ns, TakeMark::SlipSeen)
    }

    /// Never before what was recorded: whoever tells of it may not have heard a sample yet.
    pub fn sensor_stopped(&mut self, stamp_ns: i64, sensor: Sensor) -> Result<()> {
        let stamp_ns = stamp_ns.max(self.follow.last_ns());
        self.mark(
            stamp_ns,
            match sensor {
                Sensor::Accelerometer => TakeMark::AccelerometerStopped,
                _ => TakeMark::GyroscopeStopped,
            },
        )
    }

    fn mark(&mut self, stamp_ns: i64, mark: TakeMark) -> Result<()> {
        self.follow.mark(mark);
        let key = mark.to_string();
        self.writer.mark(&Mark { stamp_ns, key }).map(|_| ())
    }

    /// Whether its time is over.
    pub fn is_over(&self) -> bool {
        self.follow.left_s() == Some(0.0)
    }

    pub fn end(self) -> (Follow, Result<()>) {
        let last_ns = self.follow.last_ns();
        (self.follow, self.writer.end(last_ns).map(|_| ()))
    }
}

/// How far a recording goes, read without judging it.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Extent {
    pub recorded_s: f64,
    /// Whether its end mark is there.
    pub ended: bool,
    /// Its newest stamp, ns.
    pub newest_ns: Option<i64>,
}

/// How far a file goes; nothing where it is not there or no recorder's file.
pub(super) fn extent(file: &Path) -> Extent {
    let mut span = Span::default();
    let mut ended = false;
    let Ok(mut reader) = Reader::open(file) else {
        return Extent::default();
    };
    while let Ok(Some(piece)) = reader.next_piece() {
        match piece {
            Piece::Samples(samples) if samples.stream != Stream::GyroscopeBias => {
                span.take(&samples.stamps_ns);
            }
            Piece::Event(mark) => ended = mark.key == END,
            Piece::Header(_) | Piece::Samples(_) | Piece::Resumed { .. } => {}
        }
    }
    Extent {
        recorded_s: span.length_s(),
        ended,
        newest_ns: span.0.map(|(_, newest)| newest),
    }
}
