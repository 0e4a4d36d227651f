//! The committed schemas are those of the types, and hold for what the program writes.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::fs;
use std::path::{Path, PathBuf};

use gyradius_core::schemas::{schemas, written};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/schemas")
}

/// `GYRADIUS_WRITE_SCHEMAS=1` writes them anew.
#[test]
fn committed_schemas_are_those_of_the_types() {
    let writes = std::env::var_os("GYRADIUS_WRITE_SCHEMAS").is_some();
    for (name, schema) in schemas() {
        let path = folder().join(format!("{name}.json"));
        let fresh = written(&schema).unwrap();
        if writes {
            fs::write(&path, &fresh).unwrap();
        }
        let kept = fs::read_to_string(&path).unwrap_or_default();
        assert!(
            kept == fresh,
            "{} is stale: `make schemas` writes it anew",
            path.display()
        );
    }
}

#[test]
fn no_schema_is_left_of_what_is_no_longer_written() {
    let known: Vec<String> = schemas()
        .iter()
        .map(|(name, _)| format!("{name}.json"))
        .collect();
    for entry in fs::read_dir(folder()).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        assert!(known.contains(&name), "{name} has no type");
    }
}
