//! Consistency, budget and ellipsoids: parts that are mostly pictures.

use crate::digits::{joined, sigmas, with_u};
use crate::headline::Headline;
use crate::markup::Markup;
use crate::pictures;
use crate::source::ReportSource;
use crate::table::{figures, table};
use crate::words::{self, figure, plain, say};
use gyradius_base::language::Language;
use gyradius_identification::Claim;

pub(super) fn consistency(source: &ReportSource, out: &mut Markup) {
    let claims = &source.measurement.consistency;
    // Modes alone claim nothing.
    if claims.is_empty() && source.measurement.quantities.is_empty() {
        return;
    }
    out.folded("consistency", "consistency", |out| {
        if claims.is_empty() {
            out.element("p", &[], &out.say("consistency_empty"));
            return;
        }
        let flagged = claims.iter().filter(|claim| claim.flagged).count();
        out.element("p", &[], &verdict(claims.len(), flagged, out.language()));
        for claim in claims.iter().filter(|claim| claim.flagged) {
            out.element(
                "p",
                &[("class", "flagged")],
                &words::sentence_case(&claim.message.in_language(out.language())),
            );
        }
        figures(
            out,
            pictures::consistency(claims, out.language()).as_slice(),
        );
        let shown = claims.len().min(pictures::MOST_ROWS);
        let heads = ["claim", "stated_u", "implied_u", "difference", "implied_by"];
        let rows = claims[..shown]
            .iter()
            .map(|claim| row(claim, out.language()));
        let rows: Vec<Vec<String>> = rows.collect();
        table(out, &heads, &rows);
        if claims.len() > shown {
            let rest = plain((claims.len() - shown).to_string());
            let text = out.tell("claims_left_out", [("count", rest)]);
            out.element("p", &[("class", "note")], &text);
        }
    });
}

fn verdict(count: usize, flagged: usize, language: Language) -> String {
    let compared = match count {
        1 => say(language, "compared_one", []),
        n => say(language, "compared", [("count", plain(n.to_string()))]),
    };
    let differing = match flagged {
        0 => say(language, "none_differs", []),
        1 => say(language, "one_differs", []),
        n => say(language, "some_differ", [("count", plain(n.to_string()))]),
    };
    format!("{compared} {differing}")
}

fn row(claim: &Claim, language: Language) -> Vec<String> {
    let unit = claim.claim.unit();
    let number = |text: &str| language.number(text);
    let sigma = match claim.sigma_range {
        None => number(&format!("{} σ", sigmas(claim.sigma))),
        Some([least, most]) => say(
            language,
            "sigma_range",
            [
                ("least", figure(sigmas(least))),
                ("most", figure(sigmas(most))),
                ("pairs", plain(claim.pairs.to_string())),
            ],
        ),
    };
    let difference = match claim.flagged {
        true => say(language, "contradiction", [("sigma", plain(sigma))]),
        false => sigma,
    };
    vec![
        words::sentence_case(&words::claim_name(&claim.claim, language)),
        number(&joined(&with_u(claim.stated, claim.stated_u), unit)),
        number(&joined(&with_u(claim.implied, claim.implied_u), unit)),
        difference,
        words::sentence_case(&words::claim_from(claim, language)),
    ]
}

pub(super) fn budget(source: &ReportSource, out: &mut Markup) {
    let pictures = pictures::budgets(&source.measurement, source.language);
    if pictures.is_empty() {
        return;
    }
    out.folded("budget", "budget", |out| {
        out.element("p", &[], &out.say("budget_read"));
        if !Headline::of(source).replaced.is_empty() {
            out.element("p", &[("class", "note")], &out.say("budget_base"));
        }
        figures(out, &pictures);
    });
}

pub(super) fn ellipsoids(source: &ReportSource, out: &mut Markup) {
    let quantities = Headline::of(source).quantities;
    if quantities.is_empty() {
        return;
    }
    out.folded(
        "ellipsoids",
        "ellipsoids",
        |out| match pictures::no_ellipsoid_reason(&quantities, source.language) {
            Some(reason) => out.element("p", &[], &reason),
            None => figures(out, &pictures::ellipsoids(&quantities, source.language)),
        },
    );
}
