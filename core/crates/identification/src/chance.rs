//! What is surely more than chance.

/// So many standard deviations come by chance once in 10⁶.
pub const SURE: f64 = 5.0;

/// By how much a mean square of residuals over their noise exceeds what chance explains: of `count`
/// it has a standard deviation of √(2/n).
pub fn beyond_chance(mean_square: f64, count: f64) -> f64 {
    mean_square - 1.0 - SURE * (2.0 / count).sqrt()
}
