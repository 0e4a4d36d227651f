//! The hull's inertia as a picture (Fig. 1 of the paper): the homogeneous ellipsoid that would
//! swing as the hull does, and the inertia ellipsoid, each from the side, from above and from
//! astern.
//!
//! # Conventions
//! The side view is from starboard, bow to the right; the plan has port upwards; from astern port
//! is left. A positive ψ lifts the bow end of the principal x axis.

use std::collections::BTreeMap;

use super::Figure;
use crate::chart::{self, WIDTH, colour, dashed, dot, ellipse, line, number, text};
use crate::digits::significant;
use crate::markup::Markup;
use crate::words::{figure as number_of, plain, say};
use gyradius_base::language::Language;
use gyradius_base::message::name;
use gyradius_identification::routes::ellipsoid::equivalent_semi_axes_m;
use gyradius_identification::{QuantityName, QuantityResult};

const GAP: f64 = 34.0;
const MARGIN: f64 = 22.0;
const TALLEST: f64 = 330.0;

/// Principal gyradii x, y, z and the angle of the principal axes, where the session knows them.
struct Known {
    gyradii_m: [f64; 3],
    psi_rad: Option<f64>,
    depth_m: Option<f64>,
}

/// The two pictures; none where a gyradius is missing.
pub(crate) fn ellipsoids(
    quantities: &BTreeMap<QuantityName, QuantityResult>,
    language: Language,
) -> Vec<Figure> {
    let Some(known) = known(quantities) else {
        return vec![];
    };
    [mass_equivalent(&known, language), inertia(&known, language)]
        .into_iter()
        .flatten()
        .collect()
}

/// Why there is no picture.
pub(crate) fn no_ellipsoid_reason(
    quantities: &BTreeMap<QuantityName, QuantityResult>,
    language: Language,
) -> Option<String> {
    if known(quantities).is_some() {
        return None;
    }
    let missing: Vec<String> = [
        (QuantityName::KRoll, "inertia.motion.roll"),
        (QuantityName::KPitch, "inertia.motion.pitch"),
        (QuantityName::KYaw, "inertia.motion.yaw"),
    ]
    .iter()
    .filter(|(key, _)| scalar(quantities, key).is_none())
    .filter_map(|(_, motion)| name(motion, language))
    .collect();
    let key = match missing.len() {
        1 => "no_ellipsoid_for_one",
        _ => "no_ellipsoid",
    };
    let motions = plain(missing.join(language.and()));
    Some(say(language, key, [("motions", motions)]))
}

fn scalar(quantities: &BTreeMap<QuantityName, QuantityResult>, key: &QuantityName) -> Option<f64> {
    quantities
        .get(key)?
        .value
        .scalar()
        .filter(|value| value.is_finite())
}

fn known(quantities: &BTreeMap<QuantityName, QuantityResult>) -> Option<Known> {
    let principal = quantities
        .get(&QuantityName::PrincipalGyradii)
        .and_then(|q| {
            let values = q.value.vector()?;
            q.value.is_finite().then_some(values)
        });
    let single = |key| scalar(quantities, key);
    let about_hull = || {
        Some([
            single(&QuantityName::KRoll)?,
            single(&QuantityName::KPitch)?,
            single(&QuantityName::KYaw)?,
        ])
    };
    let gyradii_m = principal.or_else(about_hull)?;
    gyradii_m
        .iter()
        .all(|k| k.is_finite() && *k > 0.0)
        .then_some(Known {
            gyradii_m,
            psi_rad: single(&QuantityName::Psi).map(f64::to_radians),
            depth_m: single(&QuantityName::CmDepth),
        })
}

/// Semi-axes after Fig. 1: a² = 5/2 (k_y² + k_z² − k_x²) and so on around.
fn mass_equivalent(known: &Known, language: Language) -> Option<Figure> {
    let semi_axes = equivalent_semi_axes_m(known.gyradii_m).ok()?;
    let explained = caption("mass_ellipsoid_is", semi_axes, known, language);
    let caption = match known.depth_m {
        Some(_) => format!("{explained} {}", say(language, "open_circle", [])),
        None => explained,
    };
    let title = say(language, "mass_ellipsoid", []);
    Some(figure(
        ("ellipsoid-mass", title, caption, language),
        semi_axes,
        known,
        known.depth_m,
    ))
}

/// Semi-axes 1/k: the distance to the surface along an axis is one over the gyradius about it.
fn inertia(known: &Known, language: Language) -> Option<Figure> {
    let semi_axes = known.gyradii_m.map(|k| 1.0 / k);
    let caption = caption("inertia_ellipsoid_is", semi_axes, known, language);
    let title = say(language, "inertia_ellipsoid", []);
    Some(figure(
        ("ellipsoid-inertia", title, caption, language),
        semi_axes,
        known,
        None,
    ))
}

/// What the picture is, with its semi-axes, and what its lines are.
fn caption(key: &str, semi_axes: [f64; 3], known: &Known, language: Language) -> String {
    let [x, y, z] = semi_axes.map(|axis| number_of(significant(axis, 3)));
    let explained = say(language, key, [("x", x), ("y", y), ("z", z)]);
    let lines = match known.psi_rad {
        Some(_) => "solid_lines",
        None => "psi_not_known",
    };
    format!("{explained} {}", say(language, lines, []))
}

fn figure(
    (id, title, caption, language): (&str, String, String, Language),
    semi_axes: [f64; 3],
    known: &Known,
    suspension_above: Option<f64>,
) -> Figure {
    let views = Views::of(semi_axes, known.psi_rad.unwrap_or(0.0), suspension_above);
    let mut body = Markup::in_language(language);
    views.draw(&mut body);
    let svg = chart::svg(&title, views.height(), body);
    Figure::new(id, title, caption, svg)
}

/// Three views to one scale: plan above the side view, from astern beside it.
struct Views {
    semi_axes: [f64; 3],
    psi: f64,
    /// Half extents along the hull's axes.
    half: [f64; 3],
    suspension_above: Option<f64>,
    scale: f64,
}

impl Views {
    fn of(semi_axes: [f64; 3], psi: f64, suspension_above: Option<f64>) -> Self {
        let [a, b, c] = semi_axes;
        let (sin, cos) = psi.sin_cos();
        let half = [(a * cos).hypot(c * sin), b, (a * sin).hypot(c * cos)];
        let up = suspension_above.map_or(half[2], |depth| depth.max(half[2]));
        let wide =
            (WIDTH - 2.0 * MARGIN - GAP) / (2.0 * (half[0] + half[1])).max(f64::MIN_POSITIVE);
        let high = TALLEST / (2.0 * half[1] + half[2] + up).max(f64::MIN_POSITIVE);
        Self {
            semi_axes,
            psi,
            half,
            suspension_above,
            scale: wide.min(high),
        }
    }

    /// The suspension points may lie above the ellipsoid.
    fn above(&self) -> f64 {
        self.scale
            * self
                .suspension_above
                .map_or(self.half[2], |depth| depth.max(self.half[2]))
    }

    fn px(&self, i: usize) -> f64 {
        self.scale * self.half[i]
    }

    fn left(&self) -> f64 {
        (WIDTH - 2.0 * self.px(0) - 2.0 * self.px(1) - GAP) / 2.0
    }

    fn plan(&self) -> (f64, f64) {
        (self.left() + self.px(0), MARGIN + self.px(1))
    }

    fn side(&self) -> (f64, f64) {
        (
            self.plan().0,
            MARGIN + 2.0 * self.px(1) + GAP + MARGIN + self.above(),
        )
    }

    fn astern(&self) -> (f64, f64) {
        (self.side().0 + self.px(0) + GAP + self.px(1), self.side().1)
    }

    fn height(&self) -> f64 {
        self.side().1 + self.px(2) + MARGIN + 8.0
    }

    fn draw(&self, out: &mut Markup) {
        let [a, _, c] = self.semi_axes.map(|axis| self.scale * axis);
        let [x, y, z] = [self.px(0), self.px(1), self.px(2)];
        self.draw_view(out, self.plan(), (x, y), 0.0, "from_above");
        self.draw_view(out, self.astern(), (y, z), 0.0, "from_astern");
        self.draw_view(out, self.side(), (a, c), self.psi, "from_starboard");
        self.draw_suspension(out);
        let (cx, cy) = self.side();
        let bow = out.say("bow_end");
        text(out, cx + x + 4.0, cy + 4.0, "start", colour::MUTED, &bow);
    }

    /// An ellipse with its axes, the hull's dashed where they differ.
    fn draw_view(
        &self,
        out: &mut Markup,
        (cx, cy): (f64, f64),
        (rx, ry): (f64, f64),
        turn: f64,
        view: &str,
    ) {
        let degrees = -turn.to_degrees();
        let turned = format!("rotate({} {} {})", number(degrees), number(cx), number(cy));
        ellipse(out, (cx, cy), (rx, ry), Some(&turned));
        let (sin, cos) = turn.sin_cos();
        if turn != 0.0 {
            dashed(out, (cx - rx, cy), (cx + rx, cy), colour::MUTED, 0.8, "4 3");
            dashed(out, (cx, cy - ry), (cx, cy + ry), colour::MUTED, 0.8, "4 3");
        }
        line(
            out,
            (cx - rx * cos, cy + rx * sin),
            (cx + rx * cos, cy - rx * sin),
            colour::MODEL,
            0.8,
        );
        line(
            out,
            (cx - ry * sin, cy - ry * cos),
            (cx + ry * sin, cy + ry * cos),
            colour::MODEL,
            0.8,
        );
        dot(out, cx, cy, 2.6, colour::INK);
        let name = out.say(view);
        text(
            out,
            cx,
            cy + ry.max(rx * sin.abs()) + 16.0,
            "middle",
            colour::MUTED,
            &name,
        );
    }

    fn draw_suspension(&self, out: &mut Markup) {
        let Some(depth) = self.suspension_above else {
            return;
        };
        for (cx, cy) in [self.side(), self.astern()] {
            let y = cy - self.scale * depth;
            dashed(out, (cx, cy), (cx, y), colour::SECOND, 0.8, "2 2");
            let attributes = [
                ("cx", &*number(cx)),
                ("cy", &*number(y)),
                ("r", "3.5"),
                ("fill", "#ffffff"),
                ("stroke", colour::SECOND),
                ("stroke-width", "1.4"),
            ];
            out.empty("circle", &attributes);
        }
    }
}
