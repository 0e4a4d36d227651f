//! Few instants that stand for many: what a smooth motion reads on average over a block of samples.

/// An instant, s, and its share of the block.
pub type Node = (f64, f64);

/// The Gauss quadrature of the samples' own times: up to three instants whose weighted mean is that
/// over all samples, exact for polynomials to the fifth degree (W. Gautschi, *Orthogonal
/// Polynomials: Computation and Approximation* (2004), sec. 1.4). Over a sixteenth of a period that
/// leaves (2π/16)⁶/2016000 = 2e-9 of a sine.
pub fn nodes(t_s: &[f64]) -> Vec<Node> {
    three(t_s).unwrap_or_else(|| {
        let share = 1.0 / t_s.len().max(1) as f64;
        t_s.iter().map(|t| (*t, share)).collect()
    })
}

/// Of more than three samples; none where fewer of them are apart.
fn three(t_s: &[f64]) -> Option<Vec<Node>> {
    if t_s.len() <= 3 {
        return None;
    }
    let count = t_s.len() as f64;
    let middle = t_s.iter().sum::<f64>() / count;
    let reach = t_s
        .iter()
        .fold(0.0, |most: f64, t| most.max((t - middle).abs()));
    // Of times from the middle, in units of the reach; the first moment is zero.
    let mut moments = [0.0; 6];
    for t in t_s {
        let (u, mut power) = ((t - middle) / reach, 1.0);
        for moment in &mut moments {
            *moment += power / count;
            power *= u;
        }
    }
    let [_, _, m2, m3, m4, m5] = moments;
    // u³ + a u² + b u + e, at right angles to 1, u and u² over the samples.
    let gram = m4 - m3 * m3 / m2 - m2 * m2;
    // Rounding of the moments is 1e-16.
    if gram.is_nan() || gram < 1e-9 {
        return None;
    }
    let a = (m3 * m4 / m2 + m2 * m3 - m5) / gram;
    let (b, e) = (-(m4 + a * m3) / m2, -m3 - a * m2);
    let roots = roots(a, b, e);
    let share = |j: usize| {
        let (one, other) = (roots[(j + 1) % 3], roots[(j + 2) % 3]);
        (m2 + one * other) / ((roots[j] - one) * (roots[j] - other))
    };
    Some(
        (0..3)
            .map(|j| (middle + reach * roots[j], share(j)))
            .collect(),
    )
}

/// Of u³ + a u² + b u + e, all real (Viète).
fn roots(a: f64, b: f64, e: f64) -> [f64; 3] {
    let (p, shift) = (b - a * a / 3.0, -a / 3.0);
    let q = 2.0 * a.powi(3) / 27.0 - a * b / 3.0 + e;
    let size = 2.0 * (-p / 3.0).max(0.0).sqrt();
    let angle = (3.0 * q / (p * size)).clamp(-1.0, 1.0).acos() / 3.0;
    [0.0, 1.0, 2.0].map(|k| shift + size * (angle - k * std::f64::consts::TAU / 3.0).cos())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mean(t_s: &[f64], of: impl Fn(f64) -> f64) -> f64 {
        t_s.iter().map(|t| of(*t)).sum::<f64>() / t_s.len() as f64
    }

    /// Even and uneven stamps, far from zero: powers to the fifth, and a sine over a sixteenth of its
    /// period.
    #[test]
    fn a_block_is_read_as_its_samples_are() {
        let even: Vec<f64> = (0..11).map(|i| 300.0 + 0.01 * f64::from(i)).collect();
        let uneven = vec![300.0, 300.001, 300.013, 300.02, 300.06, 300.061, 300.1];
        let few = vec![300.0, 300.05, 300.1];
        for t_s in [even, uneven, few] {
            let nodes = nodes(&t_s);
            assert!(nodes.len() == 3);
            let by_nodes =
                |of: &dyn Fn(f64) -> f64| nodes.iter().map(|(t, w)| w * of(*t)).sum::<f64>();
            for degree in 0..6 {
                let power = |t: f64| ((t - 300.05) / 0.05).powi(degree);
                assert!(
                    (by_nodes(&power) - mean(&t_s, power)).abs() < 1e-9,
                    "{degree}"
                );
            }
            let sine = |t: f64| (std::f64::consts::TAU * t / 1.6).sin();
            assert!((by_nodes(&sine) - mean(&t_s, sine)).abs() < 1e-8);
        }
    }

    #[test]
    fn samples_that_share_their_stamps_stand_for_themselves() {
        let nodes = nodes(&[1.0, 1.0, 2.0, 2.0, 2.0]);
        assert_eq!(nodes.len(), 5);
        let late: f64 = nodes.iter().filter(|n| n.0 == 2.0).map(|n| n.1).sum();
        assert!((late - 0.6).abs() < 1e-15);
    }
}
