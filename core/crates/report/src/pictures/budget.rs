//! Where the uncertainty of each quantity comes from, as bars.

use super::Figure;
use crate::chart::{self, WIDTH, colour, rectangle, shortened, text};
use crate::digits::{decimals_for, joined, prefix};
use crate::markup::Markup;
use crate::words;
use gyradius_identification::{BudgetLine, Measurement};

const MOST_BARS: usize = 8;
const ROW: f64 = 32.0;
const BAR: f64 = 9.0;
const VALUE_WIDTH: f64 = 84.0;

/// One picture for each quantity with a budget, in the order of the report.
pub(crate) fn budgets(measurement: &Measurement) -> Vec<Figure> {
    let mut keys: Vec<&String> = measurement.budget.keys().collect();
    keys.sort_by_key(|key| (words::rank(key), key.to_string()));
    keys.into_iter()
        .filter_map(|key| picture(measurement, key))
        .collect()
}

fn picture(measurement: &Measurement, key: &str) -> Option<Figure> {
    let lines = shown(measurement.budget.get(key)?);
    let largest = lines
        .iter()
        .map(|line| line.u_contribution)
        .fold(0.0, f64::max);
    if largest <= 0.0 {
        return None;
    }
    let total = measurement.quantities.get(key).and_then(|q| q.u.scalar());
    let scale = total
        .filter(|u| u.is_finite())
        .unwrap_or(largest)
        .max(largest);
    let unit = Unit::of(scale, words::unit_of(key));
    let mut body = Markup::default();
    for (i, line) in lines.iter().enumerate() {
        draw_bar(&mut body, ROW * i as f64, line, scale, &unit, colour::MODEL);
    }
    let mut height = ROW * lines.len() as f64;
    if let Some(u_contribution) = total {
        let whole = BudgetLine {
            input: "together (standard uncertainty u)".into(),
            u_contribution,
        };
        draw_bar(&mut body, height + 4.0, &whole, scale, &unit, colour::INK);
        height += ROW + 4.0;
    }
    let title = format!("Budget of the {}", lower(&words::quantity_name(key)));
    let caption = format!(
        "Contributions of the inputs to u, in {}.",
        if unit.name.is_empty() {
            "1"
        } else {
            &unit.name
        }
    );
    let svg = chart::svg(&title, height + 4.0, body);
    Some(Figure::new(&format!("budget-{key}"), title, caption, svg))
}

fn lower(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_lowercase().chain(letters).collect()
    })
}

/// The largest lines; the rest together as one.
fn shown(all: &[BudgetLine]) -> Vec<BudgetLine> {
    let mut lines: Vec<BudgetLine> = all
        .iter()
        .filter(|line| line.u_contribution.is_finite())
        .cloned()
        .collect();
    lines
        .iter_mut()
        .for_each(|line| line.u_contribution = line.u_contribution.abs());
    lines.sort_by(|a, b| b.u_contribution.total_cmp(&a.u_contribution));
    if lines.len() > MOST_BARS {
        let rest = lines.split_off(MOST_BARS - 1);
        let squares: f64 = rest.iter().map(|line| line.u_contribution.powi(2)).sum();
        lines.push(BudgetLine {
            input: format!("{} smaller ones", rest.len()),
            u_contribution: squares.sqrt(),
        });
    }
    lines
}

fn draw_bar(out: &mut Markup, top: f64, line: &BudgetLine, scale: f64, unit: &Unit, fill: &str) {
    let label = words::sentence_case(&words::spaced(&line.input));
    text(
        out,
        0.0,
        top + 13.0,
        "start",
        colour::INK,
        &shortened(&label, WIDTH - VALUE_WIDTH),
    );
    text(
        out,
        WIDTH,
        top + 13.0,
        "end",
        colour::MUTED,
        &unit.text(line.u_contribution),
    );
    rectangle(out, (0.0, top + 18.0), (WIDTH, BAR), "#eef1f4");
    rectangle(
        out,
        (0.0, top + 18.0),
        (WIDTH * line.u_contribution / scale, BAR),
        fill,
    );
}

/// Contributions in one unit, to the same digit.
struct Unit {
    factor: f64,
    name: String,
    places: usize,
}

impl Unit {
    fn of(scale: f64, unit: &str) -> Self {
        let (factor, letter) = if unit == "m" {
            prefix(scale)
        } else {
            (1.0, "")
        };
        Self {
            factor,
            name: format!("{letter}{unit}"),
            places: decimals_for(scale * factor),
        }
    }

    fn text(&self, value: f64) -> String {
        joined(
            &format!("{:.*}", self.places, value * self.factor),
            &self.name,
        )
    }
}
