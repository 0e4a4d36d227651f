//! The report's parts, in the order in which they stand.

mod closing;
mod critique;
mod heading;
mod method;
mod parts;
mod recordings;
mod result;

pub(super) use heading::title;

use super::markup::Markup;
use super::source::ReportSource;

/// Everything between the body's tags.
pub(super) fn body(source: &ReportSource, out: &mut Markup) {
    heading::write(source, out);
    result::write(source, out);
    method::write(source, out);
    parts::consistency(source, out);
    critique::write(source, out);
    parts::budget(source, out);
    recordings::write(source, out);
    parts::ellipsoids(source, out);
    closing::write(source, out);
}
