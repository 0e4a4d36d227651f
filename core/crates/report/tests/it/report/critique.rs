//! The part on what the simulation gets wrong: what it says, which figures head the report, and
//! that no data break it.

use gyradius_diagnosis::{Criticism, Critique, Status, SwingTrace};
use gyradius_report::{ReportSource, figures, html};

use crate::report::degenerate::{BAD, assert_finite};
use crate::report::samples::{ambiguous, keelboat, unexplained};
use crate::report::well_formed::assert_well_formed;

fn criticised(criticism: Criticism) -> ReportSource {
    ReportSource {
        criticism: Some(Ok(criticism)),
        ..keelboat()
    }
}

/// The keelboat's report with one thing of its criticism changed.
fn changed(change: impl Fn(&mut Critique)) -> ReportSource {
    let mut criticism = ambiguous();
    change(&mut criticism.critique);
    criticised(criticism)
}

#[test]
fn the_page_is_well_formed_and_loads_nothing() {
    for (name, criticism) in [("ambiguous", ambiguous()), ("unexplained", unexplained())] {
        let page = html(&criticised(criticism));
        let file = format!("report-critique-{name}.html");
        std::fs::write(
            std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(file),
            &page,
        )
        .expect("written");
        assert_well_formed(&page);
        for address in ["src=", "href=", "url(", "@import"] {
            assert!(!page.contains(address), "{name} loads {address}");
        }
    }
}

#[test]
fn verdict_causes_and_next_swing_are_said() {
    let page = html(&criticised(ambiguous()));
    for text in [
        "What the simulation gets wrong, and why",
        "<strong>Ambiguous</strong>. A drag with the square of the velocity accounts",
        "Quadratic drag (in the extended simulation)",
        "Power law damping (cannot be told apart)",
        "62.0 %",
        "under 0.1 %",
        "+5120",
        "−3.2",
        "yaw torque coefficient 12.10 ± 0.30 N m s²",
        "surge force coefficient not determined",
        "yaw not determined",
        "The drag grows with a power of the velocity: exponent 0.910 ± 0.080; yaw 4.40 ± 0.20 N m s",
        "The swing pitch-1 is shorter than the beat of its modes",
        "9.66 times smaller",
        "0.0123 rad/s",
        "And 1 more, in the data of this file",
        "Decay against amplitude",
        "+0.00250 m",
        "A yaw of 14° on lines of 2.5 m",
        "9.4 σ",
    ] {
        assert!(page.contains(text), "{text}");
    }
    assert!(
        !page.contains("the eleventh and the least</td>"),
        "only ten discrepancies have a row"
    );
}

#[test]
fn a_learned_force_is_shown() {
    let source = criticised(unexplained());
    let page = html(&source);
    for text in [
        "<strong>Unexplained</strong>",
        "Nothing known (in the extended simulation)",
        "A spring that is stiffer to one side",
        "<strong>torque = -18.4 angle + 82 angle^2</strong>",
        "1.05 with the learned force, 1.07 with the equation",
        "over 99.9 %",
    ] {
        assert!(page.contains(text), "{text}");
    }
    let force = figures(&source)
        .into_iter()
        .find(|figure| figure.id == "critique-force")
        .expect("drawn");
    for label in [
        "torque about the vertical, N m",
        "angle, rad",
        "turn rate, rad/s",
        "time, s",
    ] {
        assert!(force.svg.contains(label), "{label}");
    }
    // Seven points on each of three axes.
    assert_eq!(force.svg.matches("<circle").count(), 21);
}

#[test]
fn the_extended_figures_head_the_report() {
    let page = html(&criticised(ambiguous()));
    let result = &page[..page.find("id=\"method\"").expect("the next section")];
    for text in [
        // 1.0591 ± 0.0010 in place of 1.05660 ± 0.00093, which stands beside it.
        "<td class=\"value\">1.0591 ± 0.0010 m</td>",
        "<td class=\"base\">1.05660 ± 0.00093 m</td>",
        "<td class=\"value\">1.0640 ± 0.0012 m</td>",
        "<td class=\"base\">1.0610 ± 0.0012 m</td>",
        // The pitch gyradius has no extended figure.
        "<td class=\"value\">1.1560 ± 0.0031 m</td>",
        "By the base simulation.",
        // (1.0591 − 1.055) / 0.0010 = 4.1 > 1.645 would pass; by the base figure it was undecided, and
        // the criticism is ambiguous.
        "<strong>Undecided</strong>: yaw gyradius asked to be at least 1.055 m, measured 1.0591 ± 0.0010 m",
    ] {
        assert!(result.contains(text), "{text}");
    }
    assert!(
        page.contains("without the causes that the criticism found"),
        "of the budget"
    );
}

#[test]
fn the_base_figures_head_the_report_where_nothing_is_missing() {
    let source = changed(|critique| critique.verdict.status = Status::Adequate);
    let page = html(&source);
    assert!(page.contains("<strong>Nothing is missing</strong>"));
    assert!(page.contains("<td class=\"value\">1.05660 ± 0.00093 m</td>"));
    assert!(!page.contains("<td class=\"base\">"));
    for text in [
        "without the causes that the criticism found",
        "times smaller",
        "The body before and after",
    ] {
        assert!(!page.contains(text), "{text}");
    }
}

#[test]
fn why_there_is_none_is_said() {
    let reason = "keelboat: the periods of these swings were typed in";
    let page = html(&ReportSource {
        criticism: Some(Err(reason.into())),
        ..keelboat()
    });
    assert!(page.contains(&format!(
        "There is no criticism of the simulation for this session: {reason}."
    )));
    assert!(page.contains("<td class=\"value\">1.05660 ± 0.00093 m</td>"));
    assert!(!page.contains("gyradius-critique"));
}

#[test]
fn nobody_asked() {
    assert!(!html(&keelboat()).contains("What the simulation gets wrong"));
}

#[test]
fn its_pictures_are_on_the_page() {
    let source = criticised(ambiguous());
    let page = html(&source);
    let all = figures(&source);
    for id in ["critique-causes", "critique-1-yaw-1", "critique-2-pitch-1"] {
        let figure = all
            .iter()
            .find(|figure| figure.id == id)
            .unwrap_or_else(|| panic!("{id}"));
        assert_well_formed(&figure.svg);
        assert!(page.contains(&figure.svg), "{id}");
    }
    let yaw = all
        .iter()
        .find(|figure| figure.id == "critique-1-yaw-1")
        .expect("drawn");
    assert!(yaw.svg.contains("left by the extended one"));
}

#[test]
fn one_simulation_is_drawn_once() {
    let mut criticism = ambiguous();
    for trace in &mut criticism.traces {
        trace.extended = trace.base.clone();
    }
    let page = html(&criticised(criticism));
    assert!(page.contains("left by the base simulation"));
    assert!(!page.contains("left by the extended one"));
}

#[test]
fn the_numbers_are_in_the_page_as_json() {
    let page = html(&criticised(ambiguous()));
    let tag = "id=\"gyradius-critique\">";
    let start = page.find(tag).expect("script") + tag.len();
    let json = &page[start..start + page[start..].find("</script>").expect("its end")];
    let read: Critique = serde_json::from_str(json).expect("JSON");
    assert_eq!(read, ambiguous().critique);
}

#[test]
fn text_from_outside_stays_text() {
    const ATTACK: &str =
        "</script><!--<script>alert('x')</script><img src=x onerror=alert(1)>\u{0}";
    let mut criticism = ambiguous();
    let critique = &mut criticism.critique;
    critique.verdict.message = ATTACK.into();
    critique.verdict.next_swing.as_mut().expect("one").message = ATTACK.into();
    critique.warnings.push(ATTACK.into());
    critique.causes[0].message = ATTACK.into();
    critique.discrepancies[0].swing = ATTACK.into();
    critique.learned = unexplained().critique.learned;
    critique.learned.as_mut().expect("one").equation = ATTACK.into();
    criticism.traces[0].swing = ATTACK.into();
    let page = html(&criticised(criticism));
    assert_well_formed(&page);
    for tag in ["<img", "<!--", "onerror=alert(1)>", "<script>", "\u{0}"] {
        assert!(!page.contains(tag), "{tag}");
    }
    let page = html(&ReportSource {
        criticism: Some(Err(ATTACK.into())),
        ..keelboat()
    });
    assert!(!page.contains("<img"));
}

#[test]
fn no_number_breaks_it() {
    for bad in BAD {
        let mut criticism = unexplained();
        let critique = &mut criticism.critique;
        for cause in &mut critique.causes {
            (cause.probability, cause.log_evidence_gain) = (bad, bad);
            cause
                .parameters
                .values_mut()
                .for_each(|parameter| (parameter.value, parameter.u) = (bad, bad));
        }
        critique
            .discrepancies
            .iter_mut()
            .for_each(|found| (found.size, found.sigma) = (bad, bad));
        for quantity in critique.extended.quantities.values_mut() {
            (quantity.value, quantity.u) = (bad.into(), bad.into());
        }
        critique.gain.heldout_rms_ratio = Some(bad);
        critique.baseline.rms_over_noise = Some(bad);
        let force = critique.learned.as_mut().expect("one");
        force.points.push([bad; 5]);
        force.points[0] = [bad, 1.0, bad, 1.0, bad];
        assert_finite(&criticised(criticism), "bad numbers");
        for trace in [
            SwingTrace {
                noise: bad,
                ..ambiguous().traces[0].clone()
            },
            SwingTrace {
                measured: vec![bad; 50],
                ..ambiguous().traces[0].clone()
            },
            SwingTrace {
                t_s: vec![bad; 3],
                ..ambiguous().traces[0].clone()
            },
            SwingTrace {
                base: vec![bad],
                extended: vec![],
                ..ambiguous().traces[0].clone()
            },
        ] {
            assert_finite(
                &criticised(Criticism {
                    traces: vec![trace],
                    ..ambiguous()
                }),
                "a bad trace",
            );
        }
    }
    let empty = Criticism {
        traces: vec![SwingTrace::default()],
        ..Default::default()
    };
    assert_finite(&criticised(empty), "nothing at all");
}
