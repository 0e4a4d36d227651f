//! The live estimator: samples in, an estimate at any moment.

use super::advice::Advice;
use super::cells::Cells;
use super::disturbance::{Change, Limits, Periods};
use super::estimate::{Estimate, advise};
use super::sensor::Watch;
use super::state::{SwingState, TimeLeft};
use super::swing;
use crate::ChannelGroup;
use gyradius_base::error::{Error, Result};
use gyradius_recording::Sensor;

/// The swing is looked at again after this time, s …
const RENEWED_AFTER_S: f64 = 1.0;
/// … and this part of it: a long one changes slowly.
const RENEWED_AFTER_PART: f64 = 0.05;

/// What is known of the phone and wanted of the swing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LiveOptions {
    /// Relative standard uncertainty of the period at which the recording is long enough.
    pub wanted: f64,
    /// The gyroscope's full scale, rad/s, where the phone tells.
    pub gyroscope_full_scale_rad_s: Option<f64>,
    /// The accelerometer's full scale, m/s², where the phone tells.
    pub accelerometer_full_scale_m_s2: Option<f64>,
}

impl Default for LiveOptions {
    /// A period to 1 in 10 000: beside it, lengths and spacings decide the uncertainty of the
    /// inertia.
    fn default() -> Self {
        Self {
            wanted: 1e-4,
            gyroscope_full_scale_rad_s: None,
            accelerometer_full_scale_m_s2: None,
        }
    }
}

/// Takes samples as they come and keeps a bounded part of what they say.
#[derive(Debug, Clone)]
pub struct Live {
    options: LiveOptions,
    origin_ns: Option<i64>,
    gyroscope: Follower,
    accelerometer: Follower,
    limits: Limits,
    next_look_s: f64,
    /// The present free swing.
    swing: Option<SwingState>,
    /// The best of those that were disturbed.
    before: Option<SwingState>,
}

/// One sensor: watched, and gathered into cells.
#[derive(Debug, Clone)]
struct Follower {
    watch: Watch,
    cells: Cells,
}

impl Follower {
    fn new(sensor: Sensor, full_scale: Option<f64>) -> Self {
        Self {
            watch: Watch::new(sensor, full_scale),
            cells: Cells::new(),
        }
    }
}

impl Live {
    /// An estimator that has seen nothing. Fails with [`Error::Argument`] where the wanted
    /// uncertainty or a full scale is not above 0.
    pub fn new(options: LiveOptions) -> Result<Self> {
        let LiveOptions {
            wanted,
            gyroscope_full_scale_rad_s,
            accelerometer_full_scale_m_s2,
        } = options;
        for value in [
            Some(wanted),
            gyroscope_full_scale_rad_s,
            accelerometer_full_scale_m_s2,
        ]
        .into_iter()
        .flatten()
        {
            if !(value > 0.0 && value.is_finite()) {
                return Err(Error::argument("options", "numbers above 0", value));
            }
        }
        Ok(Self {
            options,
            origin_ns: None,
            gyroscope: Follower::new(Sensor::Gyroscope, gyroscope_full_scale_rad_s),
            accelerometer: Follower::new(Sensor::Accelerometer, accelerometer_full_scale_m_s2),
            limits: Limits::default(),
            next_look_s: 0.0,
            swing: None,
            before: None,
        })
    }

    /// Takes samples of the gyroscope (rad/s) or the accelerometer (m/s² of specific force): stamps
    /// in ns of the phone's clock, and (x, y, z) each.
    ///
    /// Fails with [`Error::Argument`] for another sensor, or where there are not as many values as
    /// stamps.
    pub fn push(&mut self, sensor: Sensor, stamps_ns: &[i64], values: &[[f64; 3]]) -> Result<()> {
        if stamps_ns.len() != values.len() {
            let found = format!("{} stamps and {} values", stamps_ns.len(), values.len());
            return Err(Error::argument("values", "as many values as stamps", found));
        }
        let follower = match sensor {
            Sensor::Gyroscope => &mut self.gyroscope,
            Sensor::Accelerometer => &mut self.accelerometer,
            Sensor::LinearAccelerometer | Sensor::Displacement | Sensor::Timer => {
                return Err(Error::argument(
                    "sensor",
                    "gyroscope or accelerometer",
                    sensor.name(),
                ));
            }
        };
        for (&stamp_ns, &value) in stamps_ns.iter().zip(values) {
            let origin_ns = *self.origin_ns.get_or_insert(stamp_ns);
            let t_s = (i128::from(stamp_ns) - i128::from(origin_ns)) as f64 / 1e9;
            if follower.watch.admit(t_s, value) {
                follower.cells.push(t_s, value);
            }
        }
        self.look_for_disturbances();
        self.look_at_swing();
        Ok(())
    }

    /// What is known at this moment.
    pub fn estimate(&self) -> Estimate {
        let mut estimate = Estimate {
            now_s: self.now_s(),
            sensors: vec![
                self.gyroscope.watch.state(),
                self.accelerometer.watch.state(),
            ],
            gaps: self
                .gyroscope
                .watch
                .gaps()
                .with(self.accelerometer.watch.gaps()),
            swing: self.best_swing().cloned(),
            advice: Vec::new(),
        };
        estimate.advice = advise(&estimate, self.disturbances());
        estimate
    }

    /// When something last disturbed the swing, s, if that was not the phone's own moving: what the
    /// advice tells, without an estimate.
    pub fn touched_s(&self) -> Option<f64> {
        self.limits
            .touched_s(self.best_swing().map_or(0.0, |swing| swing.period_s))
    }

    fn now_s(&self) -> f64 {
        let latest = [&self.gyroscope, &self.accelerometer]
            .into_iter()
            .filter_map(|one| one.watch.last_s());
        latest.fold(0.0, f64::max)
    }

    fn look_for_disturbances(&mut self) {
        let now_s = self.now_s();
        if !self.limits.is_due(now_s) {
            return;
        }
        let periods = self.best_swing().map(|swing| Periods {
            main_s: swing.period_s,
            slowest_s: swing.slowest_s(),
        });
        let from_s = self
            .limits
            .window_from_s(now_s, periods.map(|periods| periods.main_s));
        let accelerometer = self.accelerometer.cells.group(from_s);
        let window: Vec<ChannelGroup> = self
            .gyroscope
            .cells
            .group(from_s)
            .into_iter()
            .chain(accelerometer.clone())
            .collect();
        match self
            .limits
            .look(&window, accelerometer.as_ref(), now_s, periods)
        {
            Change::None => {}
            Change::Later => self.swing = None,
            Change::Disturbed => {
                self.before = self.best_swing().map(SwingState::ended);
                self.swing = None;
            }
        }
    }

    fn look_at_swing(&mut self) {
        let now_s = self.now_s();
        if now_s < self.next_look_s {
            return;
        }
        let from_s = self.limits.from_s;
        let usual_s = RENEWED_AFTER_PART * (now_s - from_s);
        self.next_look_s = now_s + usual_s.max(RENEWED_AFTER_S);
        let (gyroscope, accelerometer) = (
            self.gyroscope.cells.group(from_s),
            self.accelerometer.cells.group(from_s),
        );
        let Some(swing) = swing::read(gyroscope, accelerometer, self.options.wanted) else {
            return;
        };
        self.gyroscope.cells.allow_for(swing.period_s);
        self.accelerometer.cells.allow_for(swing.period_s);
        // The moment when it is enough is not missed by a long step.
        if let TimeLeft::Seconds(left_s) = swing.time_left {
            self.next_look_s = now_s + usual_s.min(left_s).max(RENEWED_AFTER_S);
        }
        self.swing = Some(swing);
    }

    /// The free swing that says most of the period.
    fn best_swing(&self) -> Option<&SwingState> {
        self.swing
            .iter()
            .chain(&self.before)
            .max_by(|a, b| a.worth().total_cmp(&b.worth()))
    }

    fn disturbances(&self) -> Vec<Advice> {
        let moved = self
            .limits
            .moved
            .map(|(at_s, tilt_deg)| Advice::PhoneMoved { at_s, tilt_deg });
        let touched = self.touched_s().map(|at_s| Advice::Touched { at_s });
        moved.into_iter().chain(touched).collect()
    }
}
