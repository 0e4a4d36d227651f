//! Blocks of samples: numbers as little-endian bytes, which cross the boundary without a copy.
//!
//! A *stamps* block is 64-bit integers, ns of the phone's clock. A *values* block is 64-bit floats:
//! x, y, z of the first sample, then of the next. In Kotlin a block that goes in is a direct
//! `ByteBuffer`, in Swift `Data`.

use crate::error::{Result, bad_argument};

/// Stamps of a block, ns.
pub fn stamps(block: &[u8]) -> Result<Vec<i64>> {
    numbers("stamps_ns", block, i64::from_le_bytes)
}

/// Floats of a block.
pub fn floats(name: &str, block: &[u8]) -> Result<Vec<f64>> {
    numbers(name, block, f64::from_le_bytes)
}

/// Samples of three axes of a block.
pub fn triples(name: &str, block: &[u8]) -> Result<Vec<[f64; 3]>> {
    let flat = floats(name, block)?;
    let (rows, rest) = flat.as_chunks::<3>();
    match rest {
        [] => Ok(rows.to_vec()),
        _ => Err(bad_argument(
            name,
            "x, y and z of every sample",
            format!("{} numbers", flat.len()),
        )),
    }
}

/// A block of stamps.
pub fn of_stamps(stamps_ns: &[i64]) -> Vec<u8> {
    stamps_ns
        .iter()
        .flat_map(|stamp| stamp.to_le_bytes())
        .collect()
}

/// A block of floats.
pub fn of_floats(values: &[f64]) -> Vec<u8> {
    values
        .iter()
        .flat_map(|value| value.to_le_bytes())
        .collect()
}

fn numbers<T>(name: &str, block: &[u8], number: fn([u8; 8]) -> T) -> Result<Vec<T>> {
    let (eights, rest) = block.as_chunks::<8>();
    match rest {
        [] => Ok(eights.iter().map(|eight| number(*eight)).collect()),
        _ => Err(bad_argument(
            name,
            "8 bytes for each number",
            format!("{} bytes", block.len()),
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_read_back_to_the_same_bits() {
        let values = [
            0.1,
            -0.0,
            f64::NAN,
            f64::MIN_POSITIVE,
            1e300,
            f64::NEG_INFINITY,
        ];
        let read = triples("values", &of_floats(&values)).unwrap();
        let bits = |x: &[f64]| x.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(read.as_flattened()), bits(&values));
        let stamps_ns = [i64::MIN, -1, 0, 1, i64::MAX];
        assert_eq!(stamps(&of_stamps(&stamps_ns)).unwrap(), stamps_ns);
        // 1.0 is 3ff0000000000000 (IEEE 754), its lowest byte first.
        assert_eq!(of_floats(&[1.0]), [0, 0, 0, 0, 0, 0, 0xf0, 0x3f]);
    }

    #[test]
    fn blocks_of_another_length_are_refused() {
        assert!(stamps(&[0; 12]).is_err());
        assert!(floats("t_s", &[0; 7]).is_err());
        assert!(
            triples("values", &of_floats(&[1.0, 2.0]))
                .unwrap_err()
                .to_string()
                .contains("2 numbers")
        );
        assert_eq!(triples("values", &[]).unwrap(), Vec::<[f64; 3]>::new());
    }
}
