//! Figures taken away from the instruments that they were read with.

use super::quantity::Quantity;
use super::session::{InclineAngle, Session, SwingData};

impl Session {
    /// The same session without instruments: every figure has all of its uncertainty in its own, so
    /// that it can be put where the instruments are not known. What readings shared is no longer
    /// told.
    pub fn without_instruments(&self) -> Session {
        let mut alone = self.clone();
        let whole = |key: String, figure: &mut Quantity| *figure = self.reading(&key, *figure);
        if let Some(mass) = &mut alone.body.mass_kg {
            whole("body.mass".to_owned(), mass);
        }
        for (i, one) in alone.attachments.iter_mut().enumerate() {
            whole(format!("attachment[{}].mass", i + 1), &mut one.mass_kg);
        }
        for (i, one) in alone.swings.iter_mut().enumerate() {
            let of = |key: &str| format!("swing[{}].{key}", i + 1);
            for key in one.suspension.kind.figures() {
                let home = self.measured_at(i, key) + 1;
                if let Some(mut figure) = one.suspension.figure(key) {
                    whole(format!("swing[{home}].suspension.{key}"), &mut figure);
                    one.suspension.set_figure(key, Some(figure));
                }
            }
            for (j, added) in one.added_masses.iter_mut().enumerate() {
                let key = of(&format!("added_mass[{}].mass", j + 1));
                whole(key, &mut added.mass_kg);
            }
            if let SwingData::PeriodsS(periods) = &mut one.data {
                for (mode, period) in periods {
                    whole(of(&format!("periods_s.{}", mode.name())), period);
                }
            }
        }
        for (i, one) in alone.inclines.iter_mut().enumerate() {
            let of = |key: &str| format!("incline[{}].{key}", i + 1);
            whole(of("mass"), &mut one.mass_kg);
            whole(of("arm"), &mut one.arm_m);
            whole(of("depth"), &mut one.depth_m);
            if let InclineAngle::Stated(angle) = &mut one.angle {
                whole(of("angle_deg"), angle);
            }
        }
        alone.instruments.clear();
        alone.read_with.clear();
        alone
    }
}

#[cfg(test)]
mod tests {
    use crate::{read_session, write_session};

    const SESSION: &str = r#"
format = "gyradius-session/1"
[body]
mass = { value = 300.0, u = 0.3, instrument = "scale" }
[[attachment]]
mass = { value = 40.0, u = 0.3, instrument = "scale" }
position = [0.0, 0.0, 0.0]
[[swing]]
id = "table"
periods_s = { yaw = { value = 4.0, u = 0.003, instrument = "clock" } }
added_mass = [{ mass = { value = 4.0, u = 0.3, instrument = "scale" }, position = [1.0, 0.0, 0.0] }]
[swing.suspension]
kind = "trifilar"
line_length = { value = 3.0, u = 0.003, instrument = "tape" }
radius = { value = 0.4, u = 0.003, instrument = "tape" }
top_radius = { value = 0.4, u = 0.003 }
hull_pitch_deg = { value = 4.0, u = 0.3, instrument = "angles" }
[[incline]]
end = "bow"
mass = { value = 4.0, u = 0.3, instrument = "scale" }
arm = { value = 3.0, u = 0.003, instrument = "tape" }
depth = { value = 0.0, u = 0.003, instrument = "tape" }
angle_deg = { value = 4.0, u = 0.3, instrument = "angles" }
[[instrument]]
id = "scale"
kind = "scale"
zero_u = 0.4
[[instrument]]
id = "tape"
kind = "tape"
zero_u = 0.004
[[instrument]]
id = "clock"
kind = "clock"
zero_u = 0.004
[[instrument]]
id = "angles"
kind = "protractor"
zero_u = 0.4
"#;

    /// Of every figure that can name an instrument: 0.3 of its own and 0.4 of the instrument are 0.5.
    #[test]
    fn every_figure_keeps_all_of_its_uncertainty() {
        let session = read_session(SESSION, "session.toml").unwrap();
        assert_eq!(session.read_with.len(), 11);
        let alone = write_session(&session.without_instruments());
        let (mut whole, mut own) = (0, 0);
        for line in alone.lines() {
            whole += usize::from(line.contains("u = 0.5 ") || line.contains("u = 0.005 "));
            own += usize::from(line.contains("u = 0.3 ") || line.contains("u = 0.003 "));
        }
        // The radius above names none.
        assert_eq!((whole, own), (11, 1), "{alone}");
        assert!(!alone.contains("instrument"), "{alone}");
    }
}
