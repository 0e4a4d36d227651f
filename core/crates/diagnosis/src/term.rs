//! Terms of a learned force.

use super::parameter_id::ParameterName;
use gyradius_base::named;

named! {
    /// A term of a learned force: a product of position, rate and time.
    Term: "term of a force" {
        /// The rate times the time.
        Vt = "vt",
        /// The square of the rate.
        Vv = "vv",
        /// The third power of the rate.
        Vvv = "vvv",
        /// The position times the time.
        Xt = "xt",
        /// The position times the rate.
        Xv = "xv",
        /// The position times the square of the rate.
        Xvv = "xvv",
        /// The square of the position.
        Xx = "xx",
        /// The square of the position times the rate.
        Xxv = "xxv",
        /// The third power of the position.
        Xxx = "xxx",
    }
}

/// A factor of a term.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Factor {
    Position,
    Rate,
    Time,
}

impl Term {
    /// Its factors, in the order in which it is written.
    pub fn factors(self) -> &'static [Factor] {
        use Factor::{Position as X, Rate as V, Time as T};
        match self {
            Self::Vt => &[V, T],
            Self::Vv => &[V, V],
            Self::Vvv => &[V, V, V],
            Self::Xt => &[X, T],
            Self::Xv => &[X, V],
            Self::Xvv => &[X, V, V],
            Self::Xx => &[X, X],
            Self::Xxv => &[X, X, V],
            Self::Xxx => &[X, X, X],
        }
    }

    /// Times a start, at a position, a rate and a time.
    pub fn times(self, start: f64, x: f64, v: f64, t: f64) -> f64 {
        let value = |factor: &Factor| match factor {
            Factor::Position => x,
            Factor::Rate => v,
            Factor::Time => t,
        };
        self.factors()
            .iter()
            .fold(start, |product, factor| product * value(factor))
    }

    /// Its coefficient, as a parameter of a cause.
    pub fn parameter(self) -> ParameterName {
        match self {
            Self::Vt => ParameterName::Vt,
            Self::Vv => ParameterName::Vv,
            Self::Vvv => ParameterName::Vvv,
            Self::Xt => ParameterName::Xt,
            Self::Xv => ParameterName::Xv,
            Self::Xvv => ParameterName::Xvv,
            Self::Xx => ParameterName::Xx,
            Self::Xxv => ParameterName::Xxv,
            Self::Xxx => ParameterName::Xxx,
        }
    }

    /// That of a coefficient.
    pub fn of(parameter: ParameterName) -> Option<Self> {
        Self::ALL
            .iter()
            .copied()
            .find(|term| term.parameter() == parameter)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_term_is_its_letters() {
        for term in Term::ALL {
            let letter = |factor: &Factor| match factor {
                Factor::Position => 'x',
                Factor::Rate => 'v',
                Factor::Time => 't',
            };
            let letters: String = term.factors().iter().map(letter).collect();
            assert_eq!(letters, term.name());
            assert_eq!(term.parameter().name(), term.name());
            assert_eq!(Term::of(term.parameter()), Some(*term));
        }
    }
}
