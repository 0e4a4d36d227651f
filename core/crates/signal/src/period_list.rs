//! One period and its uncertainty from a list of periods (photogate, stopwatch).

use gyradius_base::error::{Error, Result};
use gyradius_recording::PeriodList;

use super::crossings::median;
use super::modulation::{PeriodTrend, fit_period_trend};

/// What a list of periods says.
#[derive(Debug, Clone, PartialEq)]
pub struct ListedPeriod {
    /// Mean period over the list, modulation taken off, s.
    pub period_s: f64,
    /// Its standard uncertainty, correlation of neighbours included, s.
    pub u_s: f64,
    /// Eq. (14), as far as the list supports it.
    pub trend: PeriodTrend,
    /// Entries left out.
    pub flagged: Vec<FlaggedPeriod>,
}

/// An entry that is no single period of this motion.
#[derive(Debug, Clone, PartialEq)]
pub struct FlaggedPeriod {
    /// Where in the list, from 0.
    pub index: usize,
    /// Its time, s.
    pub t_s: f64,
    /// Its value, s.
    pub period_s: f64,
    /// Counts missed or made up: 2 for a doubled period, 0.5 for a halved one; absent for another
    /// outlier.
    pub factor: Option<f64>,
}

/// Miscounts that occur: a passage missed (or two), one seen that was none.
const MISCOUNTS: [f64; 6] = [0.5, 2.0, 3.0, 1.5, 1.0 / 3.0, 4.0];

/// Period, trend and modulation of a list; doubled and halved entries and outliers are left out and
/// listed.
pub fn period_from_list(list: &PeriodList) -> Result<ListedPeriod> {
    let usable = |p: &&f64| p.is_finite() && **p > 0.0;
    let positive: Vec<f64> = list.period_s.iter().filter(usable).copied().collect();
    let middle = median(&positive)
        .ok_or_else(|| Error::no_result(&list.name, "there is no period in the list"))?;
    let (kept, flagged) = sorted_out(list, middle);
    let (t, p): (Vec<f64>, Vec<f64>) = kept.into_iter().unzip();
    let trend = fit_period_trend(&t, &p)
        .ok_or_else(|| Error::no_result(&list.name, "one period has no scatter to judge it by"))?;
    let u_s = trend.mean_se_s * correlation_factor(&t, &p, &trend);
    Ok(ListedPeriod {
        period_s: trend.mean_s,
        u_s,
        trend,
        flagged,
    })
}

type Entries = Vec<(f64, f64)>;

fn sorted_out(list: &PeriodList, middle: f64) -> (Entries, Vec<FlaggedPeriod>) {
    let deviations: Vec<f64> = list.period_s.iter().map(|p| (p - middle).abs()).collect();
    // 1.4826 × the median deviation is a normal distribution's σ; a modulation by beats must
    // survive, so at least 5 %.
    let tolerance = (8.0 * 1.4826 * median(&deviations).unwrap_or(0.0))
        .max(0.05 * middle)
        .min(0.3 * middle);
    let (mut kept, mut flagged) = (Vec::new(), Vec::new());
    for (index, (&t_s, &period_s)) in list.t_s.iter().zip(&list.period_s).enumerate() {
        if (period_s - middle).abs() <= tolerance && t_s.is_finite() {
            kept.push((t_s, period_s));
        } else {
            let factor = MISCOUNTS
                .into_iter()
                .find(|k| (period_s / middle / k - 1.0).abs() < 0.1);
            flagged.push(FlaggedPeriod {
                index,
                t_s,
                period_s,
                factor,
            });
        }
    }
    (kept, flagged)
}

/// √((1+r)/(1−r)) for neighbours correlated by r (first-order autoregression), not below 1.
///
/// Periods that share a passage are anticorrelated, which would make the mean better; that gain is
/// not claimed.
fn correlation_factor(t: &[f64], p: &[f64], trend: &PeriodTrend) -> f64 {
    let origin = t.first().copied().unwrap_or(0.0);
    let residual: Vec<f64> = t
        .iter()
        .zip(p)
        .map(|(t, p)| p - trend.at(t - origin))
        .collect();
    let power: f64 = residual.iter().map(|r| r * r).sum();
    let shared: f64 = residual.windows(2).map(|w| w[0] * w[1]).sum();
    let r = if power > 0.0 {
        (shared / power).clamp(0.0, 0.98)
    } else {
        0.0
    };
    ((1.0 + r) / (1.0 - r)).sqrt()
}
