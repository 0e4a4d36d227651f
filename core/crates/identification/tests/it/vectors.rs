//! Runs every file of `tests/vectors` through the one door, as Python, Kotlin and Swift do.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::PathBuf;

use gyradius_base::Error;
use gyradius_identification::routes::{catalogue, evaluate};
use serde::Deserialize;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct VectorFile {
    algorithm: String,
    #[allow(dead_code)]
    equation: String,
    number_of_tests: usize,
    flags: BTreeMap<String, String>,
    tests: Vec<Case>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Case {
    id: String,
    comment: String,
    flags: Vec<String>,
    source: String,
    inputs: BTreeMap<String, f64>,
    result: String,
    #[serde(default)]
    expected: BTreeMap<String, String>,
    #[serde(default)]
    tolerance: BTreeMap<String, Tolerance>,
    #[serde(default)]
    error: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Tolerance {
    #[serde(default)]
    abs: f64,
    #[serde(default)]
    rel: f64,
    reason: String,
}

fn files() -> Vec<(String, VectorFile)> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../../tests/vectors");
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_string_lossy().into_owned();
        if path.extension().is_some_and(|e| e == "json") && name != "schema" {
            let text = fs::read_to_string(&path).unwrap();
            files.push((
                name.clone(),
                serde_json::from_str(&text).unwrap_or_else(|e| panic!("{name}: {e}")),
            ));
        }
    }
    files
}

/// What is wrong with a case, if anything.
fn misses(algorithm: &str, case: &Case) -> Vec<String> {
    match (evaluate(algorithm, &case.inputs), case.result.as_str()) {
        (Ok(found), "valid") => case
            .expected
            .iter()
            .filter_map(|(key, text)| off(key, text, &found, case))
            .collect(),
        (Err(error), "invalid") => {
            let kind = match error {
                Error::Argument { .. } => "argument",
                Error::NoResult { .. } => "no_result",
                _ => "other",
            };
            let wanted = case.error.as_deref();
            if wanted == Some(kind) {
                vec![]
            } else {
                vec![format!("error {kind}, wanted {wanted:?}: {error}")]
            }
        }
        (Ok(found), _) => vec![format!("must be rejected, gave {found:?}")],
        (Err(error), _) => vec![format!("must be accepted, gave: {error}")],
    }
}

fn off(key: &str, text: &str, found: &BTreeMap<String, f64>, case: &Case) -> Option<String> {
    let Some(value) = found.get(key) else {
        return Some(format!("no output {key}"));
    };
    let Some(tolerance) = case.tolerance.get(key) else {
        return Some(format!("no tolerance for {key}"));
    };
    if tolerance.reason.is_empty() {
        return Some(format!("no reason for the tolerance of {key}"));
    }
    let expected: f64 = text.parse().unwrap();
    let allowed = tolerance.abs + tolerance.rel * expected.abs();
    let miss = (value - expected).abs();
    // Written so that a NaN fails.
    if miss <= allowed {
        None
    } else {
        Some(format!(
            "{key}: {value}, expected {expected} within {allowed:e}"
        ))
    }
}

#[test]
fn every_case_of_every_file_holds() {
    let files = files();
    let (mut ran, mut failures) = (0, Vec::new());
    for (name, file) in &files {
        assert_eq!(name, &file.algorithm, "a file is named for its algorithm");
        assert_eq!(
            file.number_of_tests,
            file.tests.len(),
            "{name}: number_of_tests"
        );
        for case in &file.tests {
            failures.extend(
                misses(name, case)
                    .into_iter()
                    .map(|m| format!("{}: {m} ({})", case.id, case.comment)),
            );
            ran += 1;
        }
    }
    let written: usize = files.iter().map(|(_, file)| file.number_of_tests).sum();
    assert_eq!(ran, written);
    println!("{ran} cases of {} vector files ran", files.len());
    assert!(
        failures.is_empty(),
        "{} misses:\n{}",
        failures.len(),
        failures.join("\n")
    );
}

#[test]
fn ids_are_unique_flags_are_explained_and_sources_stated() {
    let mut ids = BTreeSet::new();
    for (name, file) in files() {
        for case in file.tests {
            assert!(ids.insert(case.id.clone()), "{} stands twice", case.id);
            assert!(case.id.starts_with(&name), "{} belongs to {name}", case.id);
            assert!(!case.source.is_empty(), "{}: no source", case.id);
            assert!(
                case.result != "valid" || !case.expected.is_empty(),
                "{}: expects nothing",
                case.id
            );
            for flag in &case.flags {
                assert!(
                    file.flags.contains_key(flag),
                    "{}: flag {flag} is not explained",
                    case.id
                );
            }
        }
    }
}

#[test]
fn every_route_has_vectors() {
    let with: BTreeSet<String> = files().into_iter().map(|(name, _)| name).collect();
    let without: Vec<_> = catalogue()
        .iter()
        .map(|r| r.name)
        .filter(|name| !with.contains(*name))
        .collect();
    assert!(without.is_empty(), "routes without vectors: {without:?}");
    assert_eq!(
        with.len(),
        catalogue().len(),
        "a vector file without a route"
    );
}

#[test]
fn every_route_refuses_what_it_does_not_know() {
    for route in catalogue() {
        let stray = BTreeMap::from([("stray".to_string(), 1.0)]);
        assert!(
            matches!(evaluate(route.name, &stray), Err(Error::Argument { .. })),
            "{}",
            route.name
        );
        assert!(
            matches!(
                evaluate(route.name, &BTreeMap::new()),
                Err(Error::Argument { .. })
            ),
            "{}",
            route.name
        );
    }
    assert!(matches!(
        evaluate("yaw_gyradus", &BTreeMap::new()),
        Err(Error::Argument { .. })
    ));
}

/// Numbers from everywhere: an error or finite figures, never NaN, never a panic.
#[test]
fn no_route_panics_or_gives_nan() {
    use rand::RngExt;
    let mut rng = gyradius_test_support::rng();
    let odd = [
        0.0,
        -0.0,
        -1.0,
        1e-300,
        1e300,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1.0,
        0.5,
    ];
    for _ in 0..300 {
        for route in catalogue() {
            let mut inputs = BTreeMap::new();
            for slot in route.inputs {
                for n in if slot.name.contains('#') {
                    1..=3
                } else {
                    1..=1
                } {
                    let pick: f64 = rng.random();
                    let value = if pick < 0.15 {
                        odd[(pick * 66.0) as usize]
                    } else {
                        rng.random_range(-0.5..3.0)
                    };
                    inputs.insert(slot.name.replace('#', &n.to_string()), value);
                }
            }
            if let Ok(outputs) = evaluate(route.name, &inputs) {
                assert!(
                    outputs.values().all(|x| x.is_finite()),
                    "{}: {inputs:?} gave {outputs:?}",
                    route.name
                );
                assert_eq!(outputs.len(), route.outputs.len(), "{}", route.name);
            }
        }
    }
}
