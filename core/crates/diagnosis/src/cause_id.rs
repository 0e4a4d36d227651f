//! Which causes there are.

use gyradius_base::named;

named! {
    /// A cause of what the base simulation gets wrong: its name in the contract.
    CauseId: "cause" {
        /// Air that moves with the hull.
        AddedMass = "added_mass",
        /// Air that moves with the hull, the more the wider it swings.
        AmplitudeAddedMass = "amplitude_added_mass",
        /// Dry friction in the bearings.
        BearingFriction = "bearing_friction",
        /// The sensors' zeros drift as they warm up.
        BiasDrift = "bias_drift",
        /// The clock is fast or slow.
        ClockScale = "clock_scale",
        /// The gyroscope's scale is off.
        GyroScale = "gyro_scale",
        /// Something moves inside the hull.
        InternalMotion = "internal_motion",
        /// The lines lengthen under load.
        LineCreep = "line_creep",
        /// The lines stretch as springs.
        LineStretch = "line_stretch",
        /// The lines resist being twisted.
        LineTorsion = "line_torsion",
        /// The lines are not parallel.
        NonparallelLines = "nonparallel_lines",
        /// The centre of mass lies off the middle between the lines.
        OffCentreCm = "off_centre_cm",
        /// The phone's mount gives and rings.
        PhoneMountResonance = "phone_mount_resonance",
        /// The phone slipped on the hull.
        PhoneSlip = "phone_slip",
        /// The pitch goes with the yaw (Kane and Tseng); the base simulation has it, so that
        /// nothing here finds it.
        PitchCoupling = "pitch_coupling",
        /// A damping with a power of the velocity.
        PowerLawDamping = "power_law_damping",
        /// Bearings that spring before they slide.
        PreslidingBearing = "presliding_bearing",
        /// A drag with the square of the velocity.
        QuadraticDrag = "quadratic_drag",
        /// The restoring force hardens or softens otherwise than the suspension says.
        RestoringForce = "restoring_force",
        /// Readings beyond a sensor's range.
        Saturation = "saturation",
        /// Gravity is not as stated.
        StatedGravity = "stated_gravity",
        /// The lines are not as long as stated.
        StatedLength = "stated_length",
        /// The lines are not as far apart as stated.
        StatedSpacing = "stated_spacing",
        /// What the lines hang from moves.
        SupportCompliance = "support_compliance",
        /// One line is longer than the other.
        UnequalLines = "unequal_lines",
        /// What no known cause accounts for.
        Unknown = "unknown",
        /// Wind, steady or in gusts.
        Wind = "wind",
    }
}
