//! Any text: an error or a session that survives writing and reading.
#![no_main]

use gyradius_core::recording::{read_session, write_session};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    if let Ok(session) = read_session(text, "session.toml") {
        let again = read_session(&write_session(&session), "session.toml");
        assert_eq!(again, Ok(session), "{}", text);
    }
});
