//! A first look at every cause: what it would gain, were everything linear about the fitted base.
//!
//! The sensitivity to a cause's strengths is made orthogonal to everything that is fitted; its product with the residual
//! is the score. One simulation for each strength and swing.

use nalgebra::{DMatrix, DVector};

use crate::error::Result;

use super::fitting::{Fitted, Places};
use super::linear::Reader;
use super::point::{Cause, Model, Point};

/// What a first look says of a cause.
#[derive(Clone)]
pub struct Look {
    pub cause: Cause,
    /// Expected gain of the logarithm of the evidence.
    pub gain: f64,
    /// Expected gain of χ².
    pub chi2: f64,
    /// Change of everything that is fitted, the cause's values (from its start) behind the other causes'.
    pub delta: DVector<f64>,
}

impl Look {
    /// Looks at a cause beside what is fitted; none where it has no parameters like what is seen.
    pub fn at(model: &Model, fitted: &Fitted, cause: &Cause) -> Result<Option<Self>> {
        let Some(alike) = &cause.look else { return Self::straight(model, fitted, cause).map(Some) };
        let seen = Self::straight(model, fitted, &alike.cause)?;
        let swings = model.base.swings.len();
        let split = Places::of(model).first_own(0);
        let size = alike.cause.size(swings);
        let strengths: Vec<f64> = seen.delta.rows(split, size).iter().copied().collect();
        let Some(nearest) = (alike.nearest)(&strengths) else { return Ok(None) };
        let start = cause.start(swings);
        let mut delta = DVector::zeros(seen.delta.len() - size + start.len());
        delta.rows_mut(0, split).copy_from(&seen.delta.rows(0, split));
        for (k, from) in start.iter().enumerate() {
            let value = nearest.get(k).filter(|value| value.is_finite());
            delta[split + k] = value.map_or(0.0, |value| value - from);
        }
        let owns = seen.delta.len() - size - split;
        delta.rows_mut(split + start.len(), owns).copy_from(&seen.delta.rows(split + size, owns));
        Ok(Some(Self { cause: cause.clone(), gain: seen.gain, chi2: seen.chi2, delta }))
    }

    fn straight(model: &Model, fitted: &Fitted, cause: &Cause) -> Result<Self> {
        let swings = model.base.swings.len();
        let extended = model.with(cause);
        let mut at = fitted.point.clone();
        at.causes.push(cause.start(swings));
        let strengths: Vec<usize> =
            (0..cause.size(swings)).filter(|k| cause.expanded(swings)[*k].0.is_strength).collect();
        let parts = model.each(|s| columns(&extended, fitted, &at, s, cause, &strengths));
        let parts = parts.into_iter().collect::<Result<Vec<_>>>()?;
        Ok(Self::solved(model, fitted, cause, &strengths, parts))
    }

    fn solved(model: &Model, fitted: &Fitted, cause: &Cause, strengths: &[usize], parts: Vec<Part>) -> Self {
        let swings = model.base.swings.len();
        let places = Places::of(model);
        let count = strengths.len();
        let mut outer = DMatrix::zeros(places.all(), count);
        let mut inner = DMatrix::zeros(count, count);
        let mut score = DVector::zeros(count);
        for (s, part) in parts.into_iter().enumerate() {
            inner += part.inner;
            score += part.score;
            for (row, place) in places.of_swing(model, s).into_iter().enumerate() {
                for k in 0..count {
                    outer[(place, k)] += part.outer[(row, k)];
                }
            }
        }
        let u = DVector::from_fn(count, |k, _| cause.expanded(swings)[strengths[k]].0.prior.1);
        for k in 0..count {
            inner[(k, k)] += u[k].powi(-2);
        }
        let mut look = Self {
            cause: cause.clone(),
            gain: f64::NEG_INFINITY,
            chi2: 0.0,
            delta: DVector::zeros(places.all() + cause.size(swings)),
        };
        let Some(base) = fitted.cholesky() else { return look };
        let absorbed = base.solve(&outer);
        let schur = &inner - outer.tr_mul(&absorbed);
        let score = score - absorbed.tr_mul(&fitted.gradient);
        let bounded: Vec<bool> = strengths.iter().map(|_| cause.one_sided).collect();
        let Some(solved) = Solved::of(&schur, &score, &u, &bounded) else { return look };
        let rest = base.solve(&fitted.gradient) - &absorbed * &solved.strength;
        let split = places.first_own(0);
        look.delta.rows_mut(0, split).copy_from(&rest.rows(0, split));
        strengths.iter().enumerate().for_each(|(k, place)| look.delta[split + place] = solved.strength[k]);
        let owns = places.all() - split;
        look.delta.rows_mut(split + cause.size(swings), owns).copy_from(&rest.rows(split, owns));
        Self { gain: solved.gain, chi2: solved.chi2, ..look }
    }

    /// The point that the look leads to, by a share of the way.
    pub fn start(&self, model: &Model, fitted: &Fitted, share: f64) -> Point {
        let swings = model.base.swings.len();
        let mut at = fitted.point.clone();
        at.causes.push(self.cause.start(swings));
        let extended = model.with(&self.cause);
        extended.bounded(extended.moved(&at, &(&self.delta * share)))
    }
}

/// Strengths that solve the equations, those that cannot be negative at zero or above.
pub struct Solved {
    pub strength: DVector<f64>,
    pub gain: f64,
    pub chi2: f64,
}

impl Solved {
    pub fn of(
        schur: &DMatrix<f64>,
        score: &DVector<f64>,
        u: &DVector<f64>,
        bounded: &[bool],
    ) -> Option<Self> {
        let mut open: Vec<usize> = (0..score.len()).collect();
        loop {
            let part = DMatrix::from_fn(open.len(), open.len(), |i, j| schur[(open[i], open[j])]);
            let wanted = DVector::from_fn(open.len(), |i, _| score[open[i]]);
            let factor = part.cholesky()?;
            let found = factor.solve(&wanted);
            let worst = (0..open.len()).filter(|i| bounded[open[*i]] && found[*i] < 0.0);
            // In standard deviations of their priors: their units differ.
            let worst = worst.min_by(|a, b| (found[*a] / u[open[*a]]).total_cmp(&(found[*b] / u[open[*b]])));
            if let Some(worst) = worst {
                open.remove(worst);
                continue;
            }
            let mut strength = DVector::zeros(score.len());
            open.iter().zip(found.iter()).for_each(|(k, x)| strength[*k] = *x);
            let log_determinant: f64 = factor.l_dirty().diagonal().iter().map(|d| d.ln()).sum();
            let occam = log_determinant + open.iter().map(|k| u[*k].ln()).sum::<f64>();
            let chi2 = wanted.dot(&found);
            return Some(Self { strength, gain: 0.5 * chi2 - occam, chi2 });
        }
    }
}

/// What a swing adds to the equations.
struct Part {
    outer: DMatrix<f64>,
    inner: DMatrix<f64>,
    score: DVector<f64>,
}

fn columns(
    extended: &Model,
    fitted: &Fitted,
    at: &Point,
    s: usize,
    cause: &Cause,
    strengths: &[usize],
) -> Result<Part> {
    let blocks = extended.blocks(s);
    let expanded = cause.expanded(extended.base.swings.len());
    let last = at.causes.len() - 1;
    let reader = Reader::new(extended, at, s, &blocks)?;
    let zero = reader.reread(at)?;
    let jacobian = &fitted.jacobians[s];
    let mut sensitivity = DMatrix::zeros(zero.len(), strengths.len());
    for (column, k) in strengths.iter().enumerate() {
        let (parameter, own) = &expanded[*k];
        if own.is_some_and(|own| own != s) {
            continue;
        }
        let moved = |by: f64| {
            let mut moved = at.clone();
            moved.causes[last][*k] += by;
            if cause.on_phone { reader.reread(&moved) } else { reader.moved(&moved) }
        };
        let up = moved(parameter.step)?;
        // The base absorbs nearly all of what shifts a period: the little that is left must not be an error of the step.
        let (down, by) = match moved(-parameter.step) {
            Ok(down) if !cause.stiff => (down, 2.0 * parameter.step),
            _ => (zero.clone(), parameter.step),
        };
        let change = up.iter().zip(&down).map(|(u, d)| (u - d) / by);
        sensitivity.column_mut(column).iter_mut().zip(change).for_each(|(cell, c)| *cell = c);
    }
    let residual = DVector::from_vec(extended.rows(at, s)?);
    Ok(Part {
        outer: jacobian.tr_mul(&sensitivity),
        inner: sensitivity.tr_mul(&sensitivity),
        score: sensitivity.tr_mul(&residual),
    })
}
