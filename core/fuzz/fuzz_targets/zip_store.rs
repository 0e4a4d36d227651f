//! Any bytes as an archive: an error, or names that stay inside it and a session that loads or is
//! refused.
#![no_main]

use gyradius_core::recording::{Store, load_store};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(store) = Store::from_zip_bytes("fuzz.zip", bytes) else {
        return;
    };
    for name in store.names().unwrap_or_default() {
        assert!(
            !name.starts_with('/')
                && !name.contains('\\')
                && name.split('/').all(|part| part != "..")
        );
    }
    let _ = load_store(&store);
});
