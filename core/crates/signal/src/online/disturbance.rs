//! Where the free swing begins, and who disturbs it.
//!
//! The last periods are looked at again and again by the same rule that cuts the whole record
//! (`free_swing_span`). A disturbance is told once the record goes on for a while behind it: both
//! sides are needed to be sure.

use super::phone;
use crate::{ChannelGroup, FreeSpan, free_swing_span};

/// Length of the window, periods: the prediction learns from ten cycles and judges the others.
const WINDOW_PERIODS: f64 = 16.0;
/// It is looked at every so many periods.
const EVERY_PERIODS: f64 = 3.0;
/// A disturbance is told once the record goes on for so many periods.
const TOLD_AFTER_PERIODS: f64 = 2.0;
/// The period taken before there is one, s.
const UNSEEN_PERIOD_S: f64 = 3.0;
/// Of the window's periods gravity is the mean over three of the slowest motion before and as many
/// after: slower ones than this, in main periods, do not fit.
const SLOWEST_PERIODS: f64 = 2.5;
/// A phone that moves disturbs the swing too: within so many periods the two are one.
const SAME_PERIODS: f64 = 4.0;

/// What is known of the swing's limits.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Limits {
    /// Start of the present free swing, s.
    pub from_s: f64,
    /// The last disturbance of a free swing, s.
    pub touched_s: Option<f64>,
    /// When the phone moved, s, and by how much, degrees.
    pub moved: Option<(f64, f64)>,
    next_look_s: f64,
}

/// Periods of a free swing, s.
#[derive(Debug, Clone, Copy)]
pub(super) struct Periods {
    pub main_s: f64,
    /// That of the slowest motion.
    pub slowest_s: f64,
}

/// What a look has found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Change {
    /// Nothing.
    None,
    /// The swing begins later than was thought: waiting and handling came before it.
    Later,
    /// The swing was disturbed; another begins after it.
    Disturbed,
}

impl Limits {
    pub fn is_due(&self, now_s: f64) -> bool {
        now_s >= self.next_look_s
    }

    /// Start of the window to look at.
    pub fn window_from_s(&self, now_s: f64, period_s: Option<f64>) -> f64 {
        self.from_s
            .max(now_s - WINDOW_PERIODS * period_s.unwrap_or(UNSEEN_PERIOD_S))
    }

    /// Looks at the cells of a window that ends now; the accelerometer's stand last where there are
    /// any.
    pub fn look(
        &mut self,
        window: &[ChannelGroup],
        accelerometer: Option<&ChannelGroup>,
        now_s: f64,
        periods: Option<Periods>,
    ) -> Change {
        let main_s = periods.map(|periods| periods.main_s);
        let window_from_s = self.window_from_s(now_s, main_s);
        let period_s = main_s.unwrap_or(UNSEEN_PERIOD_S);
        self.next_look_s = now_s + EVERY_PERIODS * period_s;
        let change = self.judge(&free_swing_span(window), window_from_s, now_s, period_s);
        // A hull that is held aside may be held at another tilt: before the free swing nothing is
        // said of the phone.
        let swinging = accelerometer
            .zip(periods)
            .filter(|_| change != Change::Later);
        let moved = swinging.and_then(|(gravity, Periods { main_s, slowest_s })| {
            phone::moved(gravity, slowest_s.min(SLOWEST_PERIODS * main_s))
        });
        if let Some(moved) = moved {
            self.moved = Some(
                self.moved
                    .map_or(moved, |known| if known.1 > moved.1 { known } else { moved }),
            );
        }
        change
    }

    fn judge(&mut self, span: &FreeSpan, window_from_s: f64, now_s: f64, period_s: f64) -> Change {
        if span.notes.is_empty() {
            return Change::None;
        }
        if now_s - span.end_s > TOLD_AFTER_PERIODS * period_s {
            return self.disturbed(span.end_s);
        }
        if span.start_s <= window_from_s + period_s / 16.0 {
            return Change::None;
        }
        if window_from_s > self.from_s {
            return self.disturbed(span.start_s);
        }
        self.from_s = span.start_s;
        Change::Later
    }

    fn disturbed(&mut self, at_s: f64) -> Change {
        self.from_s = at_s;
        self.touched_s = Some(at_s);
        Change::Disturbed
    }

    /// The disturbance, unless it is the phone's own.
    pub fn touched_s(&self, period_s: f64) -> Option<f64> {
        let own = |at_s: f64| {
            self.moved
                .is_some_and(|(moved_s, _)| (moved_s - at_s).abs() < SAME_PERIODS * period_s)
        };
        self.touched_s.filter(|&at_s| !own(at_s))
    }
}
