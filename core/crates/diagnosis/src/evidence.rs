//! What a cause must gain to be taken, and to be kept.

use super::fitting::Fitted;
use super::white::Left;

/// Evidence of e⁷ = 1100 to 1 for a cause: a complete session, looked at for thirty, is then
/// wronged less than once in fifty.
pub const LEAST_GAIN: f64 = 7.0;
/// A cause that gains so much where nothing more is to be seen is fitted in full: weaker ones are
/// linear.
pub const DOUBTFUL: f64 = 2.0;
/// Where nothing is left to see, a further cause must gain more than this, and more than this share
/// of the first's gain: laws that differ a little from nature's leave something for others to pick
/// up.
pub const FURTHER_GAIN: f64 = 14.0;
const FURTHER_SHARE: f64 = 3e-3;
/// A further cause must take so much of what is left beyond noise.
const FURTHER_TAKES: f64 = 0.7;

/// The gain that is asked of a cause: of the first, and of a further one where nothing is left to
/// see.
pub fn asked(first_gain: Option<f64>) -> f64 {
    first_gain.map_or(LEAST_GAIN, |first| FURTHER_GAIN.max(FURTHER_SHARE * first))
}

/// Whether a cause is taken beside those before it (the first of which gained so much), by its own
/// gain and by what it leaves of what was left.
pub fn pays(first_gain: Option<f64>, gain: f64, leaves: &Left, left: &Left) -> bool {
    if first_gain.is_none() || left.is_white() {
        gain > asked(first_gain)
    } else {
        gain > LEAST_GAIN && leaves.excess() < (1.0 - FURTHER_TAKES) * left.excess()
    }
}

/// Whether a cause taken before others is missed once it is left out.
pub fn is_missed(lost: f64, without: &Left, with: &Left) -> bool {
    lost >= if without.excess() > with.excess() {
        LEAST_GAIN
    } else {
        FURTHER_GAIN
    }
}

/// Logarithm of the evidence of a model with a cause over that without.
pub fn gain(without: &Fitted, with: &Fitted) -> Option<f64> {
    Some(with.log_evidence? - without.log_evidence?)
}
