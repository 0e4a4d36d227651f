//! The criticism of sessions that hold periods alone.
#![allow(clippy::unwrap_used)]

use gyradius_core::critique::{Critique, criticise_periods};
use gyradius_core::inertia::{MeasureOptions, analyse};
use gyradius_core::recording::{LoadedSession, load_session};

fn criticised(loaded: &LoadedSession) -> Critique {
    let analysis = analyse(loaded, &MeasureOptions::default()).unwrap();
    criticise_periods(loaded, &analysis).unwrap().critique
}

fn shipped(name: &str) -> LoadedSession {
    load_session(format!("{}/../python/gyradius/sessions/{name}", env!("CARGO_MANIFEST_DIR"))).unwrap()
}

#[test]
fn look() {
    for name in ["keelboat", "model-hull"] {
        let start = std::time::Instant::now();
        let critique = criticised(&shipped(name));
        println!("{}", serde_json::to_string_pretty(&critique).unwrap());
        println!("{name} {:?}", start.elapsed());
    }
}
