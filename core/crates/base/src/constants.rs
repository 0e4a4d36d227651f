//! Numerical constants, each with its source.

/// Standard acceleration of free fall, m/s² (3rd CGPM 1901; the paper's figures use it).
pub const STANDARD_GRAVITY_M_S2: f64 = 9.80665;

/// Relative standard uncertainty of a phone's clock. Quartz in phones is specified to ±20 ppm
/// (typical 32.768 kHz and TCXO data sheets); read as a rectangular distribution, u = 20 ppm / √3.
pub const PHONE_CLOCK_U_RELATIVE: f64 = 11.5e-6;
/// The same between two swings of a session: another phone, or the same one at another temperature
/// (tuning forks lose 0.035 ppm/K² either side of 25 °C).
pub const PHONE_CLOCK_BETWEEN_SWINGS_U_RELATIVE: f64 = PHONE_CLOCK_U_RELATIVE;
