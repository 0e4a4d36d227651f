//! The value of a quantity: a number, a vector or a matrix.

use serde::{Deserialize, Deserializer, Serialize};

/// The value of a quantity or its standard uncertainty. In JSON: a number, `[3]` or `[3][3]`, with
/// `null` for a number that is not finite.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, schemars::JsonSchema)]
#[serde(untagged)]
pub enum Value {
    /// A number.
    Scalar(
        #[serde(deserialize_with = "number")]
        #[schemars(with = "Option<f64>")]
        f64,
    ),
    /// Three numbers, along x, y and z.
    Vector(
        #[serde(deserialize_with = "vector")]
        #[schemars(with = "[Option<f64>; 3]")]
        [f64; 3],
    ),
    /// Three by three numbers, by rows.
    Matrix(
        #[serde(deserialize_with = "matrix")]
        #[schemars(with = "[[Option<f64>; 3]; 3]")]
        [[f64; 3]; 3],
    ),
}

impl Value {
    /// The number of a scalar, where it is finite.
    pub fn scalar(&self) -> Option<f64> {
        match self {
            Self::Scalar(value) => Some(*value).filter(|v| v.is_finite()),
            Self::Vector(_) | Self::Matrix(_) => None,
        }
    }

    /// The components of a vector.
    pub fn vector(&self) -> Option<[f64; 3]> {
        match self {
            Self::Vector(values) => Some(*values),
            Self::Scalar(_) | Self::Matrix(_) => None,
        }
    }

    /// All numbers, a matrix's by rows.
    pub fn numbers(&self) -> &[f64] {
        match self {
            Self::Scalar(value) => std::slice::from_ref(value),
            Self::Vector(values) => values,
            Self::Matrix(rows) => rows.as_flattened(),
        }
    }

    /// Whether all numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.numbers().iter().all(|v| v.is_finite())
    }
}

impl From<f64> for Value {
    fn from(value: f64) -> Self {
        Self::Scalar(value)
    }
}

fn or_nan(value: Option<f64>) -> f64 {
    value.unwrap_or(f64::NAN)
}

fn number<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    Deserialize::deserialize(from).map(or_nan)
}

fn vector<'de, D: Deserializer<'de>>(from: D) -> Result<[f64; 3], D::Error> {
    <[Option<f64>; 3]>::deserialize(from).map(|values| values.map(or_nan))
}

fn matrix<'de, D: Deserializer<'de>>(from: D) -> Result<[[f64; 3]; 3], D::Error> {
    <[[Option<f64>; 3]; 3]>::deserialize(from).map(|rows| rows.map(|row| row.map(or_nan)))
}

#[cfg(test)]
#[allow(clippy::unwrap_used)]
mod tests {
    use super::*;
    use serde_json::json;

    fn text(value: Value) -> String {
        serde_json::to_string(&value).unwrap()
    }

    #[test]
    fn json_is_that_of_the_bare_numbers() {
        let rows = [[1.0, 0.0, -2.5], [0.1, 1e-9, 3e20], [4.0, 5.0, 6.0]];
        assert_eq!(text(Value::Scalar(0.1)), json!(0.1).to_string());
        assert_eq!(text(Value::Scalar(f64::NAN)), "null");
        assert_eq!(text(Value::Vector(rows[0])), json!(rows[0]).to_string());
        assert_eq!(text(Value::Matrix(rows)), json!(rows).to_string());
    }

    #[test]
    fn json_reads_back() {
        for value in [
            Value::Scalar(2.5),
            Value::Vector([1.0, 2.0, 3.0]),
            Value::Matrix([[1.0; 3], [2.0; 3], [3.0; 3]]),
        ] {
            assert_eq!(serde_json::from_str::<Value>(&text(value)).unwrap(), value);
        }
        let whole: Value = serde_json::from_str("3").unwrap();
        assert_eq!(whole, Value::Scalar(3.0));
        for unknown in ["null", "[null,1.0,2.0]"] {
            let read: Value = serde_json::from_str(unknown).unwrap();
            assert!(!read.is_finite());
            assert_eq!(text(read), unknown);
        }
    }
}
