//! What a recorder writes where it has no reading: −999, 65535, 0 beside gravity.
//!
//! Such a value comes time and again, and lies far from everything that the sensor did read.

use super::series::{Fates, RawSeries};
use crate::samples::RepairKind;

/// A value that comes less often may be a damaged cell, or a knock.
const FEWEST: usize = 3;
/// It lies so many times the range of all other readings away from them.
const FAR: f64 = 3.0;
/// A range is told by so many different readings; a coarse sensor at rest has fewer.
const FEWEST_READINGS: usize = 10;

/// Marks the samples in which any channel has no reading.
pub(super) fn judge(raw: &RawSeries, fates: &mut Fates) {
    let rows: Vec<usize> = (0..fates.len()).filter(|&i| fates[i].is_none()).collect();
    for channel in &raw.channels {
        let absent = written_for_none(rows.iter().map(|&i| channel[i]).collect());
        for &i in rows.iter().filter(|&&i| absent.contains(&channel[i])) {
            fates[i].get_or_insert(RepairKind::NoReading);
        }
    }
}

/// The lowest value, the highest or both, where they stand for no reading.
fn written_for_none(mut values: Vec<f64>) -> Vec<f64> {
    values.sort_by(f64::total_cmp);
    let alike: Vec<&[f64]> = values.chunk_by(|a, b| a == b).collect();
    for (low, high) in [(1, 0), (0, 1), (1, 1)] {
        if alike.len() < FEWEST_READINGS + low + high {
            continue;
        }
        let (below, rest) = alike.split_at(low);
        let (rest, above) = rest.split_at(rest.len() - high);
        let (lowest, highest) = (rest[0][0], rest[rest.len() - 1][0]);
        let is_far = |value: f64| (lowest - value).max(value - highest) > FAR * (highest - lowest);
        let mut ends = below.iter().chain(above);
        if ends.all(|same| same.len() >= FEWEST && is_far(same[0])) {
            return below.iter().chain(above).map(|same| same[0]).collect();
        }
    }
    vec![]
}

#[cfg(test)]
mod tests {
    use super::written_for_none;

    fn swing() -> Vec<f64> {
        (0..2000)
            .map(|i| 9.8 + (0.05 * f64::from(i)).sin())
            .collect()
    }

    #[test]
    fn what_is_written_for_none_is_found_at_either_end() {
        let with = |ends: &[f64]| {
            let ends = ends.iter().flat_map(|end| [*end; 5]);
            written_for_none(swing().into_iter().chain(ends).collect())
        };
        assert_eq!(with(&[-999.0]), [-999.0]);
        assert_eq!(with(&[0.0]), [0.0]);
        assert_eq!(with(&[65535.0]), [65535.0]);
        assert_eq!(with(&[-999.0, 999.0]), [-999.0, 999.0]);
        assert!(with(&[]).is_empty() && with(&[11.0]).is_empty());
    }

    /// A sensor of coarse steps that rests, and then swings by one of them; a knock, which does not
    /// come again to the last digit.
    #[test]
    fn coarse_steps_and_knocks_are_readings() {
        let step = 0.00109083;
        let steps: Vec<f64> = (0..9000)
            .map(|i| step * f64::from(3 + i / 7000 * (i % 3)))
            .collect();
        assert!(written_for_none(steps).is_empty());
        let knocked = swing().into_iter().chain([60.1, 71.3, -44.0, 66.6]);
        assert!(written_for_none(knocked.collect()).is_empty());
    }
}
