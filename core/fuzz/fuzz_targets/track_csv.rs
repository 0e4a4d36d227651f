//! A rangefinder's track from any bytes.
#![no_main]

use gyradius_core::recording::read_track;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(track) = read_track(bytes, "fuzz.csv") else {
        return;
    };
    assert!(track.t_s.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!(track.t_s.len(), track.y_m.len());
});
