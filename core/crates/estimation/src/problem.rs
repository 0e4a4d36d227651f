//! What a fit needs to know of a problem.

use nalgebra::{DMatrix, DVector};

use gyradius_base::parallel::in_parallel;

use crate::normal::Normal;
use crate::shape::Shape;

/// Which derivatives normal equations may be made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Slopes {
    /// Those of this point.
    New,
    /// Those of the last point that had new ones, with the residuals of this point.
    Kept,
}

/// A least-squares problem that makes its own normal equations, priors not in them.
///
/// Derivatives are exact: nothing here takes differences.
pub trait Problem {
    /// The order of the parameters.
    fn shape(&self) -> Shape;

    /// χ² of the data at a point; none where it cannot be computed there. What has the derivatives
    /// of a χ² will do, such as a log likelihood times −2.
    fn chi2(&mut self, x: &[f64]) -> Option<f64>;

    /// Normal equations of the data at a point for which χ² was asked before; none where they
    /// cannot be computed. Where [`Options`](crate::Options) do not say to keep derivatives, it is
    /// always the point that was asked for last, and they are always new.
    fn normal(&mut self, x: &[f64], slopes: Slopes) -> Option<Normal>;
}

/// A least-squares problem that hands over residuals and their Jacobian, block by block.
pub trait Rows: Sync {
    /// The order of the parameters.
    fn shape(&self) -> Shape;

    /// Residuals of a block in standard deviations, and, where asked for, their exact derivatives:
    /// first by the shared parameters, then by the block's own. None where they cannot be computed.
    fn rows(&self, block: usize, shared: &[f64], own: &[f64], wanted: Wanted) -> Option<Block>;
}

/// What is wanted of a block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted {
    /// Residuals alone.
    Residuals,
    /// And their derivatives.
    Jacobian,
}

/// Residuals of a block, and their derivatives where they were wanted.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// In standard deviations.
    pub residuals: DVector<f64>,
    /// Residuals by parameters: the shared ones, then the block's own.
    pub jacobian: Option<DMatrix<f64>>,
}

/// A problem of rows as one of normal equations. Blocks are computed side by side.
pub struct ByRows<'a, R> {
    rows: &'a R,
    /// Jacobians of the last point that had new ones.
    kept: Vec<DMatrix<f64>>,
}

impl<'a, R: Rows> ByRows<'a, R> {
    /// Of these rows.
    pub fn new(rows: &'a R) -> Self {
        Self { rows, kept: vec![] }
    }

    fn blocks(&self, x: &[f64], wanted: Wanted) -> Option<Vec<Block>> {
        let shape = self.rows.shape();
        let shared = x.get(..shape.shared())?;
        let block = |b: usize| {
            let own = x.get(shape.own(b))?;
            self.rows.rows(b, shared, own, wanted)
        };
        in_parallel(shape.blocks(), block).into_iter().collect()
    }
}

impl<R: Rows> Problem for ByRows<'_, R> {
    fn shape(&self) -> Shape {
        self.rows.shape()
    }

    fn chi2(&mut self, x: &[f64]) -> Option<f64> {
        let blocks = self.blocks(x, Wanted::Residuals)?;
        Some(blocks.iter().map(|b| b.residuals.norm_squared()).sum())
    }

    fn normal(&mut self, x: &[f64], slopes: Slopes) -> Option<Normal> {
        let wanted = match slopes {
            Slopes::New => Wanted::Jacobian,
            Slopes::Kept => Wanted::Residuals,
        };
        let (residuals, jacobians): (Vec<_>, Vec<_>) = self
            .blocks(x, wanted)?
            .into_iter()
            .map(|block| (block.residuals, block.jacobian))
            .unzip();
        if slopes == Slopes::New {
            self.kept = jacobians.into_iter().collect::<Option<_>>()?;
        }
        let mut normal = Normal::zero(&self.rows.shape());
        for (b, (residuals, jacobian)) in residuals.iter().zip(&self.kept).enumerate() {
            normal.add_rows(b, residuals, jacobian);
        }
        Some(normal)
    }
}
