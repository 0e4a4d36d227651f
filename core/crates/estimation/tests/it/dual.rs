//! Forward-mode derivatives by at most nine parameters, the most that a problem of StRD has.

use std::ops::{Add, Div, Mul, Neg, Sub};

pub const MOST: usize = 9;

/// A value with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dual {
    pub value: f64,
    pub slopes: [f64; MOST],
}

impl Dual {
    pub fn constant(value: f64) -> Self {
        Self {
            value,
            slopes: [0.0; MOST],
        }
    }

    pub fn parameter(value: f64, place: usize) -> Self {
        let mut dual = Self::constant(value);
        dual.slopes[place] = 1.0;
        dual
    }

    /// A function of it with so much value and so much slope.
    fn chain(self, value: f64, slope: f64) -> Self {
        Self {
            value,
            slopes: self.slopes.map(|s| slope * s),
        }
    }

    /// A function of two with so much value and so much slope by each.
    fn of_two(value: f64, (a, by_a): (Self, f64), (b, by_b): (Self, f64)) -> Self {
        let slope = |k: usize| by_a * a.slopes[k] + by_b * b.slopes[k];
        Self {
            value,
            slopes: std::array::from_fn(slope),
        }
    }

    pub fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value)
    }

    pub fn ln(self) -> Self {
        self.chain(self.value.ln(), self.value.recip())
    }

    pub fn sin(self) -> Self {
        self.chain(self.value.sin(), self.value.cos())
    }

    pub fn cos(self) -> Self {
        self.chain(self.value.cos(), -self.value.sin())
    }

    pub fn atan(self) -> Self {
        let slope = (1.0 + self.value * self.value).recip();
        self.chain(self.value.atan(), slope)
    }

    pub fn squared(self) -> Self {
        self * self
    }

    pub fn powf(self, exponent: f64) -> Self {
        let slope = exponent * self.value.powf(exponent - 1.0);
        self.chain(self.value.powf(exponent), slope)
    }

    /// To the power of another.
    pub fn pow(self, exponent: Self) -> Self {
        (self.ln() * exponent).exp()
    }
}

impl Add for Dual {
    type Output = Self;
    fn add(mut self, other: Self) -> Self {
        self.value += other.value;
        (0..MOST).for_each(|k| self.slopes[k] += other.slopes[k]);
        self
    }
}

impl Neg for Dual {
    type Output = Self;
    fn neg(self) -> Self {
        self.chain(-self.value, -1.0)
    }
}

impl Sub for Dual {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dual {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let value = self.value * other.value;
        Self::of_two(value, (self, other.value), (other, self.value))
    }
}

impl Div for Dual {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        Self::of_two(
            value,
            (self, other.value.recip()),
            (other, -value / other.value),
        )
    }
}

impl Add<f64> for Dual {
    type Output = Self;
    fn add(self, other: f64) -> Self {
        self + Self::constant(other)
    }
}

impl Mul<f64> for Dual {
    type Output = Self;
    fn mul(self, other: f64) -> Self {
        self.chain(self.value * other, other)
    }
}

impl Sub<Dual> for f64 {
    type Output = Dual;
    fn sub(self, other: Dual) -> Dual {
        Dual::constant(self) - other
    }
}

impl Add<Dual> for f64 {
    type Output = Dual;
    fn add(self, other: Dual) -> Dual {
        other + self
    }
}

impl Mul<Dual> for f64 {
    type Output = Dual;
    fn mul(self, other: Dual) -> Dual {
        other * self
    }
}

/// Slopes of every operation against differences.
#[test]
fn slopes_are_those_of_the_values() {
    let f = |x: Dual| {
        let y = (x * 0.3).exp() - x.ln() / (1.0 + x.squared()) + x.sin() * x.cos();
        y.powf(2.0) + x.pow(x) + (0.5 - x).atan()
    };
    let at = |x: f64| f(Dual::parameter(x, 4));
    let step = 1e-6;
    let difference = (at(0.7 + step).value - at(0.7 - step).value) / (2.0 * step);
    assert!((at(0.7).slopes[4] - difference).abs() < 1e-9);
}
