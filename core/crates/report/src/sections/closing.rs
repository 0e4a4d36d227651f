//! Conventions and terms, for a reader who meets them first here; and the program.

use crate::markup::Markup;
use crate::source::ReportSource;

const TERMS: [(&str, &str); 9] = [
    (
        "Hull axes",
        "x forward, y to port, z up, through the centre of mass. Yaw turns about z, pitch about y, roll about x.",
    ),
    (
        "Gyradius k",
        "The distance at which the whole mass would have to stand from the axis to have the same moment of inertia: I = M k². Axes pass through the centre of mass.",
    ),
    (
        "Depth l₂",
        "Height of the suspension points above the centre of mass.",
    ),
    (
        "ψ",
        "Angle from the hull's x axis up to the principal x axis, positive bow up. A millimetre in a gyradius turns it by some tenths of a degree: it means nothing without its interval.",
    ),
    (
        "u, standard error",
        "One standard deviation of what is not known (GUM). The 95 % interval is 1.96 of them either way.",
    ),
    (
        "Period at small amplitude",
        "Periods depend a little on how far the body swings. The limit of ever smaller swings is what the equations are about.",
    ),
    (
        "Decrement",
        "Logarithm of the ratio of one swing to the next: the share of amplitude lost in a cycle. Level against amplitude where the damping is linear.",
    ),
    (
        "In phase, out of phase",
        "The two motions of a double pendulum: lines and hull swing the same way (long period) or against one another (short period).",
    ),
    (
        "σ",
        "A difference counted in its own standard uncertainties. Chance alone exceeds three once in 370 times.",
    ),
];

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    out.within("footer", &[("id", "terms")], |out| {
        out.element("h2", &[], "Conventions and terms");
        out.within("dl", &[], |out| {
            for (term, meaning) in TERMS {
                out.element("dt", &[], term);
                out.element("dd", &[], meaning);
            }
        });
        let paper = "Equation numbers are those of P. F. Hinrichsen, Bifilar suspension measurement of boat inertia \
                     parameters, Journal of Sailboat Technology 2014-01, with its misprints put right.";
        out.element("p", &[("class", "note")], paper);
        if !source.generated_by.is_empty() {
            let made = format!("Made by {}. The numbers are in this file as JSON too.", source.generated_by);
            out.element("p", &[("class", "note")], &made);
        }
    });
}
