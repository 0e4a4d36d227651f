//! A two-gate timer: passages, periods, and amplitude from the time a flag blocks the beam.
//!
//! A gate stands beside the rest position, so passages to and fro are unevenly spaced; passages in
//! the same direction are one period apart whatever the gate's place. Gates at the two ends of a
//! body see yaw alike and sway with opposite sign: the mean of their passages is free of sway to
//! first order, their difference shows it.

use gyradius_base::error::{Error, Result};
use gyradius_recording::{GateEvents, PeriodList};

use super::amplitude::WindowPoint;
use super::crossings::median;
use super::curve_fit::linear;

/// Periods and amplitudes from light gates.
#[derive(Debug, Clone, PartialEq)]
pub struct GatePeriods {
    /// Middle of each period, s.
    pub t_s: Vec<f64>,
    /// Period, s.
    pub period_s: Vec<f64>,
    /// Scatter of a single period (robust, same for all), s.
    pub period_se_s: Vec<f64>,
    /// Amplitude of the flag's motion, m.
    pub amplitude_m: Vec<f64>,
    /// The passages used, in time order: middle of the blocked interval, mean of the gates, s.
    pub passages_s: Vec<f64>,
    /// Blocked time of each passage, mean speed of the gates, m/s.
    pub speed_m_s: Vec<f64>,
    /// B's passage after A's, s; empty with one gate. Sway shows here.
    pub difference_s: Vec<f64>,
    /// What was missed or left out.
    pub notes: Vec<String>,
}

/// A flag's way through one beam.
#[derive(Debug, Clone, Copy)]
struct Passage {
    t_s: f64,
    blocked_s: f64,
}

/// Passages of one gate: complete blocked intervals only.
fn passages(t_s: &[f64], blocked: &[bool]) -> Vec<Passage> {
    let mut found = Vec::new();
    let mut entered = None;
    for i in 1..t_s.len().min(blocked.len()) {
        match (blocked[i - 1], blocked[i]) {
            (false, true) => entered = Some(t_s[i]),
            (true, false) => {
                let whole = entered.take().filter(|from| t_s[i] > *from);
                found.extend(whole.map(|from| Passage {
                    t_s: 0.5 * (from + t_s[i]),
                    blocked_s: t_s[i] - from,
                }));
            }
            _ => {}
        }
    }
    found
}

/// Periods and amplitudes of a two-gate (or one-gate) log whose flag is `flag_width_m` wide.
pub fn gate_periods(events: &GateEvents, flag_width_m: f64) -> Result<GatePeriods> {
    if !(flag_width_m > 0.0 && flag_width_m.is_finite()) {
        return Err(Error::argument(
            "flag_width_m",
            "a positive width",
            flag_width_m,
        ));
    }
    let (a, b) = (
        passages(&events.t_s, &events.a),
        passages(&events.t_s, &events.b),
    );
    let mut notes = Vec::new();
    let joined = match (a.len() < 4, b.len() < 4) {
        (false, false) => paired(&a, &b, flag_width_m, &mut notes),
        (false, true) => alone(&a, flag_width_m),
        (true, false) => alone(&b, flag_width_m),
        (true, true) => return Err(Error::no_result("light gates", "fewer than four passages")),
    };
    series(&joined, notes)
}

/// One passage of the body: time, speed, and what B came after A.
#[derive(Debug, Clone, Copy)]
struct Joined {
    t_s: f64,
    speed_m_s: f64,
    difference_s: Option<f64>,
}

fn alone(passages: &[Passage], flag_width_m: f64) -> Vec<Joined> {
    let joined = |p: &Passage| Joined {
        t_s: p.t_s,
        speed_m_s: flag_width_m / p.blocked_s,
        difference_s: None,
    };
    passages.iter().map(joined).collect()
}

/// Passages seen by both gates within an eighth of a period of each other.
fn paired(a: &[Passage], b: &[Passage], flag_width_m: f64, notes: &mut Vec<String>) -> Vec<Joined> {
    let half_s = median(
        &a.windows(2)
            .map(|w| w[1].t_s - w[0].t_s)
            .collect::<Vec<f64>>(),
    )
    .unwrap_or(0.0);
    let mut joined = Vec::new();
    let mut from = 0;
    for p in a {
        while from < b.len() && b[from].t_s < p.t_s - 0.25 * half_s {
            from += 1;
        }
        if let Some(q) = b.get(from).filter(|q| q.t_s < p.t_s + 0.25 * half_s) {
            joined.push(Joined {
                t_s: 0.5 * (p.t_s + q.t_s),
                speed_m_s: 0.5 * flag_width_m * (1.0 / p.blocked_s + 1.0 / q.blocked_s),
                difference_s: Some(q.t_s - p.t_s),
            });
            from += 1;
        }
    }
    let lost = (a.len() - joined.len(), b.len() - joined.len());
    if lost != (0, 0) {
        notes.push(format!(
            "{} passages of gate A and {} of gate B have no partner and are left out",
            lost.0, lost.1
        ));
    }
    joined
}

fn series(joined: &[Joined], mut notes: Vec<String>) -> Result<GatePeriods> {
    let t: Vec<f64> = joined.iter().map(|j| j.t_s).collect();
    let half_s =
        median(&t.windows(2).map(|w| w[1] - w[0]).collect::<Vec<f64>>()).ok_or_else(|| {
            Error::no_result("light gates", "the two gates never saw the same passage")
        })?;
    let mut out = GatePeriods {
        t_s: Vec::new(),
        period_s: Vec::new(),
        period_se_s: Vec::new(),
        amplitude_m: Vec::new(),
        speed_m_s: joined.iter().map(|j| j.speed_m_s).collect(),
        difference_s: joined.iter().filter_map(|j| j.difference_s).collect(),
        passages_s: t,
        notes: Vec::new(),
    };
    for w in joined.windows(3) {
        let (there_s, back_s) = (w[1].t_s - w[0].t_s, w[2].t_s - w[1].t_s);
        // A passage missed or made up makes one of the two steps far too long or short.
        if [there_s, back_s]
            .iter()
            .all(|s| (s / half_s - 1.0).abs() < 0.4)
        {
            let period_s = there_s + back_s;
            out.t_s.push(w[1].t_s);
            out.period_s.push(period_s);
            out.amplitude_m.push(amplitude(
                w[1].speed_m_s,
                period_s,
                0.25 * (there_s - back_s),
            ));
        }
    }
    let missed = joined.len().saturating_sub(2) - out.period_s.len();
    if missed > 0 {
        notes.push(format!(
            "{missed} periods are not used: a passage was missed or made up beside them"
        ));
    }
    let scatter_s = scatter(&out.period_s);
    out.period_se_s = vec![scatter_s; out.period_s.len()];
    out.notes = notes;
    Ok(out)
}

/// Amplitude from the speed at the gate; `late_s` is how far the passage is from the middle between
/// its neighbours, which gives the gate's distance from the rest position.
fn amplitude(speed_m_s: f64, period_s: f64, late_s: f64) -> f64 {
    (speed_m_s * period_s / std::f64::consts::TAU).hypot(speed_m_s * late_s)
}

/// Scatter of single periods from differences of neighbours two apart (those share no passage's
/// direction).
fn scatter(period_s: &[f64]) -> f64 {
    let steps: Vec<f64> = period_s.windows(3).map(|w| (w[2] - w[0]).abs()).collect();
    // 1.4826: σ of a normal distribution over its median deviation; √2: a difference of two.
    1.4826 / 2f64.sqrt() * median(&steps).unwrap_or(0.0)
}

impl GatePeriods {
    /// The periods as a list of the session format's kind.
    pub fn list(&self, name: &str) -> PeriodList {
        PeriodList {
            name: name.into(),
            t_s: self.t_s.clone(),
            period_s: self.period_s.clone(),
            repairs: Vec::new(),
        }
    }

    /// Period and decay against amplitude (m) in windows of `passages_per_window` passages: the
    /// slope of passage time against count, to and fro displaced by the gate's place.
    pub fn against_amplitude(&self, passages_per_window: usize) -> Vec<WindowPoint> {
        let size = passages_per_window.max(5);
        let count = self.passages_s.len() / size;
        (0..count)
            .filter_map(|k| self.window(k * size, (k + 1) * size))
            .collect()
    }

    fn window(&self, from: usize, to: usize) -> Option<WindowPoint> {
        let t = &self.passages_s[from..to];
        let half_s = median(&t.windows(2).map(|w| w[1] - w[0]).collect::<Vec<f64>>())?;
        let mut count = vec![0.0];
        for w in t.windows(2) {
            count.push(count.last()? + ((w[1] - w[0]) / half_s).round());
        }
        let side: Vec<f64> = count
            .iter()
            .map(|c| if c.rem_euclid(2.0) < 0.5 { 0.5 } else { -0.5 })
            .collect();
        let centred: Vec<f64> = count
            .iter()
            .map(|c| c - 0.5 * count[count.len() - 1])
            .collect();
        let ones = vec![1.0; t.len()];
        let times = linear(&[ones.clone(), centred.clone(), side], t, &ones)?;
        let period_s = 2.0 * times.parameters[1];
        let log_speed: Vec<f64> = self.speed_m_s[from..to].iter().map(|v| v.ln()).collect();
        let decay = linear(&[ones.clone(), centred], &log_speed, &ones)?;
        Some(WindowPoint {
            t_s: times.parameters[0],
            amplitude: decay.parameters[0].exp() * period_s / std::f64::consts::TAU,
            period_s,
            period_se_s: 2.0 * times.se(1),
            decrement: -2.0 * decay.parameters[1],
            decrement_se: 2.0 * decay.se(1),
        })
    }
}
