//! A small chart: panels with round ticks stacked over one another, holding lines, points with
//! error bars and levels.
//!
//! # Conventions
//! Drawing units are those of the view box, [`WIDTH`] wide; y grows downwards. Nothing is written
//! that is not a finite number: what cannot be drawn is left out.

use super::markup::Markup;
use super::scale::{Scale, drawable, extent, padded};
use gyradius_base::language::Language;

/// Width of every picture. At 12 units a letter reads on a phone (332 pixels wide) as on a desk
/// (520).
pub(super) const WIDTH: f64 = 420.0;
/// Size of letters.
pub(super) const LETTER: f64 = 12.0;
/// Width of an average letter, for texts that must not meet.
pub(super) const LETTER_WIDTH: f64 = 0.6 * LETTER;

const LEFT: f64 = 58.0;
const RIGHT: f64 = 12.0;
const HEADING: f64 = 22.0;
const TICKS: f64 = 18.0;
const X_LABEL: f64 = 18.0;

/// Colours, as they print: dark on white.
pub(super) mod colour {
    pub const INK: &str = "#1f2933";
    pub const MUTED: &str = "#5f6b7a";
    pub const GRID: &str = "#e4e8ec";
    pub const MEASURED: &str = "#9aa7b4";
    pub const MODEL: &str = "#0b5c9e";
    pub const SECOND: &str = "#8a5a00";
    pub const FLAG: &str = "#b3261e";
}

/// What a panel shows.
pub(super) enum Mark<'a> {
    /// A line through points; breaks where a value cannot be drawn.
    Line {
        x: &'a [f64],
        y: &'a [f64],
        colour: &'static str,
        width: f64,
    },
    /// Points with standard uncertainties.
    Points {
        x: &'a [f64],
        y: &'a [f64],
        u: &'a [f64],
        colour: &'static str,
    },
    /// A horizontal level with its standard uncertainty and a name.
    Level { y: f64, u: f64, name: String },
    /// Vertical lines with names, written above the panel.
    Names { x: Vec<(f64, String)> },
}

/// One set of axes.
pub(super) struct Panel<'a> {
    /// What is shown and its unit, written above.
    pub heading: String,
    /// Colours explained, at the right of the heading.
    pub legend: Vec<(&'static str, String)>,
    /// Label of the x axis; ticks have no text where it is empty (the panel below has them).
    pub x_label: String,
    /// Range of x; that of the marks where absent.
    pub x_range: Option<[f64; 2]>,
    /// Logarithmic y.
    pub log_y: bool,
    /// Height of the axes.
    pub height: f64,
    /// What is shown.
    pub marks: Vec<Mark<'a>>,
}

/// Panels under one another as an SVG.
pub(super) fn stacked(title: &str, panels: &[Panel], language: Language) -> String {
    let mut body = Markup::in_language(language);
    let mut top = 0.0;
    for panel in panels {
        top = panel.draw(&mut body, top);
    }
    svg(title, top, body)
}

/// A drawing as an SVG of a height; the title is read out where the picture is not seen.
pub(super) fn svg(title: &str, height: f64, body: Markup) -> String {
    let mut markup = Markup::default();
    let attributes = [
        ("xmlns", "http://www.w3.org/2000/svg"),
        ("viewBox", &format!("0 0 {WIDTH} {}", number(height))),
        ("role", "img"),
        ("font-family", "system-ui, 'DejaVu Sans', sans-serif"),
        ("font-size", &number(LETTER)),
        ("fill", colour::INK),
    ];
    markup.within("svg", &attributes, |inner| {
        inner.element("title", &[], title);
        inner.append(body);
    });
    markup.into_string()
}

/// A length or place in a drawing: one decimal, never anything but a number.
pub(super) fn number(value: f64) -> String {
    let held = if value.is_finite() {
        value.clamp(-1e5, 1e5)
    } else {
        0.0
    };
    let text = format!("{held:.1}");
    text.strip_suffix(".0").map_or(text.clone(), String::from)
}

/// A text; `anchor` is `start`, `middle` or `end`.
pub(super) fn text(out: &mut Markup, x: f64, y: f64, anchor: &str, fill: &str, text: &str) {
    let attributes = [
        ("x", &*number(x)),
        ("y", &*number(y)),
        ("text-anchor", anchor),
        ("fill", fill),
    ];
    out.element("text", &attributes, text);
}

/// A straight line.
pub(super) fn line(out: &mut Markup, from: (f64, f64), to: (f64, f64), stroke: &str, width: f64) {
    dashed(out, from, to, stroke, width, "none");
}

/// A straight line, dashed.
pub(super) fn dashed(
    out: &mut Markup,
    from: (f64, f64),
    to: (f64, f64),
    stroke: &str,
    width: f64,
    dashes: &str,
) {
    let attributes = [
        ("x1", &*number(from.0)),
        ("y1", &*number(from.1)),
        ("x2", &*number(to.0)),
        ("y2", &*number(to.1)),
        ("stroke", stroke),
        ("stroke-width", &*number(width)),
        ("stroke-dasharray", dashes),
    ];
    out.empty("line", &attributes);
}

/// A filled rectangle.
pub(super) fn rectangle(out: &mut Markup, corner: (f64, f64), size: (f64, f64), fill: &str) {
    let attributes = [
        ("x", &*number(corner.0)),
        ("y", &*number(corner.1)),
        ("width", &*number(size.0.max(0.0))),
        ("height", &*number(size.1.max(0.0))),
        ("fill", fill),
    ];
    out.empty("rect", &attributes);
}

/// A dot.
pub(super) fn dot(out: &mut Markup, x: f64, y: f64, radius: f64, fill: &str) {
    out.empty(
        "circle",
        &[
            ("cx", &number(x)),
            ("cy", &number(y)),
            ("r", &number(radius)),
            ("fill", fill),
        ],
    );
}

/// The outline of a body, filled; `turned` is a rotation as SVG writes it.
pub(super) fn ellipse(
    out: &mut Markup,
    centre: (f64, f64),
    radii: (f64, f64),
    turned: Option<&str>,
) {
    let [cx, cy, rx, ry] = [centre.0, centre.1, radii.0, radii.1].map(number);
    let mut attributes = vec![("cx", &*cx), ("cy", &*cy), ("rx", &*rx), ("ry", &*ry)];
    attributes.extend(turned.map(|turned| ("transform", turned)));
    attributes.extend([
        ("fill", "#dce8f3"),
        ("stroke", colour::MODEL),
        ("stroke-width", "1.4"),
    ]);
    out.empty("ellipse", &attributes);
}

/// Width of a text, about.
pub(super) fn text_width(text: &str) -> f64 {
    LETTER_WIDTH * text.chars().count() as f64
}

/// Scales of a panel at its place.
struct Axes {
    x: Scale,
    y: Scale,
    top: f64,
    bottom: f64,
}

impl Panel<'_> {
    /// Draws the panel from `top` down; answers where it ends.
    fn draw(&self, out: &mut Markup, top: f64) -> f64 {
        let names = self.rows_of_names();
        let axes_top = top + HEADING + names.len() as f64 * (LETTER + 3.0);
        let axes = self.axes(axes_top);
        self.draw_heading(out, top);
        self.draw_grid(out, &axes);
        draw_names(out, &axes, &names, top + HEADING);
        for mark in &self.marks {
            mark.draw(out, &axes);
        }
        let bottom = axes.bottom
            + if self.x_label.is_empty() {
                8.0
            } else {
                TICKS + X_LABEL
            };
        if !self.x_label.is_empty() {
            text(
                out,
                WIDTH - RIGHT,
                bottom - 4.0,
                "end",
                colour::MUTED,
                &self.x_label,
            );
        }
        bottom
    }

    fn axes(&self, top: f64) -> Axes {
        let bottom = top + self.height;
        let x_range = self
            .x_range
            .unwrap_or_else(|| padded(extent(self.marks.iter().flat_map(Mark::xs)), 0.0));
        let y_values = || self.marks.iter().flat_map(|mark| mark.ys());
        let y = if self.log_y {
            let positive = extent(y_values().filter(|y| *y > 0.0)).unwrap_or([0.1, 1.0]);
            Scale::logarithmic([positive[0] / 1.3, positive[1] * 1.6], bottom, top)
        } else {
            Scale::linear(padded(extent(y_values()), 0.06), bottom, top)
        };
        Axes {
            x: Scale::linear(x_range, LEFT, WIDTH - RIGHT),
            y,
            top,
            bottom,
        }
    }

    fn draw_heading(&self, out: &mut Markup, top: f64) {
        let y = top + LETTER + 2.0;
        text(out, 0.0, y, "start", colour::INK, &self.heading);
        let mut right = WIDTH - RIGHT;
        for (fill, name) in self.legend.iter().rev() {
            text(out, right, y, "end", fill, name);
            right -= text_width(name) + 14.0;
            line(out, (right, y - 4.0), (right + 10.0, y - 4.0), fill, 2.0);
            right -= 10.0;
        }
    }

    fn draw_grid(&self, out: &mut Markup, axes: &Axes) {
        let y_ticks = (self.height / 22.0).clamp(3.0, 6.0) as usize;
        for (value, label) in axes.y.ticks(y_ticks) {
            let Some(y) = axes.y.held(value) else {
                continue;
            };
            line(out, (LEFT, y), (WIDTH - RIGHT, y), colour::GRID, 1.0);
            let label = out.language().number(&label);
            text(out, LEFT - 6.0, y + 4.0, "end", colour::MUTED, &label);
        }
        for (value, label) in axes.x.ticks(6) {
            let Some(x) = axes.x.held(value) else {
                continue;
            };
            line(
                out,
                (x, axes.bottom),
                (x, axes.bottom + 4.0),
                colour::MUTED,
                1.0,
            );
            if !self.x_label.is_empty() {
                let label = out.language().number(&label);
                text(
                    out,
                    x,
                    axes.bottom + LETTER + 4.0,
                    "middle",
                    colour::MUTED,
                    &label,
                );
            }
        }
        line(
            out,
            (LEFT, axes.bottom),
            (WIDTH - RIGHT, axes.bottom),
            colour::MUTED,
            1.0,
        );
    }

    /// Names put into rows so that none meets another.
    fn rows_of_names(&self) -> Vec<Vec<(f64, f64, String)>> {
        let scale = self.axes(0.0).x;
        let mut names: Vec<(f64, String)> = self
            .marks
            .iter()
            .flat_map(|mark| {
                if let Mark::Names { x } = mark {
                    x.as_slice()
                } else {
                    &[]
                }
            })
            .filter_map(|(x, name)| Some((scale.held(*x)?, name.clone())))
            .collect();
        names.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut rows: Vec<Vec<(f64, f64, String)>> = Vec::new();
        for (x, name) in names {
            let start = (x - 4.0).min(WIDTH - text_width(&name)).max(0.0);
            let ends = |row: &Vec<(f64, f64, String)>| {
                row.last().map_or(0.0, |(_, s, n)| s + text_width(n) + 8.0)
            };
            match rows.iter().position(|row| ends(row) <= start) {
                Some(i) => rows[i].push((x, start, name)),
                None => rows.push(vec![(x, start, name)]),
            }
        }
        rows
    }
}

/// The later rows stand higher, so that their lines pass between the names below.
fn draw_names(out: &mut Markup, axes: &Axes, rows: &[Vec<(f64, f64, String)>], top: f64) {
    for (i, row) in rows.iter().enumerate() {
        let baseline = top + (i + 1) as f64 * (LETTER + 3.0) - 4.0;
        for (x, start, name) in row {
            dashed(
                out,
                (*x, baseline + 3.0),
                (*x, axes.bottom),
                colour::MUTED,
                0.8,
                "2 3",
            );
            text(out, *start, baseline, "start", colour::INK, name);
        }
    }
}

impl Mark<'_> {
    fn xs(&self) -> Vec<f64> {
        match self {
            Self::Line { x, .. } | Self::Points { x, .. } => x.to_vec(),
            Self::Names { x } => x.iter().map(|(x, _)| *x).collect(),
            Self::Level { .. } => vec![],
        }
    }

    fn ys(&self) -> Vec<f64> {
        match self {
            Self::Line { y, .. } => y.to_vec(),
            Self::Points { y, u, .. } => y
                .iter()
                .zip(*u)
                .flat_map(|(y, u)| [*y, y - drawn_u(*u), y + drawn_u(*u)])
                .collect(),
            Self::Level { y, u, .. } => vec![y - drawn_u(*u), y + drawn_u(*u)],
            Self::Names { .. } => vec![],
        }
    }

    fn draw(&self, out: &mut Markup, axes: &Axes) {
        match self {
            Self::Line {
                x,
                y,
                colour,
                width,
            } => draw_line(out, axes, (x, y), colour, *width),
            Self::Points { x, y, u, colour } => draw_points(out, axes, (x, y, u), colour),
            Self::Level { y, u, name } => draw_level(out, axes, *y, *u, name),
            Self::Names { .. } => {}
        }
    }
}

/// An uncertainty that is no number is not drawn.
fn drawn_u(u: f64) -> f64 {
    if drawable(u) { u } else { 0.0 }
}

fn draw_line(
    out: &mut Markup,
    axes: &Axes,
    (x, y): (&[f64], &[f64]),
    stroke: &'static str,
    width: f64,
) {
    let places: Vec<Option<(f64, f64)>> = x
        .iter()
        .zip(y)
        .map(|(x, y)| Some((axes.x.place(*x)?, axes.y.held(*y)?)))
        .collect();
    let inside = |p: &Option<(f64, f64)>| {
        p.is_some_and(|(x, _)| (LEFT - 0.5..=WIDTH - RIGHT + 0.5).contains(&x))
    };
    for piece in places
        .split(|p| !inside(p))
        .filter(|piece| !piece.is_empty())
    {
        if let [Some((x, y))] = piece {
            dot(out, *x, *y, width, stroke);
            continue;
        }
        let points: Vec<String> = piece
            .iter()
            .flatten()
            .map(|(x, y)| format!("{},{}", number(*x), number(*y)))
            .collect();
        let attributes = [
            ("points", &*points.join(" ")),
            ("fill", "none"),
            ("stroke", stroke),
            ("stroke-width", &*number(width)),
            ("stroke-linejoin", "round"),
        ];
        out.empty("polyline", &attributes);
    }
}

fn draw_points(
    out: &mut Markup,
    axes: &Axes,
    (x, y, u): (&[f64], &[f64], &[f64]),
    fill: &'static str,
) {
    for ((x, y), u) in x.iter().zip(y).zip(u) {
        let (Some(at), Some(middle)) = (axes.x.held(*x), axes.y.held(*y)) else {
            continue;
        };
        if let (Some(low), Some(high)) =
            (axes.y.held(y - drawn_u(*u)), axes.y.held(y + drawn_u(*u)))
        {
            line(out, (at, low), (at, high), fill, 1.2);
        }
        dot(out, at, middle, 3.0, fill);
    }
}

fn draw_level(out: &mut Markup, axes: &Axes, y: f64, u: f64, name: &str) {
    let Some(place) = axes.y.held(y) else { return };
    if let (Some(low), Some(high)) = (axes.y.held(y - drawn_u(u)), axes.y.held(y + drawn_u(u))) {
        let attributes = [
            ("x", &*number(LEFT)),
            ("y", &*number(high)),
            ("width", &*number(WIDTH - RIGHT - LEFT)),
            ("height", &*number((low - high).max(0.0))),
            ("fill", colour::SECOND),
            ("fill-opacity", "0.15"),
        ];
        out.empty("rect", &attributes);
    }
    dashed(
        out,
        (LEFT, place),
        (WIDTH - RIGHT, place),
        colour::SECOND,
        1.2,
        "5 4",
    );
    let below = place + LETTER + 2.0;
    let at = if below < axes.bottom {
        below
    } else {
        place - 4.0
    };
    text(
        out,
        LEFT + 4.0,
        at.max(axes.top),
        "start",
        colour::SECOND,
        name,
    );
}

/// A text cut to a width, the cut marked.
pub(super) fn shortened(text: &str, width: f64) -> String {
    let most = (width / LETTER_WIDTH).max(4.0) as usize;
    if text.chars().count() <= most {
        return text.into();
    }
    let kept: String = text.chars().take(most - 1).collect();
    format!("{}…", kept.trim_end())
}
