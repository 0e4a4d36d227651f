//! A checker of markup: every tag closed in order, every attribute quoted, every entity known.

/// Panics with the place of the first fault.
pub fn assert_well_formed(document: &str) {
    let mut open: Vec<String> = Vec::new();
    let mut rest = document;
    while let Some(start) = rest.find('<') {
        assert_text(&rest[..start], &open);
        let end = start + rest[start..].find('>').unwrap_or(0);
        assert!(end > start, "tag without end: {:.80}", &rest[start..]);
        let tag = &rest[start + 1..end];
        rest = &rest[end + 1..];
        if tag.starts_with('!') {
            continue;
        }
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop().as_deref(), Some(name), "closed out of order");
            continue;
        }
        assert_attributes(tag);
        if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap_or_default().to_string());
        }
    }
    assert!(open.is_empty(), "left open: {open:?}");
}

fn assert_text(text: &str, open: &[String]) {
    if open.last().is_some_and(|name| name == "style") {
        return;
    }
    for (i, _) in text.match_indices('&') {
        let known = ["&amp;", "&lt;", "&gt;", "&quot;", "&#39;"];
        assert!(
            known.iter().any(|entity| text[i..].starts_with(entity)),
            "stray & in {text:?}"
        );
    }
}

fn assert_attributes(tag: &str) {
    let quotes = tag.matches('"').count();
    assert_eq!(quotes % 2, 0, "unquoted attribute in <{tag}>");
    let outside: String = tag.split('"').step_by(2).collect();
    assert!(!outside.contains('\''), "<{tag}>");
}

#[test]
fn faults_are_found() {
    assert_well_formed("<!DOCTYPE html><a b=\"c\"><br/>x &amp; y</a>");
    for fault in ["<a>", "<a></b>", "<a b=\"></a>", "<a>&nbsp;</a>", "<a"] {
        assert!(
            std::panic::catch_unwind(|| assert_well_formed(fault)).is_err(),
            "{fault}"
        );
    }
}
