//! Uncertainty of a single route by the GUM's law of propagation (JCGM 100, 5.1.2), inputs
//! independent.

use super::domain::{not_negative, result};
use gyradius_base::Result;
use gyradius_recording::Quantity;

/// A result with its uncertainty and where that comes from.
#[derive(Debug, Clone, PartialEq)]
pub struct Propagated {
    /// Value and standard uncertainty.
    pub quantity: Quantity,
    /// Sensitivity × u of every input, in input order and with its sign.
    pub contributions: Vec<f64>,
}

/// Value, uncertainty and contributions of a function of several quantities.
///
/// Sensitivities by central differences of fourth order; inputs with u = 0 are not varied. A
/// function that fails at the value fails; one that fails beside it (the edge of its domain) fails
/// as well, because there is then no first-order uncertainty to give.
pub fn propagate(inputs: &[Quantity], f: impl Fn(&[f64]) -> Result<f64>) -> Result<Propagated> {
    let mut x: Vec<f64> = inputs.iter().map(|q| q.value).collect();
    let value = result("route", f(&x)?)?;
    let mut contributions = Vec::with_capacity(inputs.len());
    for (i, input) in inputs.iter().enumerate() {
        let u = not_negative("u", input.u)?;
        contributions.push(if u == 0.0 {
            0.0
        } else {
            u * slope(&mut x, i, u, &f)?
        });
    }
    let u = contributions.iter().map(|c| c * c).sum::<f64>().sqrt();
    Ok(Propagated {
        quantity: Quantity::new(value, u),
        contributions,
    })
}

/// ∂f/∂x_i. The step balances rounding (ε/h) against the h⁴ of the formula.
fn slope(x: &mut [f64], i: usize, u: f64, f: &impl Fn(&[f64]) -> Result<f64>) -> Result<f64> {
    let centre = x[i];
    let step = if centre == 0.0 {
        1e-3 * u
    } else {
        1e-3 * centre.abs().min(10.0 * u)
    };
    let mut at = |offset: f64| {
        x[i] = centre + offset * step;
        let value = f(x);
        x[i] = centre;
        value
    };
    let near = at(1.0)? - at(-1.0)?;
    let far = at(2.0)? - at(-2.0)?;
    result("sensitivity", (8.0 * near - far) / (12.0 * step))
}
