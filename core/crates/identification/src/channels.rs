//! The channels of a record by sensor, as a swing is looked for in them.

use crate::modes::ChannelMap;
use gyradius_recording::{Recording, Sensor, SensorChannels, Track};
use gyradius_signal::ChannelGroup;

/// A phone's channels by sensor, with their names.
#[derive(Default)]
pub(super) struct Channels {
    pub groups: Vec<ChannelGroup>,
    /// Counted through all groups: `gx`, `rate`, `y`.
    pub names: Vec<&'static str>,
    /// Which of them are those of a whole sensor.
    pub map: ChannelMap,
}

impl Channels {
    /// The gyroscope first, then the accelerometer with more axes, of two alike the one that sees
    /// gravity.
    pub fn of(recording: &Recording) -> Self {
        let sensors = recording.sensors();
        let is_force = |one: &&SensorChannels| {
            let forces = [Sensor::Accelerometer, Sensor::LinearAccelerometer];
            forces.contains(&one.sensor)
        };
        let forces = sensors.iter().rev().filter(is_force);
        let force = forces.max_by_key(|one| one.channels.len());
        let others = sensors.iter().filter(|one| !is_force(one));
        let mut all = Self::default();
        others.chain(force).for_each(|one| all.add(one));
        all
    }

    fn add(&mut self, sensor: &SensorChannels) {
        let whole = (sensor.channels.len() == 3).then_some(self.names.len());
        match sensor.sensor {
            Sensor::Gyroscope => self.map.gyroscope = whole,
            Sensor::Accelerometer => self.map.accelerometer = whole,
            Sensor::LinearAccelerometer => {
                self.map.accelerometer = whole;
                self.map.gravity_free = true;
            }
            Sensor::Displacement | Sensor::Timer => {}
        }
        let samples = sensor.channels.iter().map(|(_, samples)| samples.to_vec());
        self.groups.push(ChannelGroup {
            t_s: sensor.t_s.to_vec(),
            channels: samples.collect(),
        });
        let names = sensor.channels.iter().map(|(name, _)| *name);
        self.names.extend(names);
    }

    /// The only channel of a track.
    pub fn of_track(track: &Track) -> Self {
        Self {
            groups: vec![ChannelGroup {
                t_s: track.t_s.clone(),
                channels: vec![track.y_m.clone()],
            }],
            names: vec!["y"],
            map: ChannelMap::default(),
        }
    }
}
