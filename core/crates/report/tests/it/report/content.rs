//! What the report says, and how it treats text from outside.

use std::path::Path;

use gyradius_identification::{Input, InputKind, QuantityName, Subject};
use gyradius_report::{ReportSource, figures, html};

use crate::report::samples::{bare_recording, keelboat, yaw_only};
use crate::report::well_formed::assert_well_formed;

fn samples() -> [(&'static str, ReportSource); 4] {
    [
        ("keelboat", keelboat()),
        ("yaw-only", yaw_only()),
        ("bare", bare_recording()),
        ("empty", ReportSource::default()),
    ]
}

#[test]
fn every_sample_is_well_formed_and_loads_nothing() {
    for (name, source) in samples() {
        let page = html(&source);
        std::fs::write(
            Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("report-{name}.html")),
            &page,
        )
        .expect("written");
        assert_well_formed(&page);
        let without_names = page.replace("http://www.w3.org/2000/svg", "");
        for address in ["http:", "https:", "src=", "href=", "url(", "@import"] {
            assert!(!without_names.contains(address), "{name} loads {address}");
        }
    }
}

#[test]
fn every_quantity_is_there_with_the_digits_of_its_uncertainty() {
    let page = html(&keelboat());
    for text in [
        "1.05660 ± 0.00093 m",
        "1.1560 ± 0.0031 m",
        "0.6250 ± 0.0042 m",
        "0.923 ± 0.012 m",
        "5.5 ± 1.4°",
        "832.1 ± 4.5",
        "0.6180 ± 0.0043 m",
        "1.05478 … 1.05842",
    ] {
        assert!(page.contains(text), "{text}");
    }
}

#[test]
fn verdicts_contradictions_routes_and_repairs_are_said() {
    let page = html(&keelboat());
    for text in [
        "<strong>Pass</strong>: pitch gyradius asked to be at least 1.1 m, measured 1.1560 ± 0.0031 m",
        "<strong>Undecided</strong>",
        "<strong>Fail</strong>",
        "Line length is stated as 3.477 ± 0.006",
        "contradiction",
        "(5), (6)",
        "the gyroscope stood still from 71.0 s to 74.5 s",
        "Sway (not meant)",
        "3.4770 ± 0.0060 m",
        "Signature",
    ] {
        assert!(page.contains(text), "{text}");
    }
}

/// The result heads the page; each other part folds.
#[test]
fn the_result_stands_open_and_the_rest_folds() {
    let page = html(&keelboat());
    let parts = page.matches("<details id=").count();
    assert_eq!(parts, page.matches("</details>").count());
    for id in [
        "method",
        "consistency",
        "budget",
        "recordings",
        "ellipsoids",
        "terms",
    ] {
        let part = format!("<details id=\"{id}\" class=\"part\"><summary><h2>");
        assert!(page.contains(&part), "{id}");
    }
    let (result, first) = (page.find("id=\"result\""), page.find("<details"));
    assert!(result.expect("a result") < first.expect("a part that folds"));
}

#[test]
fn the_rig_is_sketched_with_its_dimensions_and_says_who_recorded() {
    let page = html(&keelboat());
    for text in [
        "How it hung: yaw-1",
        "L: lines of 3.4770 ± 0.0060 m. s: 1.8000 ± 0.0010 m between the points.",
        "1.9000 ± 0.0010 m between the points above.",
        "Recorded by: Pixel 9, phyphox",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert!(!html(&bare_recording()).contains("How it hung"));
}

/// Lines of 3.477 m whose points are 1.9 m apart above and 1.8 m below drop by √(3.477² − 0.05²) m: the
/// sketch is to one scale.
#[test]
fn the_sketch_is_to_scale() {
    let all = figures(&keelboat());
    let sketch = all.iter().find(|figure| figure.id == "rig").expect("rig");
    // The two lines are the only ones of this width.
    let ends: Vec<[f64; 4]> = sketch
        .svg
        .split("<line ")
        .skip(1)
        .filter_map(|rest| rest.split("/>").next())
        .filter(|line| line.contains("stroke-width=\"1.4\""))
        .map(|line| {
            ["x1=\"", "y1=\"", "x2=\"", "y2=\""].map(|key| {
                let from = line.split(key).nth(1).expect("a number");
                let number = from.split('"').next().expect("a number");
                number.parse().expect("a number")
            })
        })
        .collect();
    let [[x1, y1, x2, y2], [right, ..]] = ends[..] else {
        panic!("two lines: {ends:?}")
    };
    let (top_m, drop_m) = (1.9, (3.477f64.powi(2) - 0.05f64.powi(2)).sqrt());
    let scale = (right - x1) / top_m;
    // Places have one decimal.
    assert!(((y2 - y1) - scale * drop_m).abs() < 0.3, "{ends:?}");
    assert!(((x2 - x1) - scale * 0.05).abs() < 0.2, "{ends:?}");
}

#[test]
fn what_is_not_known_is_said() {
    let page = html(&yaw_only());
    assert!(page.contains("here the roll and pitch gyradii are not"));
    assert!(page.contains("None differs by more than three"));
    assert!(html(&bare_recording()).contains("do not determine any inertia"));
}

#[test]
fn pictures_come_alone_with_unique_names() {
    let all = figures(&keelboat());
    let mut ids: Vec<&str> = all.iter().map(|figure| &*figure.id).collect();
    for id in [
        "rig",
        "consistency-tests",
        "budget-k-yaw-m",
        "yaw-1-fit-1",
        "yaw-1-fit-2",
        "yaw-1-spectrum",
        "ellipsoid-mass",
        "ellipsoid-inertia",
    ] {
        assert!(ids.contains(&id), "{id} among {ids:?}");
    }
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), all.len());
    for figure in &all {
        assert_well_formed(&figure.svg);
        assert!(figure.svg.starts_with("<svg xmlns=") && figure.svg.contains("viewBox="));
        assert!(
            html(&keelboat()).contains(&figure.svg),
            "{} is not on the page",
            figure.id
        );
    }
}

#[test]
fn text_from_outside_stays_text() {
    const ATTACK: &str =
        "</title></script><!--<script>alert('x' & \"y\")</script><img src=x onerror=alert(1)>\u{0}";
    let mut source = keelboat();
    let m = &mut source.measurement;
    m.title = ATTACK.into();
    m.warnings.push(ATTACK.into());
    m.swings[0].id = ATTACK.into();
    m.swings[0].repairs[0].text = ATTACK.into();
    m.swings[0].warnings.push(ATTACK.into());
    m.consistency[0].message = ATTACK.into();
    m.consistency[1].from = ATTACK.into();
    let quantity = QuantityName::small_period_of(ATTACK);
    m.consistency[2].claim = Subject::Quantity(quantity.clone());
    m.verdicts[0].quantity = quantity;
    if let Some(lines) = m.budget.get_mut("k_yaw_m") {
        lines[0].input = Input::of(InputKind::Mass, ATTACK);
    }
    source.body.name = ATTACK.into();
    source.measured_on = Some(ATTACK.into());
    source.generated_by = ATTACK.into();
    source.stated[0].what = ATTACK.into();
    source.recordings[0].id = ATTACK.into();
    source.recordings[0].traces[0].label = ATTACK.into();
    source.recordings[0].traces[0].unit = ATTACK.into();
    let page = html(&source);
    assert_well_formed(&page);
    for tag in ["<img", "<!--", "onerror=alert(1)>", "<script>"] {
        assert!(!page.contains(tag), "{tag}");
    }
    assert_eq!(page.matches("</script").count(), 1);
    assert!(!page.contains('\u{0}'));
}

#[test]
fn the_numbers_are_in_the_page_as_json() {
    let source = keelboat();
    let page = html(&source);
    let start = page.find("id=\"gyradius-measurement\">").expect("script")
        + "id=\"gyradius-measurement\">".len();
    let json = &page[start..start + page[start..].find("</script>").expect("its end")];
    let read: serde_json::Value = serde_json::from_str(json).expect("JSON");
    let written = serde_json::to_string(&source.measurement).expect("JSON");
    assert_eq!(
        read,
        serde_json::from_str::<serde_json::Value>(&written).expect("JSON")
    );
}

#[test]
fn the_same_source_gives_the_same_page() {
    assert_eq!(html(&keelboat()), html(&keelboat()));
}
