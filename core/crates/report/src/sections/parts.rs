//! Court, budget and ellipsoids: parts that are mostly pictures.

use crate::digits::{joined, sigmas, with_u};
use crate::headline::Headline;
use crate::markup::Markup;
use crate::pictures;
use crate::source::ReportSource;
use crate::table::{figures, table};
use crate::words;
use gyradius_identification::Claim;

pub(super) fn court(source: &ReportSource, out: &mut Markup) {
    let claims = &source.measurement.consistency;
    // Modes alone claim nothing.
    if claims.is_empty() && source.measurement.quantities.is_empty() {
        return;
    }
    out.within("section", &[("id", "consistency")], |out| {
        out.element("h2", &[], "Does the session agree with itself?");
        if claims.is_empty() {
            out.element(
                "p",
                &[],
                "There was nothing to hold against one another: each figure was stated or implied once.",
            );
            return;
        }
        let flagged = claims.iter().filter(|claim| claim.flagged).count();
        out.element("p", &[], &verdict(claims.len(), flagged));
        for claim in claims.iter().filter(|claim| claim.flagged) {
            out.element("p", &[("class", "flagged")], &words::sentence_case(&claim.message.english));
        }
        figures(out, pictures::court(claims).as_slice());
        let shown = claims.len().min(pictures::MOST_ROWS);
        let heads = ["Claim", "Stated ± u", "Implied ± u", "Difference", "Implied by"];
        table(out, &heads, &claims[..shown].iter().map(row).collect::<Vec<_>>());
        if claims.len() > shown {
            let text = format!(
                "{} further comparisons differ by less; they are in the data of this file.",
                claims.len() - shown
            );
            out.element("p", &[("class", "note")], &text);
        }
    });
}

fn verdict(count: usize, flagged: usize) -> String {
    let compared = format!(
        "Every stated dimension was held against what the swings imply, and every route against every other: {count} {}.",
        if count == 1 {
            "comparison"
        } else {
            "comparisons"
        }
    );
    match flagged {
        0 => format!("{compared} None differs by more than three standard uncertainties."),
        1 => format!("{compared} One differs by more than three standard uncertainties:"),
        n => format!("{compared} {n} differ by more than three standard uncertainties:"),
    }
}

fn row(claim: &Claim) -> Vec<String> {
    let unit = words::claim_unit(&claim.claim);
    let flag = if claim.flagged {
        " – contradiction"
    } else {
        ""
    };
    let sigma = match claim.sigma_range {
        None => format!("{} σ", sigmas(claim.sigma)),
        Some([least, most]) => {
            let pairs = claim.pairs;
            format!("{} to {} σ over {pairs} pairs", sigmas(least), sigmas(most))
        }
    };
    vec![
        words::sentence_case(&words::claim_name(&claim.claim)),
        joined(&with_u(claim.stated, claim.stated_u), unit),
        joined(&with_u(claim.implied, claim.implied_u), unit),
        format!("{sigma}{flag}"),
        words::sentence_case(&claim.from),
    ]
}

pub(super) fn budget(source: &ReportSource, out: &mut Markup) {
    let pictures = pictures::budgets(&source.measurement);
    if pictures.is_empty() {
        return;
    }
    out.within("section", &[("id", "budget")], |out| {
        out.element("h2", &[], "Where the uncertainty comes from");
        let text = "Each bar is an input's own uncertainty times the sensitivity of the result to it. Contributions add as \
                    squares: halving a bar that is half as long as the longest hardly helps.";
        out.element("p", &[], text);
        if !Headline::of(source).replaced.is_empty() {
            let text = "The bars are those of the fit without the causes that the criticism found.";
            out.element("p", &[("class", "note")], text);
        }
        figures(out, &pictures);
    });
}

pub(super) fn ellipsoids(source: &ReportSource, out: &mut Markup) {
    let quantities = Headline::of(source).quantities;
    if quantities.is_empty() {
        return;
    }
    out.within("section", &[("id", "ellipsoids")], |out| {
        out.element("h2", &[], "The inertia as a picture");
        match pictures::no_ellipsoid_reason(&quantities) {
            Some(reason) => out.element("p", &[], &reason),
            None => figures(out, &pictures::ellipsoids(&quantities)),
        }
    });
}
