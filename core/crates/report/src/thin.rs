//! Long records thinned for pictures: the least and the greatest value of each column stay, so that
//! no spike is lost.

use super::source::Curve;

/// Points of a thinned curve, at most.
pub const MOST_POINTS: usize = 1200;
/// A pause longer than so many median intervals breaks the line.
const GAP_INTERVALS: f64 = 10.0;

/// Samples as a curve of at most about [`MOST_POINTS`] points, broken at gaps.
pub fn thinned(x: &[f64], y: &[f64]) -> Curve {
    let whole: Vec<(f64, f64)> = x.iter().copied().zip(y.iter().copied()).collect();
    let gap = GAP_INTERVALS * median_interval(x);
    let pieces: Vec<&[(f64, f64)]> = whole.chunk_by(|a, b| b.0 - a.0 <= gap).collect();
    let column = whole.len().div_ceil(MOST_POINTS / 2).max(1);
    let mut points = Vec::new();
    for (i, piece) in pieces.iter().enumerate() {
        if i > 0 {
            points.push((piece[0].0, f64::NAN));
        }
        piece
            .chunks(column)
            .for_each(|samples| points.extend(least_and_greatest(samples)));
    }
    Curve::of(points)
}

/// Up to two points of a column, in time order.
fn least_and_greatest(samples: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let by_value = |a: &&(f64, f64), b: &&(f64, f64)| a.1.total_cmp(&b.1);
    let finite = || samples.iter().filter(|p| p.1.is_finite());
    let (Some(low), Some(high)) = (finite().min_by(by_value), finite().max_by(by_value)) else {
        return vec![];
    };
    match low.0.total_cmp(&high.0) {
        std::cmp::Ordering::Less => vec![*low, *high],
        std::cmp::Ordering::Equal => vec![*low],
        std::cmp::Ordering::Greater => vec![*high, *low],
    }
}

fn median_interval(x: &[f64]) -> f64 {
    let mut steps: Vec<f64> = x.windows(2).map(|w| w[1] - w[0]).collect();
    if steps.is_empty() {
        return f64::INFINITY;
    }
    let middle = steps.len() / 2;
    *steps.select_nth_unstable_by(middle, f64::total_cmp).1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_spike_survives() {
        let x: Vec<f64> = (0..50_000).map(|i| 0.01 * f64::from(i)).collect();
        let mut y = vec![0.0; x.len()];
        (y[12_345], y[40_000]) = (7.0, -3.0);
        let curve = thinned(&x, &y);
        assert!(curve.x.len() <= MOST_POINTS);
        assert!(curve.points().any(|p| p == (x[12_345], 7.0)));
        assert!(curve.points().any(|p| p == (x[40_000], -3.0)));
        assert!(curve.x.is_sorted());
    }

    #[test]
    fn a_gap_breaks_the_line() {
        let x = [0.0, 0.1, 0.2, 0.3, 5.0, 5.1, 5.2];
        let curve = thinned(&x, &[1.0; 7]);
        assert_eq!(curve.y.iter().filter(|y| y.is_nan()).count(), 1);
        assert_eq!(curve.x.len(), 8);
    }

    #[test]
    fn nothing_and_one_sample() {
        assert_eq!(thinned(&[], &[]), Curve::default());
        assert_eq!(thinned(&[1.0], &[2.0]), Curve::of([(1.0, 2.0)]));
    }
}
