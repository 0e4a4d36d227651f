//! Where the uncertainty of each quantity comes from, as bars.

use super::Figure;
use crate::chart::{self, WIDTH, colour, rectangle, shortened, text};
use crate::digits::{decimals_for, joined, prefix};
use crate::markup::Markup;
use crate::words::{self, plain, say};
use gyradius_base::language::Language;
use gyradius_identification::{BudgetLine, Measurement, QuantityName};

const MOST_BARS: usize = 8;
const ROW: f64 = 32.0;
const BAR: f64 = 9.0;
const VALUE_WIDTH: f64 = 84.0;

/// One picture for each quantity with a budget, in the order of the report.
pub(crate) fn budgets(measurement: &Measurement, language: Language) -> Vec<Figure> {
    let mut keys: Vec<&QuantityName> = measurement.budget.keys().collect();
    keys.sort_by_key(|key| (words::rank(key), *key));
    keys.into_iter()
        .filter_map(|key| picture(measurement, key, language))
        .collect()
}

fn picture(measurement: &Measurement, key: &QuantityName, language: Language) -> Option<Figure> {
    let bars = shown(measurement.budget.get(key)?, language);
    let largest = bars.iter().map(|bar| bar.u).fold(0.0, f64::max);
    if largest <= 0.0 {
        return None;
    }
    let total = measurement.quantities.get(key).and_then(|q| q.u.scalar());
    let scale = total
        .filter(|u| u.is_finite())
        .unwrap_or(largest)
        .max(largest);
    let unit = Unit::of(scale, key.unit());
    let mut body = Markup::in_language(language);
    for (i, bar) in bars.iter().enumerate() {
        draw_bar(&mut body, ROW * i as f64, bar, scale, &unit, colour::MODEL);
    }
    let mut height = ROW * bars.len() as f64;
    if let Some(u) = total {
        let label = say(language, "together", []);
        let whole = Bar { label, u };
        draw_bar(&mut body, height + 4.0, &whole, scale, &unit, colour::INK);
        height += ROW + 4.0;
    }
    let quantity = plain(words::quantity_inside(key, language));
    let title = say(language, "budget_of", [("quantity", quantity)]);
    let unit = plain(match &*unit.name {
        "" => "1",
        name => name,
    });
    let caption = say(language, "contributions", [("unit", unit)]);
    let svg = chart::svg(&title, height + 4.0, body);
    Some(Figure::new(&format!("budget-{key}"), title, caption, svg))
}

/// A contribution with its name.
struct Bar {
    label: String,
    u: f64,
}

impl Bar {
    fn of(line: &BudgetLine, language: Language) -> Self {
        let name = line.input.message().in_language(language);
        Self {
            label: words::sentence_case(&words::spaced(&name)),
            u: line.u_contribution.abs(),
        }
    }
}

/// The largest lines; the rest together as one.
fn shown(all: &[BudgetLine], language: Language) -> Vec<Bar> {
    let mut bars: Vec<Bar> = all
        .iter()
        .filter(|line| line.u_contribution.is_finite())
        .map(|line| Bar::of(line, language))
        .collect();
    bars.sort_by(|a, b| b.u.total_cmp(&a.u));
    if bars.len() > MOST_BARS {
        let rest = bars.split_off(MOST_BARS - 1);
        let squares: f64 = rest.iter().map(|bar| bar.u.powi(2)).sum();
        let count = plain(rest.len().to_string());
        bars.push(Bar {
            label: say(language, "smaller_ones", [("count", count)]),
            u: squares.sqrt(),
        });
    }
    bars
}

fn draw_bar(out: &mut Markup, top: f64, bar: &Bar, scale: f64, unit: &Unit, fill: &str) {
    let value = out.language().number(&unit.text(bar.u));
    text(
        out,
        0.0,
        top + 13.0,
        "start",
        colour::INK,
        &shortened(&bar.label, WIDTH - VALUE_WIDTH),
    );
    text(out, WIDTH, top + 13.0, "end", colour::MUTED, &value);
    rectangle(out, (0.0, top + 18.0), (WIDTH, BAR), "#eef1f4");
    rectangle(out, (0.0, top + 18.0), (WIDTH * bar.u / scale, BAR), fill);
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
