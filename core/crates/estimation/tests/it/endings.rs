//! Why fits end, and what they refuse.

use std::cell::Cell;

use nalgebra::{DMatrix, DVector};

use gyradius_estimation::{
    Ending, Error, Fit, Keep, Normal, Options, Parameter, Problem, Shape, Slopes, UNSTOPPED,
    minimise,
};

const FREE: [Parameter; 1] = [Parameter::FREE];

/// One parameter, one residual: its value and slope; χ² is read to so many steps.
struct Curve<F> {
    residual: F,
    resolution: f64,
    /// The slope that is kept.
    slope: f64,
    new: usize,
}

impl<F: Fn(f64) -> Option<(f64, f64)>> Curve<F> {
    fn new(residual: F) -> Self {
        Self {
            residual,
            resolution: 0.0,
            slope: f64::NAN,
            new: 0,
        }
    }
}

impl<F: Fn(f64) -> Option<(f64, f64)>> Problem for Curve<F> {
    fn shape(&self) -> Shape {
        Shape::single(1)
    }

    fn chi2(&mut self, x: &[f64]) -> Option<f64> {
        let chi2 = (self.residual)(x[0])?.0.powi(2);
        Some(if self.resolution > 0.0 {
            (chi2 / self.resolution).ceil() * self.resolution
        } else {
            chi2
        })
    }

    fn normal(&mut self, x: &[f64], slopes: Slopes) -> Option<Normal> {
        let (residual, slope) = (self.residual)(x[0])?;
        if slopes == Slopes::New {
            (self.slope, self.new) = (slope, self.new + 1);
        }
        let information = DMatrix::from_element(1, 1, self.slope.powi(2));
        let gradient = DVector::from_element(1, self.slope * residual);
        Some(Normal::single(information, gradient))
    }
}

fn cubic(x: f64) -> Option<(f64, f64)> {
    Some((x.powi(3) - 8.0, 3.0 * x * x))
}

#[test]
fn what_is_not_finite_at_the_start_is_refused() {
    let options = Options::default();
    let run = |f: fn(f64) -> Option<(f64, f64)>| {
        minimise(&mut Curve::new(f), &FREE, &[1.0], &options, UNSTOPPED).map(|fit| fit.x)
    };
    assert_eq!(run(|_| None), Err(Error::NoFiniteStart));
    assert_eq!(run(|_| Some((f64::NAN, 1.0))), Err(Error::NoFiniteStart));
    assert_eq!(
        run(|_| Some((1.0, f64::INFINITY))),
        Err(Error::NoFiniteStart)
    );
    assert!(run(cubic).is_ok());
}

#[test]
fn lists_and_parameters_that_do_not_fit_are_refused() {
    let run = |parameters: &[Parameter], start: &[f64]| {
        let options = Options::default();
        let fit = minimise(
            &mut Curve::new(cubic),
            parameters,
            start,
            &options,
            UNSTOPPED,
        );
        fit.map(|fit| fit.x)
    };
    let count = |found| Error::Count { expected: 1, found };
    assert_eq!(run(&FREE, &[1.0, 2.0]), Err(count(2)));
    assert_eq!(run(&[], &[1.0]), Err(count(0)));
    let wrong = [
        Parameter::FREE.within(1.0, 0.0),
        Parameter::FREE.within(f64::NAN, 0.0),
        Parameter::FREE.with_prior(0.0, 0.0),
        Parameter::FREE.with_prior(f64::NAN, 1.0),
    ];
    for parameter in wrong {
        assert_eq!(
            run(&[parameter], &[1.0]),
            Err(Error::Parameter { place: 0 })
        );
    }
}

#[test]
fn each_ending_is_told() {
    let ending = |options: Options| {
        let fit = minimise(&mut Curve::new(cubic), &FREE, &[1.0], &options, UNSTOPPED);
        let fit = fit.unwrap();
        (fit.ending, fit.x[0])
    };
    let default = Options::default();
    let (gain, x) = ending(default);
    assert!(gain == Ending::Gain && (x - 2.0).abs() < 1e-2 / 12.0);
    // To rounding: a residual of 8 has 10⁻¹⁵, its slope is 12.
    let (_, x) = ending(Options {
        gain: 0.0,
        ..default
    });
    assert!((x - 2.0).abs() < 1e-15);
    let (ended, x) = ending(Options {
        most_steps: 3,
        ..default
    });
    assert!(ended == Ending::Iterations && x > 1.0);
}

#[test]
fn a_start_at_the_minimum_takes_no_step() {
    let mut problem = Curve::new(|x: f64| Some(((1.0 + x * x).sqrt(), x / (1.0 + x * x).sqrt())));
    let fit = minimise(&mut problem, &FREE, &[0.0], &Options::default(), UNSTOPPED).unwrap();
    assert_eq!(
        (fit.ending, fit.steps, fit.x[0]),
        (Ending::Gradient, 0, 0.0)
    );
}

#[test]
fn a_caller_can_stop_after_a_step() {
    let asked = Cell::new(0);
    let stop = |progress: gyradius_estimation::Progress| {
        asked.set(asked.get() + 1);
        progress.steps == 2
    };
    let fit = minimise(
        &mut Curve::new(cubic),
        &FREE,
        &[1.0],
        &Options::default(),
        &stop,
    );
    let fit = fit.unwrap();
    assert_eq!(
        (fit.ending, fit.steps, asked.get()),
        (Ending::Stopped, 2, 2)
    );
}

/// χ² that shows less than the derivatives promise: no step leads down.
#[test]
fn a_coarse_sum_of_squares_ends_by_its_steps() {
    let mut problem = Curve::new(|x: f64| Some((10.0 + x.powi(2), 2.0 * x)));
    problem.resolution = 50.0;
    let fit = minimise(&mut problem, &FREE, &[0.5], &Options::default(), UNSTOPPED).unwrap();
    assert_eq!((fit.ending, fit.x[0]), (Ending::Step, 0.5));
}

#[test]
fn derivatives_that_end_are_told() {
    // The slope is not there below 1.9, χ² is.
    let residual = |x: f64| Some((x, if x < 1.9 { f64::NAN } else { 1.0 }));
    let fit = minimise(
        &mut Curve::new(residual),
        &FREE,
        &[3.0],
        &Options::default(),
        UNSTOPPED,
    );
    let fit = fit.unwrap();
    assert!(fit.ending == Ending::NoDerivatives && fit.x[0] < 1.9);
}

/// Kept derivatives save work, and a fit ends on them only where it may.
#[test]
fn derivatives_are_kept_while_they_hold() {
    let residual = |x: f64| Some((x + 0.05 * x * x - 3.0, 1.0 + 0.1 * x));
    let run = |parameter, keep| {
        let options = Options {
            keep,
            gain: 1e-16,
            ..Options::default()
        };
        let mut problem = Curve::new(residual);
        let fit = minimise(&mut problem, &[parameter], &[1.0], &options, UNSTOPPED).unwrap();
        assert_eq!(fit.evaluations.1, problem.new);
        fit
    };
    let keep = |to_the_end| {
        Some(Keep {
            share: 0.5,
            to_the_end,
        })
    };
    let free = Parameter::FREE;
    let (kept, new) = (run(free, keep(false)), run(free, None));
    assert!((kept.x[0] - new.x[0]).abs() < 1e-7);
    assert!(kept.evaluations.1 < new.evaluations.1 && kept.steps > new.steps);
    // The information is that of the end: the square of its own slope.
    let slope = |fit: &Fit| residual(fit.x[0]).unwrap().1;
    let information = |fit: &Fit| fit.normal.information[(0, 0)];
    assert!((information(&kept) - slope(&kept).powi(2)).abs() < 1e-12);
    // χ² fell to nothing: derivatives of the start cannot tell the end.
    assert_eq!(run(free, keep(true)).evaluations, kept.evaluations);
    // Where a prior keeps it above half they can.
    let pulled = free.with_prior(4.0, 1.0);
    let (kept, rough) = (run(pulled, keep(false)), run(pulled, keep(true)));
    assert!(rough.evaluations.1 < kept.evaluations.1 && (rough.x[0] - kept.x[0]).abs() < 0.1);
}

/// Three parameters of which the data see a sum and one: the rank is two, the direction told.
struct Sum;

impl Problem for Sum {
    fn shape(&self) -> Shape {
        Shape::single(3)
    }

    fn chi2(&mut self, x: &[f64]) -> Option<f64> {
        Some((x[0] + 2.0 * x[1] - 4.0).powi(2) + (x[2] - 1.0).powi(2))
    }

    fn normal(&mut self, x: &[f64], _: Slopes) -> Option<Normal> {
        let jacobian = DMatrix::from_row_slice(2, 3, &[1.0, 2.0, 0.0, 0.0, 0.0, 1.0]);
        let residuals = DVector::from_vec(vec![x[0] + 2.0 * x[1] - 4.0, x[2] - 1.0]);
        let mut normal = Normal::zero(&Shape::single(3));
        normal.add_rows(0, &residuals, &jacobian);
        Some(normal)
    }
}

#[test]
fn what_the_data_leave_open_is_told() {
    let options = Options::default();
    let fit = |parameters: [Parameter; 3]| {
        minimise(&mut Sum, &parameters, &[0.0; 3], &options, UNSTOPPED).unwrap()
    };
    let open = fit([Parameter::FREE; 3]);
    assert!(open.ending.is_converged() && open.chi2 < 1e-4, "{open:?}");
    assert_eq!(open.covariance(), Err(Error::Undetermined));
    assert_eq!(open.rank(), 2);
    // In units of the columns' lengths, 1 and 2, it is (1, −1)/√2.
    let direction = &open.undetermined()[0];
    let product = direction.dot(&DVector::from_vec(vec![0.5f64.sqrt(), -0.5f64.sqrt(), 0.0]));
    assert!((product.abs() - 1.0).abs() < 1e-9);
    // A prior, or one that is fixed, determines it.
    let prior = Parameter::FREE.with_prior(1.0, 0.1);
    for known in [prior, Parameter::FREE.fixed(1.0)] {
        let fit = fit([known, Parameter::FREE, Parameter::FREE]);
        assert!(fit.undetermined().is_empty() && fit.covariance().is_ok());
        assert!((fit.x[1] - 1.5).abs() < 1e-9);
    }
}
