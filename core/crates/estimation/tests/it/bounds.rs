//! Priors and bounds with known answers.

use nalgebra::{DMatrix, DVector};
use rand::RngExt;

use gyradius_estimation::{
    Block, ByRows, Edge, Fit, Options, Parameter, Rows, Shape, Side, UNSTOPPED, Wanted, minimise,
};
use gyradius_test_support::fresh;

fn solve(problem: &impl Rows, parameters: &[Parameter], start: &[f64]) -> Fit {
    let options = Options {
        gain: 1e-20,
        most_steps: 500,
        ..Options::default()
    };
    let fit = minimise(
        &mut ByRows::new(problem),
        parameters,
        start,
        &options,
        UNSTOPPED,
    )
    .unwrap();
    assert!(fit.ending.is_converged(), "{:?}", fit.ending);
    fit
}

/// `a·x` read as `b`.
struct Linear {
    a: DMatrix<f64>,
    b: DVector<f64>,
}

impl Rows for Linear {
    fn shape(&self) -> Shape {
        Shape::single(self.a.ncols())
    }

    fn rows(&self, _: usize, x: &[f64], _: &[f64], _: Wanted) -> Option<Block> {
        Some(Block {
            residuals: &self.a * DVector::from_column_slice(x) - &self.b,
            jacobian: Some(self.a.clone()),
        })
    }
}

/// H. H. Rosenbrock's function: its least values lie along a parabola.
struct Rosenbrock;

impl Rows for Rosenbrock {
    fn shape(&self) -> Shape {
        Shape::single(2)
    }

    fn rows(&self, _: usize, x: &[f64], _: &[f64], _: Wanted) -> Option<Block> {
        Some(Block {
            residuals: DVector::from_vec(vec![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]]),
            jacobian: Some(DMatrix::from_row_slice(
                2,
                2,
                &[-20.0 * x[0], 10.0, -1.0, 0.0],
            )),
        })
    }
}

/// `scipy.optimize.lsq_linear(a, b, bounds, method="bvls", tol=1e-14)`.
#[test]
fn linear_problems_within_bounds_agree_with_bvls() {
    let rows = [1.0, 0.9, 0.2, 0.3, 1.0, 0.8, 0.5, 0.4, 1.0, 0.2, 0.1, 0.7];
    let problem = Linear {
        a: DMatrix::from_row_slice(4, 3, &rows),
        b: DVector::from_row_slice(&[-1.0, 2.0, 0.5, -0.3]),
    };
    let free = Parameter::FREE;
    let cases = [
        ([free; 3], [-3.188286314, 2.341246561, 0.8011712927]),
        (
            [free.within(-1.0, f64::INFINITY), free, free],
            [-1.0, 0.8298619024, 0.7219816781],
        ),
        (
            [free.within(-1.0, 1.0), free, free.within(-1.0, -0.4)],
            [-1.0, 1.651515152, -0.4],
        ),
    ];
    for (parameters, expected) in cases {
        let fit = solve(&problem, &parameters, &[0.0; 3]);
        for (x, e) in fit.x.iter().zip(expected) {
            assert!((x - e).abs() < 1e-8, "{:?} {expected:?}", fit.x);
        }
    }
}

/// What makes a point the least one within a box (Karush, Kuhn and Tucker): free parameters have no
/// slope, those at a bound are pressed against it.
#[test]
fn random_boxes_end_where_every_slope_points_out() {
    let mut random = fresh("random_boxes");
    let mut at_bounds = 0;
    for _ in 0..200 {
        let mut draw = |_, _| random.random::<f64>() - 0.5;
        let problem = Linear {
            a: DMatrix::from_fn(9, 6, &mut draw),
            b: DVector::from_fn(9, &mut draw),
        };
        let parameters = [Parameter::FREE.within(-0.2, 0.1); 6];
        // Starts on bounds, the wrong ones among them.
        let start: Vec<f64> = (0..6)
            .map(|k| if k % 2 == 0 { -0.2 } else { 0.1 })
            .collect();
        let fit = solve(&problem, &parameters, &start);
        let x = DVector::from_vec(fit.x.clone());
        let slope = problem.a.tr_mul(&(&problem.a * &x - &problem.b));
        for k in 0..6 {
            let edge = fit.edges.iter().find(|e| e.place == k);
            match edge.map(|e| e.side) {
                Some(Side::Low) => assert!(x[k] == -0.2 && slope[k] > -1e-12),
                Some(Side::High) => assert!(x[k] == 0.1 && slope[k] < 1e-12),
                None => assert!(x[k] > -0.2 && x[k] < 0.1 && slope[k].abs() < 1e-9),
            }
        }
        at_bounds += fit.edges.len();
    }
    assert!((200..1000).contains(&at_bounds), "{at_bounds}");
}

/// Within `x ≤ 1/2` it is least at (1/2, 1/4): 1/4.
#[test]
fn a_bound_across_the_way_down_is_told() {
    let parameters = [Parameter::FREE.within(-2.0, 0.5), Parameter::FREE];
    let fit = solve(&Rosenbrock, &parameters, &[-1.2, 1.0]);
    assert!(fit.x[0] == 0.5 && (fit.x[1] - 0.25).abs() < 1e-9);
    assert!((fit.chi2 - 0.25).abs() < 1e-12);
    let edge = Edge {
        place: 0,
        side: Side::High,
        is_pressed: true,
    };
    assert_eq!(fit.edges, [edge]);
    // The other's uncertainty is that with the first held: 1/10.
    let u = fit.standard_deviations().unwrap();
    assert!(u[0] == 0.0 && (u[1] - 0.1).abs() < 1e-12);
    // Without the bound nothing is told.
    let free = solve(&Rosenbrock, &[Parameter::FREE; 2], &[-1.2, 1.0]);
    assert!((free.x[0] - 1.0).abs() < 1e-9 && free.edges.is_empty());
}

/// A start outside the bounds is put onto them, and leaves them where χ² falls inwards.
#[test]
fn a_start_at_the_wrong_bound_leaves_it() {
    let parameters = [Parameter::FREE.within(-1.5, 3.0), Parameter::FREE];
    for start in [[-9.0, 1.0], [-1.5, 2.25], [9.0, 1.0]] {
        let fit = solve(&Rosenbrock, &parameters, &start);
        assert!(
            (fit.x[0] - 1.0).abs() < 1e-9 && fit.edges.is_empty(),
            "{fit:?}"
        );
    }
}

/// Two Gaussians: precisions add, means are weighed by them.
#[test]
fn a_prior_is_weighed_with_the_data() {
    let problem = Linear {
        a: DMatrix::from_element(4, 1, 2.0),
        b: DVector::from_row_slice(&[1.0, 2.0, 3.0, 4.0]),
    };
    let fit = solve(&problem, &[Parameter::FREE.with_prior(3.0, 0.5)], &[0.0]);
    let (data, prior) = (4.0 * 4.0, 4.0);
    let mean = (data * 1.25 + prior * 3.0) / (data + prior);
    assert!((fit.x[0] - mean).abs() < 1e-12);
    assert!((fit.covariance().unwrap()[(0, 0)] - 1.0 / (data + prior)).abs() < 1e-12);
    assert!((fit.prior_chi2 - ((mean - 3.0) / 0.5).powi(2)).abs() < 1e-12);
    // The integral of two normal densities, the height of that of the data taken as 1.
    let log = -((data + prior).ln() - prior.ln() + fit.cost()) / 2.0;
    assert!((fit.log_evidence().unwrap() - log).abs() < 1e-12);
}

/// A strength that cannot be negative, read twice: the integral of exp(-(x - b)^2) over a half
/// normal prior of width 0.7, by mpmath.quad at 30 digits. It has no jump where b turns negative.
#[test]
fn the_evidence_of_a_bounded_parameter_is_that_of_its_side() {
    let strength = Parameter::FREE
        .with_prior(0.0, 0.7)
        .within(0.0, f64::INFINITY);
    for (b, is_held, expected) in [
        (3.0, false, -4.1952755671028),
        (0.5, false, -0.14490095274736),
        (0.0, true, -0.34154842235322),
        (-0.5, true, -0.94768915043394),
        (-2.0, true, -5.4278002834962),
        (-9.0, true, -83.771592964461),
        (-40.0, true, -1604.2517734064),
    ] {
        let problem = Linear {
            a: DMatrix::from_row_slice(2, 1, &[1.0, 1.0]),
            b: DVector::from_row_slice(&[b, b]),
        };
        let fit = solve(&problem, &[strength], &[1.0]);
        assert_eq!(fit.held(), vec![is_held]);
        assert!(
            (fit.log_evidence().unwrap() - expected).abs() < 1e-7,
            "{b}: {}",
            fit.log_evidence().unwrap()
        );
    }
}

#[test]
fn a_fixed_parameter_stays_and_is_no_edge() {
    let parameters = [Parameter::FREE.fixed(0.3), Parameter::FREE];
    let fit = solve(&Rosenbrock, &parameters, &[-1.2, 1.0]);
    assert!(fit.x[0] == 0.3 && (fit.x[1] - 0.09).abs() < 1e-9);
    assert!(fit.edges.is_empty() && fit.held() == [true, false]);
}
