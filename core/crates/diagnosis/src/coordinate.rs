//! What a learned force acts on.

use gyradius_recording::ModeName;

use gyradius_base::named;

named! {
    /// What a learned force acts on: a coordinate of the hull, or the motion that a swing was seen
    /// in.
    ForceCoordinate: "coordinate of a force" {
        /// On more than one coordinate.
        All = "all",
        /// The turn of a compound pendulum.
        Compound = "compound pendulum",
        /// Pitch.
        Pitch = "pitch",
        /// The pitch that goes with the lines.
        PitchInPhase = "pitch in phase",
        /// The pitch that goes against the lines.
        PitchOutOfPhase = "pitch out of phase",
        /// Roll.
        Roll = "roll",
        /// The roll that goes with the lines.
        RollInPhase = "roll in phase",
        /// The roll that goes against the lines.
        RollOutOfPhase = "roll out of phase",
        /// Along the hull.
        Surge = "surge",
        /// Across the hull.
        Sway = "sway",
        /// The turn of a motion without a name.
        Other = "unnamed motion",
        /// Yaw.
        Yaw = "yaw",
    }
}

impl From<ModeName> for ForceCoordinate {
    fn from(mode: ModeName) -> Self {
        match mode {
            ModeName::Yaw => Self::Yaw,
            ModeName::Sway => Self::Sway,
            ModeName::PitchInPhase => Self::PitchInPhase,
            ModeName::PitchOutOfPhase => Self::PitchOutOfPhase,
            ModeName::RollInPhase => Self::RollInPhase,
            ModeName::RollOutOfPhase => Self::RollOutOfPhase,
            ModeName::Compound => Self::Compound,
            ModeName::Other => Self::Other,
        }
    }
}
