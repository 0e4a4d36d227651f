//! What is at hand: room for the lines, tape, phone.

use serde::{Deserialize, Serialize};

use gyradius_base::constants::STANDARD_GRAVITY_M_S2;
use gyradius_base::error::{Error, Result};
use gyradius_recording::Quantity;

/// What is at hand. Every field has a default, so that a request need only say what differs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Means {
    /// Room for the lines, between what they hang from and the suspension points on the hull, m.
    pub most_line_length_m: f64,
    /// The shortest lines that can be rigged, m.
    pub least_line_length_m: f64,
    /// The widest spacing of the points; a little more than the beam where nothing is said, m.
    pub most_spacing_m: Option<f64>,
    /// The narrowest; six tenths of the beam where nothing is said, m.
    pub least_spacing_m: Option<f64>,
    /// Standard uncertainty of a line's measured length, m.
    pub u_line_length_m: f64,
    /// Standard uncertainty of a spacing, m.
    pub u_spacing_m: f64,
    /// Standard uncertainty of the level of the hull, degrees.
    pub u_hull_pitch_deg: f64,
    /// Acceleration of free fall, m/s².
    pub gravity_m_s2: Quantity,
    /// White noise of each axis of the gyroscope, rad/s.
    pub gyro_noise_rad_s: f64,
    /// White noise of each axis of the accelerometer, m/s².
    pub acc_noise_m_s2: f64,
    /// Samples per second.
    pub rate_hz: f64,
    /// Decay time of the motions, s.
    pub decay_s: f64,
    /// Angle of a release, degrees.
    pub amplitude_deg: f64,
    /// Lengths of a recording, s.
    pub least_duration_s: f64,
    /// The longest recording, s.
    pub most_duration_s: f64,
}

impl Default for Means {
    fn default() -> Self {
        Self {
            most_line_length_m: 3.0,
            least_line_length_m: 0.3,
            most_spacing_m: None,
            least_spacing_m: None,
            // A steel tape in a boat park; the paper's lines were measured to 6 mm.
            u_line_length_m: 0.003,
            u_spacing_m: 0.001,
            // A spirit level and an eye.
            u_hull_pitch_deg: 0.2,
            // Anywhere on Earth, as a measurement without gravity or latitude takes it.
            gravity_m_s2: Quantity::new(STANDARD_GRAVITY_M_S2, 0.015),
            gyro_noise_rad_s: 0.002,
            acc_noise_m_s2: 0.02,
            rate_hz: 100.0,
            // The paper's keelboat: 640 s in yaw, 124 s in sway.
            decay_s: 200.0,
            // Small enough for air and bearings to matter little, far above a phone's noise.
            amplitude_deg: 5.0,
            least_duration_s: 120.0,
            most_duration_s: 600.0,
        }
    }
}

impl Means {
    /// Refuses what is no length, no noise or no angle.
    ///
    /// # Errors
    /// [`Error::Argument`] that names the field.
    pub fn checked(&self) -> Result<()> {
        let positive = [
            ("most_line_length_m", self.most_line_length_m),
            ("least_line_length_m", self.least_line_length_m),
            ("most_spacing_m", self.most_spacing_m.unwrap_or(1.0)),
            ("least_spacing_m", self.least_spacing_m.unwrap_or(1.0)),
            ("u_line_length_m", self.u_line_length_m),
            ("u_spacing_m", self.u_spacing_m),
            ("u_hull_pitch_deg", self.u_hull_pitch_deg),
            ("gravity_m_s2", self.gravity_m_s2.value),
            ("gyro_noise_rad_s", self.gyro_noise_rad_s),
            ("acc_noise_m_s2", self.acc_noise_m_s2),
            ("rate_hz", self.rate_hz),
            ("decay_s", self.decay_s),
            ("amplitude_deg", self.amplitude_deg),
            ("least_duration_s", self.least_duration_s),
            ("most_duration_s", self.most_duration_s),
        ];
        if let Some((name, value)) = positive
            .into_iter()
            .find(|(_, v)| !(v.is_finite() && *v > 0.0))
        {
            return Err(Error::argument(name, "a positive number", value));
        }
        if !(self.gravity_m_s2.u.is_finite() && self.gravity_m_s2.u >= 0.0) {
            return Err(Error::argument(
                "gravity_m_s2",
                "an uncertainty of 0 or more",
                self.gravity_m_s2.u,
            ));
        }
        let at_most = |name: &str, limit: f64, value: f64| {
            let unit = name.rsplit('_').next().unwrap_or_default();
            if value > limit {
                Err(Error::argument(
                    name,
                    format!("at most {limit} {unit}"),
                    value,
                ))
            } else {
                Ok(())
            }
        };
        at_most("amplitude_deg", 170.0, self.amplitude_deg)?;
        at_most("most_duration_s", 3600.0, self.most_duration_s)?;
        at_most(
            "least_line_length_m",
            self.most_line_length_m,
            self.least_line_length_m,
        )?;
        at_most(
            "least_duration_s",
            self.most_duration_s,
            self.least_duration_s,
        )?;
        let (least, most) = (
            self.least_spacing_m.unwrap_or(0.0),
            self.most_spacing_m.unwrap_or(f64::INFINITY),
        );
        at_most("least_spacing_m", most, least)
    }

    /// Narrowest and widest spacing for a beam, m.
    pub fn spacings_m(&self, beam_m: f64) -> (f64, f64) {
        // A frame that stands out a little (the paper beside Table 4: only slightly more than the
        // beam).
        const LEAST_OF_BEAM: f64 = 0.6;
        const MOST_OF_BEAM: f64 = 1.25;
        let most = self
            .most_spacing_m
            .unwrap_or((MOST_OF_BEAM * beam_m).max(self.least_spacing_m.unwrap_or(0.0)));
        let least = self
            .least_spacing_m
            .unwrap_or((LEAST_OF_BEAM * beam_m).min(most));
        (least, most)
    }
}
