//! Conventions and terms, for a reader who meets them first here; and the program.

use crate::markup::Markup;
use crate::source::ReportSource;
use crate::words::plain;

const TERMS: [[&str; 2]; 9] = [
    ["hull_axes", "hull_axes_are"],
    ["gyradius", "gyradius_is"],
    ["depth", "depth_is"],
    ["psi", "psi_is"],
    ["standard_error", "standard_error_is"],
    ["small_period", "small_period_is"],
    ["decrement", "decrement_is"],
    ["in_phase", "in_phase_is"],
    ["sigma", "sigma_is"],
];

pub(super) fn write(source: &ReportSource, out: &mut Markup) {
    out.folded("terms", "terms", |out| {
        out.within("dl", &[], |out| {
            for [term, meaning] in TERMS {
                out.element("dt", &[], &out.say(term));
                out.element("dd", &[], &out.say(meaning));
            }
        });
        out.element("p", &[("class", "note")], &out.say("paper"));
        if !source.generated_by.is_empty() {
            let made = out.tell("made_by", [("program", plain(&source.generated_by))]);
            out.element("p", &[("class", "note")], &made);
        }
    });
}
