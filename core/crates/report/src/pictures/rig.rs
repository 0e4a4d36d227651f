//! A sketch of how the body hung on its two lines, to scale, with the dimensions that were stated.
//!
//! # Conventions
//! Seen along the horizontal that is across the points; up is up. The body is drawn as an ellipse
//! about its centre of mass: its outline is not known.

use super::Figure;
use crate::chart::{self, LETTER, WIDTH, colour, dashed, dot, ellipse, line, rectangle, text};
use crate::digits::{significant, with_u};
use crate::headline::Headline;
use crate::markup::Markup;
use crate::source::{ReportSource, RigFigureData};
use crate::words::{figure, id_in, plain, say};
use gyradius_base::language::Language;
use gyradius_identification::QuantityName;

/// Room of the sketch, drawing units.
const WIDEST: f64 = 250.0;
const TALLEST: f64 = 190.0;
const TOP: f64 = 24.0;
/// Semi-axes of the body, shares of the spacing.
const BODY: [f64; 2] = [0.75, 0.16];
/// Between the body and the dimension below it.
const BELOW: f64 = 14.0;
/// Half of the small stroke that ends a dimension.
const END: f64 = 4.0;

/// How the first swing on two lines hung; none where no swing did.
pub fn rig(source: &ReportSource) -> Option<Figure> {
    let rig = source.rig.as_ref()?;
    let depth_m = Headline::of(source)
        .quantities
        .get(&QuantityName::CmDepth)
        .and_then(|depth| depth.value.scalar())
        .filter(|depth| depth.is_finite() && *depth > 0.0);
    let sketch = Sketch::of(rig, depth_m)?;
    let language = source.language;
    let mut body = Markup::in_language(language);
    sketch.draw(&mut body);
    let swing = [("swing", plain(id_in(&rig.swing, language)))];
    let title = say(language, "rig", swing);
    let svg = chart::svg(&title, sketch.height(), body);
    Some(Figure::new(
        "rig",
        title,
        caption(rig, depth_m, language),
        svg,
    ))
}

fn caption(rig: &RigFigureData, depth_m: Option<f64>, language: Language) -> String {
    let length = |value: f64, u: f64| figure(format!("{} m", with_u(value, u)));
    let (line, spacing) = (&rig.line_length_m, &rig.spacing_m);
    let mut parts = vec![say(
        language,
        "rig_read",
        [
            ("line", length(line.value, line.u)),
            ("spacing", length(spacing.value, spacing.u)),
        ],
    )];
    if let Some(top) = &rig.top_spacing_m {
        let named = [("spacing", length(top.value, top.u))];
        parts.push(say(language, "rig_top", named));
    }
    if let Some(depth) = depth_m {
        let named = [("depth", figure(format!("{} m", significant(depth, 4))))];
        parts.push(say(language, "rig_depth", named));
    }
    parts.join(" ")
}

/// Lengths in drawing units.
struct Sketch {
    half_top: f64,
    half_spacing: f64,
    drop: f64,
    depth: f64,
    is_depth_known: bool,
}

impl Sketch {
    fn of(rig: &RigFigureData, depth_m: Option<f64>) -> Option<Self> {
        let (length, spacing) = (rig.line_length_m.value, rig.spacing_m.value);
        let top = rig.top_spacing_m.as_ref().map_or(spacing, |q| q.value);
        let aside = 0.5 * (top - spacing);
        let drop = (length * length - aside * aside).sqrt();
        let depth = depth_m.unwrap_or(BODY[1] * spacing);
        let wide = top.max(2.0 * BODY[0] * spacing);
        let tall = drop + depth + BODY[1] * spacing;
        let scale = (WIDEST / wide).min(TALLEST / tall);
        (scale.is_finite() && scale > 0.0 && drop > 0.0).then(|| Self {
            half_top: 0.5 * scale * top,
            half_spacing: 0.5 * scale * spacing,
            drop: scale * drop,
            depth: scale * depth,
            is_depth_known: depth_m.is_some(),
        })
    }

    fn points_y(&self) -> f64 {
        TOP + self.drop
    }

    fn centre_y(&self) -> f64 {
        self.points_y() + self.depth
    }

    fn semi_axes(&self) -> [f64; 2] {
        BODY.map(|share| 2.0 * share * self.half_spacing)
    }

    fn dimension_y(&self) -> f64 {
        self.centre_y() + self.semi_axes()[1] + BELOW
    }

    fn height(&self) -> f64 {
        self.dimension_y() + LETTER + 8.0
    }

    fn draw(&self, out: &mut Markup) {
        let middle = 0.5 * WIDTH;
        self.draw_body(out, middle);
        let beam = (2.0 * self.half_top + 40.0, 5.0);
        let corner = (middle - 0.5 * beam.0, TOP - beam.1);
        rectangle(out, corner, beam, colour::MUTED);
        for side in [-1.0, 1.0] {
            let above = (middle + side * self.half_top, TOP);
            let below = (middle + side * self.half_spacing, self.points_y());
            line(out, above, below, colour::INK, 1.4);
            dot(out, below.0, below.1, 2.6, colour::INK);
        }
        let name_x = middle + 0.5 * (self.half_top + self.half_spacing) + 8.0;
        let name_y = TOP + 0.5 * self.drop;
        text(out, name_x, name_y, "start", colour::INK, "L");
        self.draw_spacing(out, middle);
        if self.is_depth_known {
            self.draw_depth(out, middle);
        }
    }

    fn draw_body(&self, out: &mut Markup, middle: f64) {
        let [rx, ry] = self.semi_axes();
        ellipse(out, (middle, self.centre_y()), (rx, ry), None);
        for side in [-1.0, 1.0] {
            // From the points to the body, which may be lower.
            let point = (middle + side * self.half_spacing, self.points_y());
            let foot = (point.0, self.centre_y());
            dashed(out, point, foot, colour::MUTED, 0.8, "2 3");
        }
        dot(out, middle, self.centre_y(), 3.2, colour::FLAG);
    }

    fn draw_spacing(&self, out: &mut Markup, middle: f64) {
        let y = self.dimension_y();
        let [from, to] = [-1.0, 1.0].map(|side| middle + side * self.half_spacing);
        line(out, (from, y), (to, y), colour::MUTED, 0.8);
        for x in [from, to] {
            line(out, (x, y - END), (x, y + END), colour::MUTED, 0.8);
        }
        let below = y + LETTER + 2.0;
        text(out, middle, below, "middle", colour::INK, "s");
    }

    fn draw_depth(&self, out: &mut Markup, middle: f64) {
        let (top, bottom) = (self.points_y(), self.centre_y());
        let from = (middle - self.half_spacing, top);
        dashed(out, from, (middle, top), colour::MUTED, 0.8, "2 3");
        line(out, (middle, top), (middle, bottom), colour::FLAG, 0.8);
        let y = 0.5 * (top + bottom) + 4.0;
        text(out, middle + 6.0, y, "start", colour::INK, "h");
    }
}
