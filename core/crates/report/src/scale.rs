//! Scales of a chart: a range of values laid along a line of the drawing, with ticks at round
//! numbers.

use super::words::raised;
use gyradius_base::language::minus;

/// Beyond this a value is not drawn: differences of such values overflow.
const LARGEST: f64 = 1e100;

/// Values from `low` to `high` laid from `from` to `to`, drawing units.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    /// Value at `from`; its common logarithm where `log`.
    low: f64,
    /// Value at `to`; its common logarithm where `log`.
    high: f64,
    log: bool,
    from: f64,
    to: f64,
}

/// True for what can be drawn.
pub(super) fn drawable(value: f64) -> bool {
    value.is_finite() && value.abs() < LARGEST
}

/// Least and greatest of the drawable values.
pub(super) fn extent(values: impl IntoIterator<Item = f64>) -> Option<[f64; 2]> {
    values
        .into_iter()
        .filter(|v| drawable(*v))
        .fold(None, |found, v| match found {
            None => Some([v, v]),
            Some([low, high]) => Some([v.min(low), v.max(high)]),
        })
}

/// A range wide enough to be drawn, with a margin as a share of its width.
pub(super) fn padded(range: Option<[f64; 2]>, margin: f64) -> [f64; 2] {
    let [low, high] = range.unwrap_or([0.0, 1.0]);
    let width = high - low;
    let least = 1e-9 * low.abs().max(high.abs());
    if width <= least {
        let half = if low == 0.0 { 1.0 } else { 0.05 * low.abs() };
        return [low - half, high + half];
    }
    [low - margin * width, high + margin * width]
}

impl Scale {
    /// An even scale.
    pub fn linear([low, high]: [f64; 2], from: f64, to: f64) -> Self {
        Self {
            low,
            high,
            log: false,
            from,
            to,
        }
    }

    /// A logarithmic scale of positive values.
    pub fn logarithmic([low, high]: [f64; 2], from: f64, to: f64) -> Self {
        let low = low.max(f64::MIN_POSITIVE).log10();
        let high = high.max(f64::MIN_POSITIVE).log10();
        Self {
            low,
            high: if high > low { high } else { low + 1.0 },
            log: true,
            from,
            to,
        }
    }

    /// Place of a value; none for what cannot be drawn.
    pub fn place(&self, value: f64) -> Option<f64> {
        let value = if self.log && value > 0.0 {
            value.log10()
        } else {
            value
        };
        if !drawable(value) || (self.log && value <= -300.0) {
            return None;
        }
        Some(self.from + (value - self.low) / (self.high - self.low) * (self.to - self.from))
    }

    /// Place of a value, held inside the scale.
    pub fn held(&self, value: f64) -> Option<f64> {
        let (least, most) = (self.from.min(self.to), self.from.max(self.to));
        self.place(value).map(|place| place.clamp(least, most))
    }

    /// Ticks inside the scale, about `count` of them: value and text.
    pub fn ticks(&self, count: usize) -> Vec<(f64, String)> {
        if self.log {
            self.decades(count)
        } else {
            self.rounds(count)
        }
    }

    fn rounds(&self, count: usize) -> Vec<(f64, String)> {
        let step = round_step((self.high - self.low) / count.max(1) as f64);
        let places = (-step.log10().floor()).clamp(0.0, 12.0) as usize;
        let first = (self.low / step - 1e-9).ceil();
        let last = (self.high / step + 1e-9).floor();
        let number = (last - first).clamp(0.0, 20.0) as usize;
        (0..=number)
            .map(|i| step * (first + i as f64))
            .filter(|value| *value <= self.high + 1e-9 * step)
            .map(|value| (value, tick_text(value, step, places)))
            .collect()
    }

    fn decades(&self, count: usize) -> Vec<(f64, String)> {
        let (first, last) = (self.low.ceil() as i32, self.high.floor() as i32);
        if last - first < 1 {
            return self.within_a_decade();
        }
        let stride = ((last - first) as usize).div_ceil(count.max(1)).max(1);
        (first..=last)
            .step_by(stride)
            .map(|n| (10f64.powi(n), power_of_ten(n)))
            .collect()
    }

    fn within_a_decade(&self) -> Vec<(f64, String)> {
        let decade = self.low.floor() as i32;
        (decade..=decade + 1)
            .flat_map(|n| [1.0, 2.0, 5.0].map(|digit| digit * 10f64.powi(n)))
            .filter(|value| (self.low..=self.high).contains(&value.log10()))
            .map(|value| (value, super::digits::significant(value, 1)))
            .collect()
    }
}

/// The round step (1, 2 or 5 times a power of ten) at or above a width.
fn round_step(width: f64) -> f64 {
    let decade = 10f64.powf(width.max(1e-300).log10().floor());
    let digit = [1.0, 2.0, 5.0]
        .into_iter()
        .find(|d| d * decade >= width * (1.0 - 1e-9));
    decade * digit.unwrap_or(10.0)
}

fn tick_text(value: f64, step: f64, places: usize) -> String {
    let large = value.abs().max(step);
    if large >= 1e6 || step < 1e-6 {
        return minus(&format!(
            "{:.1e}",
            if value.abs() < 1e-6 * step {
                0.0
            } else {
                value
            }
        ));
    }
    minus(&format!("{value:.places$}"))
}

/// `10⁻³`.
fn power_of_ten(n: i32) -> String {
    if n == 0 {
        "1".into()
    } else {
        format!(
            "10{}",
            n.to_string().chars().map(raised).collect::<String>()
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(range: [f64; 2], count: usize) -> Vec<String> {
        Scale::linear(range, 0.0, 100.0)
            .ticks(count)
            .into_iter()
            .map(|(_, text)| text)
            .collect()
    }

    #[test]
    fn ticks_are_round() {
        assert_eq!(texts([-0.3, 1.1], 4), ["0.0", "0.5", "1.0"]);
        assert_eq!(
            texts([0.0, 120.0], 6),
            ["0", "20", "40", "60", "80", "100", "120"]
        );
        assert_eq!(
            texts([9.79, 9.83], 4),
            ["9.79", "9.80", "9.81", "9.82", "9.83"]
        );
    }

    #[test]
    fn decades_are_powers_of_ten() {
        let scale = Scale::logarithmic([2e-5, 0.3], 0.0, 100.0);
        let texts: Vec<String> = scale.ticks(5).into_iter().map(|(_, text)| text).collect();
        assert_eq!(texts, ["10⁻⁴", "10⁻³", "10⁻²", "10⁻¹"]);
    }

    #[test]
    fn no_range_is_too_narrow() {
        assert_eq!(padded(None, 0.0), [0.0, 1.0]);
        assert_eq!(padded(Some([0.0, 0.0]), 0.1), [-1.0, 1.0]);
        let [low, high] = padded(Some([2.0, 2.0]), 0.1);
        assert!(low < 2.0 && high > 2.0);
    }
}
