//! What the samples of a swing that was not made would say: the information of the fit without its
//! data.

use nalgebra::DVector;

use super::equations::free;
use super::fit::Fit;
use super::linearise::Linearised;
use super::model::{Statement, SwingModel};
use super::record::{Recorded, Samples};
use super::scene::{OWN, Own, SwingSetup};
use crate::theory::{swing_body, swing_rig};
use gyradius_base::error::{Error, Result};
use gyradius_mechanics::small_modes;

/// What a swing with this start would say of the session's parameters `x`, as if it agreed with all
/// others. Linear about `x`, the swing's own numbers (start, damping, phone, biases) left open as
/// in a fit.
///
/// # Errors
/// Where the parameters allow no motion, or no motion of that length.
pub fn expected_statements(
    setup: &SwingSetup,
    x: &[f64],
    own: &Own,
    recorded: &Recorded,
) -> Result<Vec<Statement>> {
    let body = swing_body(setup.layout, x, setup.swing, setup.index)?;
    let fastest_s = small_modes(
        &swing_rig(setup.layout, x, setup.swing, setup.index)?,
        &body,
    )?
    .period_s(3);
    let samples = Samples::expected(recorded, fastest_s).ok_or_else(|| {
        Error::argument(
            "duration_s",
            "long enough for two periods of the fastest motion",
            recorded.duration_s,
        )
    })?;
    let free = free(setup.layout);
    let matrix = Linearised::at(setup, (x, own), &free, &samples, samples.duration_s)?.matrix;
    let fit = Fit {
        x: x.to_vec(),
        own: own.clone(),
        gradient: DVector::zeros(free.len() + OWN),
        free,
        matrix,
        cost: 0.0,
        rms_over_noise: 1.0,
        inflation: 1.0,
    };
    let model = SwingModel {
        setup: *setup,
        samples,
    };
    let mut said = model.statements(&fit, false).unwrap_or_default();
    // What is expected is what is assumed: the weak priors must not pull.
    for statement in &mut said {
        statement.value = statement.row.iter().map(|(i, slope)| slope * x[*i]).sum();
    }
    Ok(said)
}
