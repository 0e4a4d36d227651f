//! What is inside the blocks, as bytes.
//!
//! # Conventions
//! Little-endian. A text is its length in bytes (u32) and UTF-8. `None` of a number is NaN.

use super::types::{Event, FORMAT, Header, Piece, Samples, SensorInfo, Stream};

pub(super) const HEADER: u8 = 1;
pub(super) const SAMPLES: u8 = 2;
pub(super) const EVENT: u8 = 3;
pub(super) const RESUMED: u8 = 4;

pub(super) fn header(header: &Header) -> Vec<u8> {
    let mut out = Vec::new();
    text(&mut out, FORMAT);
    text(&mut out, &header.phone);
    out.extend((header.sensors.len() as u32).to_le_bytes());
    for sensor in &header.sensors {
        out.push(sensor.stream.index() as u8);
        text(&mut out, &sensor.name);
        text(&mut out, sensor.stream.unit());
        out.extend(sensor.full_scale.unwrap_or(f64::NAN).to_le_bytes());
    }
    out.extend((header.notes.len() as u32).to_le_bytes());
    for (key, value) in &header.notes {
        text(&mut out, key);
        text(&mut out, value);
    }
    out
}

/// Stream, number of samples, stamps, values.
pub(super) fn samples(samples: &Samples) -> Vec<u8> {
    let mut out = Vec::with_capacity(5 + 32 * samples.values.len());
    out.push(samples.stream.index() as u8);
    out.extend((samples.stamps_ns.len() as u32).to_le_bytes());
    out.extend(
        samples
            .stamps_ns
            .iter()
            .flat_map(|stamp| stamp.to_le_bytes()),
    );
    out.extend(
        samples
            .values
            .iter()
            .flatten()
            .flat_map(|value| value.to_le_bytes()),
    );
    out
}

pub(super) fn event(event: &Event) -> Vec<u8> {
    let mut out = event.stamp_ns.to_le_bytes().to_vec();
    text(&mut out, &event.key);
    out
}

/// Bytes of the incomplete tail that was cut off.
pub(super) fn resumed(cut_bytes: u64) -> Vec<u8> {
    cut_bytes.to_le_bytes().to_vec()
}

fn text(out: &mut Vec<u8>, text: &str) {
    out.extend((text.len() as u32).to_le_bytes());
    out.extend(text.as_bytes());
}

/// Reads a payload; `None` where it is not one of this version of the format.
pub(super) fn read(kind: u8, payload: &[u8]) -> Option<Piece> {
    let mut rest = Rest(payload);
    let piece = match kind {
        HEADER => Piece::Header(rest.header()?),
        SAMPLES => Piece::Samples(rest.samples()?),
        EVENT => Piece::Event(Event {
            stamp_ns: i64::from_le_bytes(rest.take()?),
            key: rest.text()?,
        }),
        RESUMED => Piece::Resumed {
            cut_bytes: u64::from_le_bytes(rest.take()?),
        },
        _ => return None,
    };
    rest.0.is_empty().then_some(piece)
}

/// What is left of a payload.
struct Rest<'a>(&'a [u8]);

impl Rest<'_> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (taken, rest) = self.0.split_first_chunk()?;
        self.0 = rest;
        Some(*taken)
    }

    fn count(&mut self) -> Option<usize> {
        self.take().map(|four| u32::from_le_bytes(four) as usize)
    }

    fn text(&mut self) -> Option<String> {
        let length = self.count()?;
        let (taken, rest) = self.0.split_at_checked(length)?;
        self.0 = rest;
        String::from_utf8(taken.to_vec()).ok()
    }

    fn number(&mut self) -> Option<f64> {
        self.take().map(f64::from_le_bytes)
    }

    fn stream(&mut self) -> Option<Stream> {
        let [index] = self.take()?;
        Stream::ALL.get(usize::from(index)).copied()
    }

    fn header(&mut self) -> Option<Header> {
        let format = self.text()?;
        let minor = format.strip_prefix(FORMAT)?;
        if !(minor.is_empty() || minor.starts_with('.')) {
            return None;
        }
        let phone = self.text()?;
        let mut header = Header {
            phone,
            ..Header::default()
        };
        for _ in 0..self.count()? {
            let (stream, name, unit) = (self.stream()?, self.text()?, self.text()?);
            let full_scale = Some(self.number()?).filter(|scale| !scale.is_nan());
            if unit != stream.unit() {
                return None;
            }
            header.sensors.push(SensorInfo {
                stream,
                name,
                full_scale,
            });
        }
        for _ in 0..self.count()? {
            let (key, value) = (self.text()?, self.text()?);
            header.notes.insert(key, value);
        }
        Some(header)
    }

    /// The number of samples must be what the payload has room for: nothing is reserved on its
    /// word.
    fn samples(&mut self) -> Option<Samples> {
        let (stream, count) = (self.stream()?, self.count()?);
        if self.0.len() != count.checked_mul(32)? {
            return None;
        }
        let mut samples = Samples::none(stream);
        for _ in 0..count {
            samples.stamps_ns.push(i64::from_le_bytes(self.take()?));
        }
        for _ in 0..count {
            samples
                .values
                .push([self.number()?, self.number()?, self.number()?]);
        }
        Some(samples)
    }
}
