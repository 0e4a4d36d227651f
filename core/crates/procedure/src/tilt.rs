//! The hull's tilt from gravity, as far as it can be known before the phone's place on the hull is.

use std::collections::VecDeque;

use serde::{Deserialize, Serialize};

use super::event::Placement;
use gyradius_base::frames::Vec3;

/// A reading is the mean over this time, ns: handling averages out, and the figure still follows
/// the hand.
const OVER_NS: u64 = 2_000_000_000;
/// Forces farther from standing gravity than this share are a phone in the hand, not a tilt.
const GRAVITY: std::ops::Range<f64> = 8.0..12.0;

/// A tilt, and what it is against.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Tilt {
    /// What the angles are against.
    pub against: Against,
    /// Angle between gravity now and gravity there, degrees; absent where there is nothing to be
    /// against.
    pub angle_deg: Option<f64>,
    /// Bow up, degrees; known only where the phone lies flat with its top edge to the bow.
    pub bow_up_deg: Option<f64>,
    /// Starboard side down, degrees; known only where the phone lies so.
    pub starboard_down_deg: Option<f64>,
}

/// What a tilt is against.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Against {
    /// The phone's own plane, which lies flat on the hull: as good as it lies.
    PhonePlane,
    /// The reading at which the operator said that the hull was level: a size without a direction.
    Reference,
    /// Nothing yet: the operator has not said when it was level.
    Nothing,
}

/// The latest readings of the accelerometer.
#[derive(Debug, Clone, Default)]
pub(super) struct TiltReader {
    latest: VecDeque<(i64, Vec3)>,
}

impl TiltReader {
    pub fn push(&mut self, stamps_ns: &[i64], values: &[[f64; 3]]) {
        for (&stamp, value) in stamps_ns.iter().zip(values) {
            if value.iter().all(|v| v.is_finite()) {
                self.latest.push_back((stamp, Vec3::from(*value)));
            }
            while self
                .latest
                .front()
                .is_some_and(|(first, _)| stamp.abs_diff(*first) > OVER_NS)
            {
                self.latest.pop_front();
            }
        }
    }

    /// Mean direction of specific force, where it is that of something that hangs still.
    pub fn up(&self) -> Option<Vec3> {
        let count = self.latest.len();
        let mean = self.latest.iter().map(|(_, value)| value).sum::<Vec3>() / count.max(1) as f64;
        GRAVITY.contains(&mean.norm()).then(|| mean.normalize())
    }

    pub fn tilt(&self, placement: Placement, reference: Option<Vec3>) -> Option<Tilt> {
        let up = self.up()?;
        let against_reference = reference.map(|level| level.angle(&up).to_degrees());
        Some(match placement {
            // x to starboard, y to the bow, z up: what goes up shows gravity's reaction with its
            // own sign.
            Placement::FlatTopToBow => Tilt {
                against: Against::PhonePlane,
                angle_deg: Some(up.angle(&Vec3::z()).to_degrees()),
                bow_up_deg: Some(up.y.asin().to_degrees()),
                starboard_down_deg: Some((-up.x).asin().to_degrees()),
            },
            Placement::AnyWay => Tilt {
                against: if reference.is_some() {
                    Against::Reference
                } else {
                    Against::Nothing
                },
                angle_deg: against_reference,
                bow_up_deg: None,
                starboard_down_deg: None,
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn reader(value: [f64; 3]) -> TiltReader {
        let mut reader = TiltReader::default();
        let stamps: Vec<i64> = (0..400).map(|i| 10_000_000 * i).collect();
        reader.push(&stamps, &vec![value; 400]);
        reader
    }

    // A phone flat on a deck that is 3° bow up: its y axis points 3° above the horizon and feels g
    // sin 3°.
    #[test]
    fn a_flat_phone_tells_direction_and_any_other_only_size() {
        let up = [
            0.0,
            9.81 * 3_f64.to_radians().sin(),
            9.81 * 3_f64.to_radians().cos(),
        ];
        let reader = reader(up);
        let flat = reader.tilt(Placement::FlatTopToBow, None).unwrap();
        assert!((flat.bow_up_deg.unwrap() - 3.0).abs() < 1e-9, "{flat:?}");
        assert!(flat.starboard_down_deg.unwrap().abs() < 1e-9, "{flat:?}");
        let bare = reader.tilt(Placement::AnyWay, None).unwrap();
        assert_eq!(
            (bare.against, bare.angle_deg, bare.bow_up_deg),
            (Against::Nothing, None, None)
        );
        let against = reader.tilt(Placement::AnyWay, Some(Vec3::z())).unwrap();
        assert!(
            (against.angle_deg.unwrap() - 3.0).abs() < 1e-9,
            "{against:?}"
        );
        assert_eq!(against.bow_up_deg, None);
    }

    #[test]
    fn a_phone_that_falls_or_gives_no_numbers_has_no_tilt() {
        assert_eq!(reader([0.0, 0.0, 1.0]).tilt(Placement::AnyWay, None), None);
        assert_eq!(
            reader([f64::NAN, 0.0, 9.8]).tilt(Placement::AnyWay, None),
            None
        );
        assert_eq!(
            TiltReader::default().tilt(Placement::FlatTopToBow, None),
            None
        );
    }
}
