//! Swings that hang as an earlier one did: which of their figures are the same readings.

use std::collections::BTreeSet;

use serde::{Deserialize, Serialize};

use super::session::{Session, Suspension};
use super::suspension::{HULL_PITCH, HULL_ROLL, LINE_LENGTH, SPACING};

/// That a swing hangs as an earlier one did, but for what is stated of it anew.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, schemars::JsonSchema)]
pub struct HungAs {
    /// The earlier swing's id.
    pub swing: String,
    /// Keys of the figures that are readings of its own; all others are the earlier swing's
    /// readings. `spacing` stands for points that are stated as well.
    #[serde(default)]
    pub but_for: BTreeSet<String>,
}

impl HungAs {
    /// Untouched since.
    pub fn swing(id: &str) -> Self {
        Self {
            swing: id.to_owned(),
            but_for: BTreeSet::new(),
        }
    }
}

impl Session {
    /// The earlier swing that a swing hangs as, by their places.
    pub fn same_hanging(&self, swing: usize) -> Option<usize> {
        let hung = self.hung_as.get(&self.swings.get(swing)?.id)?;
        let before = &self.swings[..swing];
        before.iter().position(|one| one.id == hung.swing)
    }

    /// The swing whose reading a figure of a swing's suspension is: its own place, or that of an
    /// earlier swing which hangs alike.
    pub fn measured_at(&self, swing: usize, key: &str) -> usize {
        let mut home = swing;
        while let Some(first) = self.same_hanging(home) {
            if self.states(home, key) {
                break;
            }
            home = first;
        }
        home
    }

    /// Whether a figure is stated of a swing itself, beside the earlier one that it hangs as.
    pub fn states(&self, swing: usize, key: &str) -> bool {
        let id = self.swings.get(swing).map(|one| &one.id);
        let hung = id.and_then(|id| self.hung_as.get(id));
        hung.is_none_or(|hung| hung.but_for.contains(key))
    }

    /// Notes that swings whose suspensions have equal figures share these readings: for sessions
    /// that a program makes, which measures the lines once and copies the figures.
    pub fn with_same_hangings(mut self) -> Self {
        for (i, swing) in self.swings.iter().enumerate() {
            let alike = self.swings[..i].iter().filter_map(|first| {
                let but_for = first.suspension.differences(&swing.suspension)?;
                let swing = first.id.clone();
                Some(HungAs { swing, but_for })
            });
            // The first of those that differ least.
            if let Some(hung) = alike.min_by_key(|hung| hung.but_for.len()) {
                self.hung_as.insert(swing.id.clone(), hung);
            }
        }
        self
    }
}

impl Suspension {
    /// A suspension with what is stated of another in the place of its own.
    ///
    /// Another direction has other points: of such a hanging only the length of the lines is kept.
    /// How far the points were moved belongs to the tilt that followed.
    pub fn but_for(&self, stated: &BTreeSet<String>, other: &Suspension) -> Suspension {
        let mut hung = self.clone();
        if self.kind.has_direction() && other.orientation != self.orientation {
            hung = Suspension {
                line_length_m: self.line_length_m,
                ..Suspension::unmeasured(self.kind, other.orientation)
            };
        } else if [HULL_PITCH, HULL_ROLL]
            .iter()
            .any(|key| stated.contains(*key))
        {
            hung.points_moved_m = None;
        }
        for key in stated {
            hung.set_figure(key, other.figure(key));
        }
        if stated.contains(SPACING) {
            hung.points_m = other.points_m.clone();
        }
        hung
    }

    /// Keys of the figures in which another suspension differs; none where it cannot be stated as
    /// this one but for them, or where nothing that was measured is the same.
    pub fn differences(&self, other: &Suspension) -> Option<BTreeSet<String>> {
        if self.kind != other.kind {
            return None;
        }
        let is_turned = self.kind.has_direction() && self.orientation != other.orientation;
        let is_new = |key: &str| {
            other.figure(key).is_some()
                && (self.figure(key) != other.figure(key) || is_turned && key != LINE_LENGTH)
        };
        let keys = self.kind.figures().iter().filter(|key| is_new(key));
        let mut but_for: BTreeSet<String> = keys.map(|key| (*key).to_owned()).collect();
        if self.points_m != other.points_m {
            but_for.insert(SPACING.to_owned());
        }
        let shares = |key: &str| self.figure(key).is_some() && !but_for.contains(key);
        let is_shared = self.kind.needs().iter().any(|key| shares(key));
        let is_untouched = but_for.is_empty();
        let is_alike = self.but_for(&but_for, other) == *other;
        ((is_shared || is_untouched) && is_alike).then_some(but_for)
    }
}
