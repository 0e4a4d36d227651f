//! Messages about a record.

use gyradius_base::message::{Argument, Message};

/// A message with the numbers in it and their decimals.
pub(super) fn message<'a>(
    key: &str,
    numbers: impl IntoIterator<Item = (&'a str, f64, u8)>,
) -> Message {
    let argument =
        |(name, value, decimals): (&'a str, f64, u8)| (name, Argument::Number(value, decimals));
    Message::new(format!("signal.{key}"), numbers.into_iter().map(argument))
}
