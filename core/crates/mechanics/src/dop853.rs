//! Runge–Kutta of order 8 with output of order 7 between steps (Dormand and Prince; DOP853).
//!
//! Coefficients: E. Hairer, S. P. Nørsett, G. Wanner, *Solving Ordinary Differential Equations I*,
//! 2nd ed. (Springer 1993), section II.5 and its code DOP853; section II.6 for the output between
//! steps; section II.10 for the estimate of the error. The equations are autonomous (time is a part
//! of the state).

use std::ops::Range;

use super::real::Real;

/// Stages of a step; the next one is the derivative at its end.
const STAGES: usize = 12;
/// Stages with those that only the output between steps needs.
const EXTENDED: usize = 16;
/// Coefficients of the output between the ends of a step, its start among them.
pub(super) const COEFFICIENTS: usize = 8;

/// Memory of an integration of states of one length.
pub(super) struct Stepper<S> {
    slopes: Vec<Vec<S>>,
    inside: Vec<S>,
    /// Differences of the step from those of order 5 and 3, over its length.
    estimates: [Vec<S>; 2],
}

impl<S: Real> Stepper<S> {
    pub fn new(size: usize) -> Self {
        let zeros = || vec![S::zero(); size];
        Self {
            slopes: vec![zeros(); EXTENDED],
            inside: zeros(),
            estimates: [zeros(), zeros()],
        }
    }

    /// Where the derivative at the start of the next step goes.
    pub fn first_slope(&mut self) -> &mut [S] {
        &mut self.slopes[0]
    }

    /// Writes the state after a step of `h` from `start` to `end`; the derivative at `start` is in
    /// `first_slope`.
    pub fn advance(
        &mut self,
        f: &mut impl FnMut(&[S], &mut [S]),
        start: &[S],
        h: f64,
        end: &mut [S],
    ) {
        for stage in 1..STAGES {
            self.stage(f, stage, start, h);
        }
        combine(A[STAGES], &self.slopes, start, h, end);
    }

    /// What [`Stepper::error`] is read off, of the step just made.
    pub fn estimate(&mut self) {
        for (row, estimates) in [FIFTH, THIRD].into_iter().zip(&mut self.estimates) {
            estimates.fill(S::zero());
            for &(stage, weight) in row {
                estimates
                    .iter_mut()
                    .zip(&self.slopes[stage])
                    .for_each(|(e, s)| e.add_scaled(weight, *s));
            }
        }
    }

    /// Estimate of the error of the step of `h` that was estimated last, of what `part` reads off a
    /// number, the largest among the parts `watched` of the state: the estimate of order 5, damped
    /// where that of order 3 is larger (eq. II.10.17).
    pub fn error(&self, h: f64, watched: Range<usize>, part: impl Fn(&S) -> f64) -> f64 {
        let largest = |of: &[S]| {
            of[watched.clone()]
                .iter()
                .map(|x| part(x).abs())
                .fold(0.0f64, |most, x| most.max(x))
        };
        let [fifth, third] = [largest(&self.estimates[0]), largest(&self.estimates[1])];
        let size = fifth.hypot(0.1 * third);
        if size == 0.0 {
            0.0
        } else {
            h * fifth * fifth / size
        }
    }

    fn stage(&mut self, f: &mut impl FnMut(&[S], &mut [S]), stage: usize, start: &[S], h: f64) {
        combine(A[stage], &self.slopes, start, h, &mut self.inside);
        f(&self.inside, &mut self.slopes[stage]);
    }

    /// Coefficients of the output between the ends for the first `KEPT` parts of the state:
    /// [`COEFFICIENTS`] rows of all parts.
    ///
    /// `end` and `end_slope` may already be projected. `end_slope` becomes the next step's
    /// `first_slope`.
    pub fn between<const KEPT: usize>(
        &mut self,
        f: &mut impl FnMut(&[S], &mut [S]),
        (start, end): (&[S], &[S]),
        end_slope: &[S],
        h: f64,
        out: &mut Vec<[S; KEPT]>,
    ) {
        self.slopes[STAGES].copy_from_slice(end_slope);
        for stage in STAGES + 1..EXTENDED {
            self.stage(f, stage, start, h);
        }
        let first = out.len();
        out.resize(first + COEFFICIENTS, [S::zero(); KEPT]);
        let rows = &mut out[first..];
        for i in 0..KEPT {
            let change = end[i] - start[i];
            let slope = self.slopes[0][i];
            rows[0][i] = start[i];
            rows[1][i] = change;
            rows[2][i] = slope.scale(h) - change;
            rows[3][i] = change.scale(2.0) - (slope + end_slope[i]).scale(h);
        }
        for (row, stages) in rows[4..].iter_mut().zip(D) {
            for &(stage, weight) in stages {
                row.iter_mut()
                    .zip(&self.slopes[stage])
                    .for_each(|(sum, s)| sum.add_scaled(weight * h, *s));
            }
        }
        self.slopes[0].copy_from_slice(end_slope);
    }
}

/// The parts of a state, and derivatives by `x` of those from `SLOPED` on, at the fraction `x` of a
/// step, 0 … 1, from its rows of coefficients.
pub(super) fn between<S: Real, const KEPT: usize, const SLOPED: usize>(
    rows: &[[S; KEPT]],
    x: f64,
) -> ([S; KEPT], [S; KEPT]) {
    let (mut parts, mut slopes) = ([S::zero(); KEPT], [S::zero(); KEPT]);
    for (i, row) in rows[1..].iter().enumerate().rev() {
        let (factor, by_x) = if i % 2 == 0 {
            (x, 1.0)
        } else {
            (1.0 - x, -1.0)
        };
        for k in 0..KEPT {
            let part = parts[k] + row[k];
            if k >= SLOPED {
                slopes[k] = slopes[k].scale(factor);
                slopes[k].add_scaled(by_x, part);
            }
            parts[k] = part.scale(factor);
        }
    }
    parts
        .iter_mut()
        .zip(&rows[0])
        .for_each(|(part, start)| *part += *start);
    (parts, slopes)
}

/// The same where the fraction has derivatives of its own.
pub(super) fn between_moving<S: Real, const KEPT: usize, const SLOPED: usize>(
    rows: &[[S; KEPT]],
    x: S,
) -> ([S; KEPT], [S; KEPT]) {
    let (mut parts, mut slopes) = ([S::zero(); KEPT], [S::zero(); KEPT]);
    for (i, row) in rows[1..].iter().enumerate().rev() {
        let (factor, by_x) = if i % 2 == 0 {
            (x, 1.0)
        } else {
            (S::one() - x, -1.0)
        };
        for k in 0..KEPT {
            let part = parts[k] + row[k];
            if k >= SLOPED {
                slopes[k] *= factor;
                slopes[k].add_scaled(by_x, part);
            }
            parts[k] = part * factor;
        }
    }
    parts
        .iter_mut()
        .zip(&rows[0])
        .for_each(|(part, start)| *part += *start);
    (parts, slopes)
}

fn combine<S: Real>(row: &[(usize, f64)], slopes: &[Vec<S>], start: &[S], h: f64, out: &mut [S]) {
    out.copy_from_slice(start);
    for &(stage, weight) in row {
        let weight = weight * h;
        for (out, slope) in out.iter_mut().zip(&slopes[stage]) {
            out.add_scaled(weight, *slope);
        }
    }
}

/// Rows of the tableau without their zeros: `(stage, weight)`. Row 12 gives the end of the step.
#[rustfmt::skip]
const A: [&[(usize, f64)]; EXTENDED] = [
    &[],
    &[(0, 0.05260015195876773)],
    &[(0, 0.0197250569845379), (1, 0.0591751709536137)],
    &[(0, 0.02958758547680685), (2, 0.08876275643042054)],
    &[(0, 0.2413651341592667), (2, -0.8845494793282861), (3, 0.924834003261792)],
    &[(0, 0.037037037037037035), (3, 0.17082860872947386), (4, 0.12546768756682242)],
    &[(0, 0.037109375), (3, 0.17025221101954405), (4, 0.06021653898045596), (5, -0.017578125)],
    &[
        (0, 0.03709200011850479), (3, 0.17038392571223998), (4, 0.10726203044637328),
        (5, -0.015319437748624402), (6, 0.008273789163814023),
    ],
    &[
        (0, 0.6241109587160757), (3, -3.3608926294469414), (4, -0.868219346841726), (5, 27.59209969944671),
        (6, 20.154067550477894), (7, -43.48988418106996),
    ],
    &[
        (0, 0.47766253643826434), (3, -2.4881146199716677), (4, -0.590290826836843),
        (5, 21.230051448181193), (6, 15.279233632882423), (7, -33.28821096898486),
        (8, -0.020331201708508627),
    ],
    &[
        (0, -0.9371424300859873), (3, 5.186372428844064), (4, 1.0914373489967295), (5, -8.149787010746927),
        (6, -18.52006565999696), (7, 22.739487099350505), (8, 2.4936055526796523), (9, -3.0467644718982196),
    ],
    &[
        (0, 2.273310147516538), (3, -10.53449546673725), (4, -2.0008720582248625), (5, -17.9589318631188),
        (6, 27.94888452941996), (7, -2.8589982771350235), (8, -8.87285693353063), (9, 12.360567175794303),
        (10, 0.6433927460157636),
    ],
    &[
        (0, 0.054293734116568765), (5, 4.450312892752409), (6, 1.8915178993145003), (7, -5.801203960010585),
        (8, 0.3111643669578199), (9, -0.1521609496625161), (10, 0.20136540080403034),
        (11, 0.04471061572777259),
    ],
    &[
        (0, 0.056167502283047954), (6, 0.25350021021662483), (7, -0.2462390374708025),
        (8, -0.12419142326381637), (9, 0.15329179827876568), (10, 0.00820105229563469),
        (11, 0.007567897660545699), (12, -0.008298),
    ],
    &[
        (0, 0.03183464816350214), (5, 0.028300909672366776), (6, 0.053541988307438566),
        (7, -0.05492374857139099), (10, -0.00010834732869724932), (11, 0.0003825710908356584),
        (12, -0.00034046500868740456), (13, 0.1413124436746325),
    ],
    &[
        (0, -0.42889630158379194), (5, -4.697621415361164), (6, 7.683421196062599), (7, 4.06898981839711),
        (8, 0.3567271874552811), (12, -0.0013990241651590145), (13, 2.9475147891527724),
        (14, -9.15095847217987),
    ],
];

/// Weights of the error by the embedded formula of order 5.
#[rustfmt::skip]
const FIFTH: &[(usize, f64)] = &[
    (0, 0.01312004499419488), (5, -1.2251564463762044), (6, -0.4957589496572502), (7, 1.6643771824549864),
    (8, -0.35032884874997366), (9, 0.3341791187130175), (10, 0.08192320648511571),
    (11, -0.022355307863886294),
];

/// The same by the formula of order 3.
#[rustfmt::skip]
const THIRD: &[(usize, f64)] = &[
    (0, -0.18980075407240762), (5, 4.450312892752409), (6, 1.8915178993145003), (7, -5.801203960010585),
    (8, -0.4226823213237919), (9, -0.1521609496625161), (10, 0.20136540080403034),
    (11, 0.02265179219836082),
];

/// The polynomial between the ends of a step.
#[rustfmt::skip]
const D: [&[(usize, f64)]; 4] = [
    &[
        (0, -8.428938276109013), (5, 0.5667149535193777), (6, -3.0689499459498917), (7, 2.38466765651207),
        (8, 2.117034582445028), (9, -0.871391583777973), (10, 2.2404374302607883), (11, 0.6315787787694688),
        (12, -0.08899033645133331), (13, 18.148505520854727), (14, -9.194632392478356),
        (15, -4.436036387594894),
    ],
    &[
        (0, 10.427508642579134), (5, 242.28349177525817), (6, 165.20045171727028), (7, -374.5467547226902),
        (8, -22.113666853125306), (9, 7.733432668472264), (10, -30.674084731089398),
        (11, -9.332130526430229), (12, 15.697238121770845), (13, -31.139403219565178),
        (14, -9.35292435884448), (15, 35.81684148639408),
    ],
    &[
        (0, 19.985053242002433), (5, -387.0373087493518), (6, -189.17813819516758), (7, 527.8081592054236),
        (8, -11.57390253995963), (9, 6.8812326946963), (10, -1.0006050966910838), (11, 0.7777137798053443),
        (12, -2.778205752353508), (13, -60.19669523126412), (14, 84.32040550667716),
        (15, 11.99229113618279),
    ],
    &[
        (0, -25.69393346270375), (5, -154.18974869023643), (6, -231.5293791760455), (7, 357.6391179106141),
        (8, 93.40532418362432), (9, -37.45832313645163), (10, 104.0996495089623), (11, 29.8402934266605),
        (12, -43.53345659001114), (13, 96.32455395918828), (14, -39.17726167561544),
        (15, -149.72683625798564),
    ],
];
