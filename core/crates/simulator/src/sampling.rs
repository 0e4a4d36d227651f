//! When the phone reads its sensors.

/// When the phone reads its sensors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sampling {
    /// Length of the recording, s.
    pub duration_s: f64,
    /// Samples per second.
    pub rate_hz: f64,
}

impl Sampling {
    /// The times, s, from 0 on.
    pub fn times_s(&self) -> Vec<f64> {
        let count = (self.duration_s * self.rate_hz).floor() as usize + 1;
        (0..count).map(|i| i as f64 / self.rate_hz).collect()
    }
}
