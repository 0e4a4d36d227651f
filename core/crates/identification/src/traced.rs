//! Figures that know what they rest on: a value with the change that one standard uncertainty of
//! each input makes.
//!
//! Two figures that share an input share its error; sums and differences of such figures stay right
//! (JCGM 100, 5.2).

use std::collections::BTreeMap;

use gyradius_base::error::Result;
use gyradius_recording::Quantity;

use super::routes::propagate::propagate;

/// A figure with its uncertainty by input.
#[derive(Debug, Clone, PartialEq)]
pub struct Traced {
    /// Value.
    pub value: f64,
    /// Sensitivity × u of each input, by the input's name.
    pub by_input: BTreeMap<String, f64>,
}

impl Traced {
    /// A figure that is itself an input.
    pub fn input(name: String, figure: Quantity) -> Self {
        Traced {
            value: figure.value,
            by_input: BTreeMap::from([(name, figure.u)]),
        }
    }

    /// An input of which these errors, by name, are part.
    pub fn sharing(mut self, errors: impl Iterator<Item = (String, f64)>) -> Self {
        let errors: Vec<(String, f64)> = errors.collect();
        let shared: f64 = errors.iter().map(|(_, change)| change * change).sum();
        for own in self.by_input.values_mut() {
            *own = (*own * *own - shared).max(0.0).sqrt();
        }
        self.by_input.extend(errors);
        self
    }

    /// A function of several figures, linearised.
    pub fn combine(parts: &[&Traced], f: impl Fn(&[f64]) -> Result<f64>) -> Result<Self> {
        let inputs: Vec<Quantity> = parts
            .iter()
            .map(|p| Quantity::new(p.value, p.u()))
            .collect();
        let propagated = propagate(&inputs, f)?;
        let mut by_input = BTreeMap::new();
        for ((part, u), change) in parts
            .iter()
            .zip(&inputs)
            .map(|(p, q)| (p, q.u))
            .zip(propagated.contributions)
        {
            for (name, own) in part.by_input.iter().filter(|_| u > 0.0) {
                *by_input.entry(name.clone()).or_default() += change / u * own;
            }
        }
        Ok(Traced {
            value: propagated.quantity.value,
            by_input,
        })
    }

    /// Standard uncertainty.
    pub fn u(&self) -> f64 {
        self.by_input.values().map(|c| c * c).sum::<f64>().sqrt()
    }

    /// Standard uncertainty of the difference to another figure, shared inputs counted once.
    pub fn u_of_difference(&self, other: &Traced) -> f64 {
        let of =
            |figure: &Traced, name: &String| figure.by_input.get(name).copied().unwrap_or_default();
        let alone = other
            .by_input
            .keys()
            .filter(|name| !self.by_input.contains_key(*name));
        let square = |name: &String| (of(self, name) - of(other, name)).powi(2);
        self.by_input
            .keys()
            .chain(alone)
            .map(square)
            .sum::<f64>()
            .sqrt()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    /// By hand: u(x + x) = 2 u(x), u(x − x) = 0, u(x + y) in quadrature.
    #[test]
    fn shared_inputs_are_counted_once() {
        let input = |name: &str, u: f64| Traced::input(name.into(), Quantity::new(1.0, u));
        let (x, y) = (input("x", 0.3), input("y", 0.4));
        let sum = |a: &Traced, b: &Traced| Traced::combine(&[a, b], |v| Ok(v[0] + v[1])).unwrap();
        assert_relative_eq!(sum(&x, &x).u(), 0.6, epsilon = 1e-9);
        assert_relative_eq!(sum(&x, &y).u(), 0.5, epsilon = 1e-9);
        assert_relative_eq!(sum(&x, &y).u_of_difference(&x), 0.4, epsilon = 1e-9);
        assert_relative_eq!(y.u_of_difference(&x), 0.5, epsilon = 1e-9);
    }
}
