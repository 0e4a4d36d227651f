//! The gaps of one sensor, and of all.

use serde::{Deserialize, Serialize};

use gyradius_recording::Sensor;

/// So many gaps of a sensor are listed; what is gone is the shortest.
const LISTED: usize = 100;

/// A time without samples.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
pub struct Gap {
    /// Whose.
    pub sensor: Sensor,
    /// The last stamp before it, s.
    pub from_s: f64,
    /// How long it lasted, s.
    pub length_s: f64,
}

/// Every gap of a recording, as far as a list of them is of use.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct GapList {
    /// The gaps, first to last: the hundred longest of each sensor.
    pub listed: Vec<Gap>,
    /// How many more there are; each is shorter than what is listed of its sensor.
    pub more: u64,
}

impl GapList {
    /// Takes the next gap of a sensor.
    pub(super) fn take(&mut self, gap: Gap) {
        self.listed.push(gap);
        if self.listed.len() > LISTED {
            let lengths = self.listed.iter().map(|gap| gap.length_s).enumerate();
            let shortest = lengths
                .min_by(|a, b| a.1.total_cmp(&b.1))
                .map_or(0, |(at, _)| at);
            self.listed.remove(shortest);
            self.more += 1;
        }
    }

    /// How many there are, listed or not.
    pub(super) fn count(&self) -> u64 {
        self.listed.len() as u64 + self.more
    }

    /// How long the longest lasted, s; 0 where there is none.
    pub(super) fn longest_s(&self) -> f64 {
        self.listed
            .iter()
            .map(|gap| gap.length_s)
            .fold(0.0, f64::max)
    }

    /// Those of two sensors, by time.
    pub(super) fn with(&self, other: &Self) -> Self {
        let mut listed = [self.listed.as_slice(), &other.listed].concat();
        listed.sort_by(|a, b| a.from_s.total_cmp(&b.from_s));
        Self {
            listed,
            more: self.more + other.more,
        }
    }
}
