//! Tables and figures as HTML.

use super::markup::Markup;
use super::pictures::Figure;

/// A table whose heads are texts of the report and whose rows become paragraphs on a narrow screen,
/// each cell behind its head.
pub(super) fn table(out: &mut Markup, heads: &[&str], rows: &[Vec<String>]) {
    let heads: Vec<String> = heads.iter().map(|head| out.say(head)).collect();
    out.within("div", &[("class", "scroll stacks")], |out| {
        grid(out, &heads, rows)
    });
}

/// A table that keeps its shape and scrolls sideways on a narrow screen.
pub(super) fn matrix(out: &mut Markup, heads: [&str; 4], rows: &[Vec<String>]) {
    out.within("div", &[("class", "scroll")], |out| {
        grid(out, &heads.map(String::from), rows)
    });
}

fn grid(out: &mut Markup, heads: &[String], rows: &[Vec<String>]) {
    out.within("table", &[], |out| {
        out.within("thead", &[], |out| {
            out.within("tr", &[], |out| {
                heads.iter().for_each(|head| out.element("th", &[], head))
            });
        });
        out.within("tbody", &[], |out| {
            rows.iter().for_each(|cells| row(out, heads, cells))
        });
    });
}

fn row(out: &mut Markup, heads: &[String], cells: &[String]) {
    out.within("tr", &[], |out| {
        cells
            .iter()
            .zip(heads)
            .for_each(|(text, head)| out.element("td", &[("data-head", head)], text));
    });
}

/// Figures side by side where there is room.
pub(super) fn figures(out: &mut Markup, figures: &[Figure]) {
    if figures.is_empty() {
        return;
    }
    out.within("div", &[("class", "figures")], |out| {
        figures.iter().for_each(|picture| figure(out, picture))
    });
}

fn figure(out: &mut Markup, figure: &Figure) {
    out.within("figure", &[("id", &figure.id)], |out| {
        out.element("h4", &[], &figure.title);
        out.picture(figure);
        out.element("figcaption", &[], &figure.caption);
    });
}

/// A list of sentences.
pub(super) fn list(out: &mut Markup, class: &str, items: &[String]) {
    if !items.is_empty() {
        out.within("ul", &[("class", class)], |out| {
            items.iter().for_each(|item| out.element("li", &[], item))
        });
    }
}
