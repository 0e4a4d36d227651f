//! Any text: an error or a rig whose session survives writing and reading.
#![no_main]

use gyradius_core::simulator::read_rig;
use gyradius_core::recording::{read_session, write_session};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    if let Ok(rig) = read_rig(text, "rig.toml") {
        let again = read_session(&write_session(&rig.session), "session.toml");
        assert_eq!(again, Ok(rig.session), "{}", text);
    }
});
