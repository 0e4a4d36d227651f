//! The simplest closed form of a force that was learned: which of its terms do as well as all of
//! them.

use nalgebra::{DMatrix, DVector};

use super::causes::{Scales, TERMS, learned_force};
use super::evidence::{LEAST_GAIN, gain};
use super::fitting::Fitted;
use super::found::Found;
use super::point::{Model, Point};
use super::term::Term;

/// A force with all its terms, as it was fitted.
pub struct Whole<'a> {
    found: &'a Found<'a>,
    scales: &'a Scales,
    coordinate: usize,
    values: DVector<f64>,
    /// Of everything that is fitted; the terms begin at `first`.
    covariance: DMatrix<f64>,
    first: usize,
}

/// The extended simulation with some terms of the force alone.
pub struct Closed<'a> {
    pub terms: Vec<usize>,
    pub model: Model<'a>,
    pub fitted: Fitted,
}

impl<'a> Whole<'a> {
    /// The last cause of what was found, a force along a coordinate whose terms are over these
    /// scales.
    pub fn of(found: &'a Found<'a>, scales: &'a Scales, coordinate: usize) -> Option<Self> {
        let values = DVector::from_column_slice(found.fitted.point.causes.last()?);
        let (covariance, first) = (
            found.fitted.covariance()?,
            found.fitted.place_of_last(values.len()),
        );
        Some(Self {
            found,
            scales,
            coordinate,
            values,
            covariance,
            first,
        })
    }

    /// The best single term, and a second where it pays.
    pub fn closed_form(&self) -> Option<Closed<'a>> {
        let one = self.with_one_more(&[])?;
        let Some(two) = self.with_one_more(&one.terms) else {
            return Some(one);
        };
        let gained = gain(&one.fitted, &two.fitted)?;
        Some(if gained > LEAST_GAIN { two } else { one })
    }

    /// Some terms, and the one beside them that makes up best for all that are left out.
    fn with_one_more(&self, kept: &[usize]) -> Option<Closed<'a>> {
        let with = |term: usize| [kept, &[term]].concat();
        let loss = |term: &usize| self.loss(&with(*term)).unwrap_or(f64::INFINITY);
        let others = self.left_out(kept).into_iter();
        self.reduced(with(others.min_by(|a, b| loss(a).total_cmp(&loss(b)))?))
    }

    fn left_out(&self, kept: &[usize]) -> Vec<usize> {
        (0..self.values.len())
            .filter(|term| !kept.contains(term))
            .collect()
    }

    /// Values of terms over their joint covariance.
    fn pull(&self, terms: &[usize]) -> Option<DVector<f64>> {
        let place = |k: usize| self.first + terms[k];
        let own = DMatrix::from_fn(terms.len(), terms.len(), |i, j| {
            self.covariance[(place(i), place(j))]
        });
        Some(own.cholesky()?.solve(&self.values.select_rows(terms)))
    }

    /// Of χ², were those terms kept alone and all else made the best of.
    fn loss(&self, kept: &[usize]) -> Option<f64> {
        let out = self.left_out(kept);
        Some(self.pull(&out)?.dot(&self.values.select_rows(&out)))
    }

    /// Where everything is likeliest with those terms alone, to first order.
    fn start(&self, kept: &[usize]) -> Option<Point> {
        let out = self.left_out(kept);
        let places: Vec<usize> = out.iter().map(|term| self.first + term).collect();
        let change = -(self.covariance.select_columns(&places) * self.pull(&out)?);
        let mut start = self.found.model.moved(&self.found.fitted.point, &change);
        let values = start.causes.last_mut()?;
        *values = kept.iter().map(|term| values[*term]).collect();
        Some(start)
    }

    fn reduced(&self, terms: Vec<usize>) -> Option<Closed<'a>> {
        let names: Vec<Term> = terms.iter().map(|term| TERMS[*term]).collect();
        let mut model = self.found.model.clone();
        model.causes.pop();
        let model = model.with(&learned_force(self.scales, self.coordinate, &names));
        let fitted = model.fit(&self.start(&terms)?, &|_| false).ok()?;
        Some(Closed {
            terms,
            model,
            fitted,
        })
    }
}
