//! The motion in time, as a curve that can be read at any time.

use super::dop853::{COEFFICIENTS, Stepper, between, between_moving};
use super::equations::Equations;
use super::real::{Dual, M3, Real, V3, is_still};
use super::state::{ATTITUDE, MEMORY, PLACE, RATE, VELOCITY, matrix};
use super::suspended::MOST_LINES;
use gyradius_base::error::{Error, Result};

/// A line that went slack: lines of given length then go on as rods, and what follows is not to be
/// used; elastic lines go on as they should.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Slack {
    /// When its tension first vanished, s.
    pub t_s: f64,
    /// Which line.
    pub line: usize,
}

/// A motion from time 0 on, in steps of one length; a step may be made of several pieces.
#[derive(Debug, Clone)]
pub struct Path<S: Real> {
    step_s: f64,
    pieces: Vec<Piece>,
    /// The first piece of each step, and one beyond the last.
    first: Vec<usize>,
    /// [`COEFFICIENTS`] rows of all parts of the state for each piece.
    coefficients: Vec<[S; MEMORY]>,
    /// First slack line, if any.
    pub slack: Option<Slack>,
    /// Centre of mass, hull axes, from the mid-point of the suspension points, m.
    pub cm_m: V3<S>,
    /// Acceleration of free fall, m/s².
    pub gravity_m_s2: S,
}

/// A piece of the path.
#[derive(Debug, Clone, Copy)]
struct Piece {
    from_s: f64,
    length_s: f64,
}

/// The body at one instant of its path.
#[derive(Debug, Clone, Copy)]
pub struct Moment<S: Real> {
    /// Centre of mass, world axes, m.
    pub position: V3<S>,
    /// Quaternion w, x, y, z, `world_from_hull`, of unit size to rounding at the ends of steps.
    pub attitude: [S; 4],
    /// Velocity of the centre of mass, world axes, m/s.
    pub velocity: V3<S>,
    /// Angular rate, hull axes, rad/s.
    pub rate: V3<S>,
    /// Acceleration of the centre of mass, world axes, m/s².
    pub acceleration: V3<S>,
    /// Angular acceleration, hull axes, rad/s².
    pub angular_acceleration: V3<S>,
}

impl<S: Real> Moment<S> {
    /// From a state and its derivative.
    pub(super) fn new(y: &[S], slope: &[S]) -> Self {
        let vector = |of: &[S], i: usize| V3::new(of[i], of[i + 1], of[i + 2]);
        Self {
            position: vector(y, PLACE),
            attitude: [0, 1, 2, 3].map(|i| y[ATTITUDE + i]),
            velocity: vector(y, VELOCITY),
            rate: vector(y, RATE),
            acceleration: vector(slope, VELOCITY),
            angular_acceleration: vector(slope, RATE),
        }
    }

    /// `world_from_hull`.
    pub fn turn(&self) -> M3<S> {
        matrix(&self.attitude)
    }

    /// The same body over other numbers.
    fn map<T: Real>(&self, f: impl Fn(S) -> T + Copy) -> Moment<T> {
        Moment {
            position: self.position.map(f),
            attitude: self.attitude.map(f),
            velocity: self.velocity.map(f),
            rate: self.rate.map(f),
            acceleration: self.acceleration.map(f),
            angular_acceleration: self.angular_acceleration.map(f),
        }
    }

    /// The same place, held still.
    pub fn stopped(&self) -> Self {
        let still = V3::zeros();
        let (velocity, rate, acceleration, angular_acceleration) = (still, still, still, still);
        Self {
            velocity,
            rate,
            acceleration,
            angular_acceleration,
            ..*self
        }
    }
}

/// Newton steps onto the constraints after each step of the integration: it leaves them by rounding
/// or a little more.
const PROJECTIONS: usize = 1;
/// Pieces that what happens once is made of at least, a push of half a sine as any.
const PIECES_OF_EVENTS: f64 = 4.0;
/// What happens within less, s, is refused: times of a long motion are not told apart much better.
const QUICKEST_S: f64 = 1e-6;
/// A piece that ends so near to where it begins or ends, shares of its length, ends there.
const AT_AN_END: f64 = 1e-6;
/// What rounding makes of a step at most (m, m/s, 1, rad/s), and of a derivative times the number
/// differentiated by: some fifty times the last digit of a metre. No halving mends it.
const ROUNDING: f64 = 1e-14;

/// How finely a motion is computed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fineness {
    /// Steps per period of the fastest mode.
    pub steps_per_period: f64,
    /// A step with a larger error (m, m/s, 1, rad/s, units of the effects' memories; of
    /// derivatives, as a part of the largest by the same parameter, unless it is rounding) is
    /// halved: those that cross the kink of a drag or of a friction. On the smooth motions of a
    /// swing the error is smaller than this by itself.
    pub largest_error: f64,
    /// A step is halved no oftener than this.
    pub most_halvings: u32,
    /// A motion of more pieces is refused.
    pub most_pieces: usize,
}

impl Fineness {
    /// Leaves the energy of wide swings to 1e-10 over ten minutes, the periods to better than 1e-9
    /// (`tests/simulation`). A path of more pieces would take hundreds of megabytes, with
    /// derivatives gigabytes.
    pub const FULL: Self = Self {
        steps_per_period: 30.0,
        largest_error: 1e-9,
        most_halvings: 20,
        most_pieces: 200_000,
    };
    /// Leaves derivatives of smooth motions to 1e-7 of their largest value
    /// (`tests/simulation/derivatives`).
    pub const OF_DERIVATIVES: Self = Self {
        steps_per_period: 20.0,
        largest_error: 1e-8,
        ..Self::FULL
    };
    /// The same across kinks: larger steps now and then go over one unseen.
    pub const OF_KINKED_DERIVATIVES: Self = Self {
        steps_per_period: 60.0,
        largest_error: 1e-11,
        most_halvings: 30,
        ..Self::FULL
    };
    /// For the comparison of smooth motions with samples: headings are right to 1e-6 rad after two
    /// minutes (`tests/simulation/damping`), far below the noise of any phone, and trial bodies on
    /// which no motion of that length can be computed are refused at once.
    pub const OF_FITS: Self = Self {
        steps_per_period: 8.0,
        most_halvings: 0,
        most_pieces: 60_000,
        ..Self::FULL
    };
    /// For derivatives that lead a fit of smooth motions on its way: right to 3 % of their largest
    /// value over two minutes, most to 1e-3 (`tests/simulation/derivatives`).
    pub const OF_SLOPES_OF_FITS: Self = Self {
        steps_per_period: 5.0,
        ..Self::OF_FITS
    };
    /// The same across kinks.
    pub const OF_KINKED_FITS: Self = Self {
        steps_per_period: 12.0,
        largest_error: 1e-6,
        most_halvings: 5,
        ..Self::OF_FITS
    };
}

/// An integration under way.
struct Integration<'a, S: Real> {
    equations: &'a Equations<S>,
    stepper: Stepper<S>,
    state: Vec<S>,
    end: Vec<S>,
    end_slope: Vec<S>,
    tension_n: [f64; MOST_LINES],
    path: Path<S>,
    fineness: Fineness,
    /// What happens once: when it begins, s, and how long it lasts, s.
    events_s: Vec<[f64; 2]>,
    /// Sizes of the numbers differentiated by.
    sizes: Vec<f64>,
}

impl<'a, S: Real> Integration<'a, S> {
    fn new(
        equations: &'a Equations<S>,
        start: Vec<S>,
        sizes: Vec<f64>,
        step_s: f64,
        fineness: Fineness,
    ) -> Self {
        let size = equations.size();
        let mut stepper = Stepper::new(size);
        let tension_n = equations
            .slope(&start, stepper.first_slope())
            .tension_n
            .map(Real::value);
        let path = Path {
            step_s,
            pieces: Vec::new(),
            first: vec![0],
            coefficients: Vec::new(),
            slack: None,
            cm_m: equations.system.cm_m,
            gravity_m_s2: equations.system.gravity_m_s2,
        };
        let zeros = || vec![S::zero(); size];
        let (state, end, end_slope) = (start, zeros(), zeros());
        let events_s = equations.events_s();
        Self {
            equations,
            stepper,
            state,
            end,
            end_slope,
            tension_n,
            path,
            fineness,
            events_s,
            sizes,
        }
    }

    /// One piece, or two of half its length, and so on.
    fn advance(&mut self, piece: Piece, halvings: u32) -> Result<()> {
        if let Some(first_s) = self.parted_by_events(piece) {
            return self.advance_parts(piece, first_s, halvings);
        }
        let equations = self.equations;
        let mut f = |y: &[S], out: &mut [S]| {
            equations.slope(y, out);
        };
        if !self.events_s.is_empty() {
            // A law that begins or ends here may do so with a jump of its derivatives.
            equations.keep_inside(piece.from_s, piece.from_s + piece.length_s);
            f(&self.state, self.stepper.first_slope());
        }
        self.stepper
            .advance(&mut f, &self.state, piece.length_s, &mut self.end);
        if halvings < self.fineness.most_halvings && self.is_rough(piece.length_s) {
            return self.advance_parts(piece, 0.5 * piece.length_s, halvings + 1);
        }
        self.accept(piece)
    }

    fn advance_parts(&mut self, piece: Piece, first_s: f64, halvings: u32) -> Result<()> {
        self.advance(
            Piece {
                length_s: first_s,
                ..piece
            },
            halvings,
        )?;
        let (from_s, length_s) = (piece.from_s + first_s, piece.length_s - first_s);
        self.advance(Piece { from_s, length_s }, halvings)
    }

    /// Length of the first part of a piece that meets something that happens once: it ends where
    /// that begins or ends, or is a half where the piece is long against it.
    fn parted_by_events(&self, piece: Piece) -> Option<f64> {
        self.events_s.iter().find_map(|[begins_s, over_s]| {
            let (begins_s, ends_s) = (begins_s - piece.from_s, begins_s + over_s - piece.from_s);
            let room_s = AT_AN_END * over_s;
            let is_inside = |t_s: &f64| (room_s..piece.length_s - room_s).contains(t_s);
            let is_long = begins_s < piece.length_s - room_s
                && ends_s > room_s
                && piece.length_s > over_s / PIECES_OF_EVENTS;
            let half_s = is_long.then_some(0.5 * piece.length_s);
            [begins_s, ends_s].into_iter().find(is_inside).or(half_s)
        })
    }

    /// Whether the step just made has too large an error: in the body's state or in the effects'
    /// memories.
    fn is_rough(&mut self, h: f64) -> bool {
        self.stepper.estimate();
        let (end, largest) = (self.end.len(), self.fineness.largest_error);
        [PLACE..MEMORY, MEMORY..end].into_iter().any(|watched| {
            let error = |part: &dyn Fn(&S) -> f64| self.stepper.error(h, watched.clone(), part);
            let is_rough_in = |lane: usize| {
                let slope = |x: &S| x.slopes()[lane];
                let most = self.end[watched.clone()]
                    .iter()
                    .map(|x| slope(x).abs())
                    .fold(0.0, f64::max);
                error(&slope) > (largest * most).max(ROUNDING / self.sizes[lane])
            };
            error(&|x| x.value()) > largest || (0..self.sizes.len()).any(is_rough_in)
        })
    }

    fn accept(&mut self, piece: Piece) -> Result<()> {
        if self.path.pieces.len() == self.fineness.most_pieces {
            return Err(too_long(self.fineness.most_pieces));
        }
        let equations = self.equations;
        let mut f = |y: &[S], out: &mut [S]| {
            equations.slope(y, out);
        };
        equations.project(&mut self.end, PROJECTIONS);
        let tension_n = equations
            .slope(&self.end, &mut self.end_slope)
            .tension_n
            .map(Real::value);
        if !self.end.iter().all(|x| x.value().is_finite()) {
            let text = format!("it cannot be continued after {} s", piece.from_s);
            return Err(Error::no_result("motion", text));
        }
        let (ends, out) = (
            (&self.state[..], &self.end[..]),
            &mut self.path.coefficients,
        );
        self.stepper
            .between(&mut f, ends, &self.end_slope, piece.length_s, out);
        self.path.pieces.push(piece);
        self.path.note_slack(
            piece,
            &self.tension_n,
            &tension_n,
            equations.system.cords.len(),
        );
        std::mem::swap(&mut self.state, &mut self.end);
        self.tension_n = tension_n;
        Ok(())
    }
}

fn too_long(most_pieces: usize) -> Error {
    Error::no_result("motion", format!("it takes more than {most_pieces} steps"))
}

impl<S: Real> Path<S> {
    /// Integrates from `start`, which keeps the constraints already, over `duration_s` in steps of
    /// `step_s`; `sizes` are those of the numbers differentiated by.
    pub(super) fn integrate(
        equations: &Equations<S>,
        start: Vec<S>,
        sizes: Vec<f64>,
        duration_s: f64,
        step_s: f64,
        fineness: Fineness,
    ) -> Result<Self> {
        for (name, value) in [("duration_s", duration_s), ("step_s", step_s)] {
            if !(value.is_finite() && value > 0.0) {
                return Err(Error::argument(name, "a positive number", value));
            }
        }
        let steps = (duration_s / step_s).ceil();
        if steps > fineness.most_pieces as f64 {
            return Err(too_long(fineness.most_pieces));
        }
        let steps = steps as usize;
        let mut integration = Integration::new(equations, start, sizes, step_s, fineness);
        if let Some([_, over_s]) = integration
            .events_s
            .iter()
            .find(|[_, over_s]| *over_s < QUICKEST_S)
        {
            let text =
                format!("something that happens within {over_s} s is too quick to be followed");
            return Err(Error::no_result("motion", text));
        }
        integration.path.coefficients.reserve(steps * COEFFICIENTS);
        for n in 0..steps {
            integration.advance(
                Piece {
                    from_s: n as f64 * step_s,
                    length_s: step_s,
                },
                0,
            )?;
            integration.path.first.push(integration.path.pieces.len());
        }
        Ok(integration.path)
    }

    /// Keeps the first zero of a tension, by a straight line between the ends of the piece.
    fn note_slack(&mut self, piece: Piece, before: &[f64], after: &[f64], count: usize) {
        if self.slack.is_some() {
            return;
        }
        let zero = |line: usize| {
            let (b, a) = (before[line], after[line]);
            let part = if b > a {
                (b / (b - a)).clamp(0.0, 1.0)
            } else {
                0.0
            };
            (a <= 0.0).then_some(Slack {
                t_s: piece.from_s + part * piece.length_s,
                line,
            })
        };
        self.slack = (0..count)
            .filter_map(zero)
            .min_by(|a, b| a.t_s.total_cmp(&b.t_s));
    }

    /// Length, s.
    pub fn duration_s(&self) -> f64 {
        (self.first.len() - 1) as f64 * self.step_s
    }

    /// The body at `t_s`; outside of the path its first or last piece is continued.
    pub fn at(&self, t_s: f64) -> Moment<S> {
        let n = self.piece_at(t_s);
        let x = (t_s - self.pieces[n].from_s) / self.pieces[n].length_s;
        self.moment(n, between::<S, MEMORY, VELOCITY>(self.rows(n), x))
    }

    /// The same at a time that has derivatives of its own.
    pub fn at_time(&self, t_s: S) -> Moment<S> {
        if is_still(t_s) {
            return self.at(t_s.value());
        }
        let (n, x) = self.place_of(t_s);
        self.moment(n, between_moving::<S, MEMORY, VELOCITY>(self.rows(n), x))
    }

    /// The piece of a time, and the time as a fraction of it.
    fn place_of<T: Real>(&self, t_s: T) -> (usize, T) {
        let n = self.piece_at(t_s.value());
        let Piece { from_s, length_s } = self.pieces[n];
        (n, (t_s - T::constant(from_s)).scale(1.0 / length_s))
    }

    fn piece_at(&self, t_s: f64) -> usize {
        let step = ((t_s / self.step_s) as usize).min(self.first.len() - 2);
        let mut n = self.first[step];
        while n + 1 < self.first[step + 1] && self.pieces[n + 1].from_s <= t_s {
            n += 1;
        }
        n
    }

    fn rows(&self, n: usize) -> &[[S; MEMORY]] {
        &self.coefficients[n * COEFFICIENTS..][..COEFFICIENTS]
    }

    /// From the state and its derivative by the fraction of piece `n`.
    fn moment<T: Real>(&self, n: usize, (y, mut slope): ([T; MEMORY], [T; MEMORY])) -> Moment<T> {
        let per_s = 1.0 / self.pieces[n].length_s;
        slope[VELOCITY..]
            .iter_mut()
            .for_each(|part| *part = part.scale(per_s));
        Moment::new(&y, &slope)
    }

    /// Length of the first piece, s: so far the path can be continued backwards.
    pub(super) fn first_piece_s(&self) -> f64 {
        self.pieces[0].length_s
    }

    /// The state at the end of step `n`, without the effects' memories.
    pub fn knot(&self, n: usize) -> Moment<S> {
        self.at(n as f64 * self.step_s)
    }
}

impl Path<f64> {
    /// The body of a motion without derivatives at a time that has some.
    pub(super) fn as_seen_at<S: Real>(&self, t_s: S) -> Moment<S> {
        if is_still(t_s) {
            return self.at(t_s.value()).map(S::constant);
        }
        let (n, x) = self.place_of(Dual::<1>::parameter(t_s.value(), 0));
        let rows: Vec<_> = self
            .rows(n)
            .iter()
            .map(|row| row.map(Dual::constant))
            .collect();
        let parts = between_moving::<Dual<1>, MEMORY, VELOCITY>(&rows, x);
        let by_time = |part: Dual<1>| t_s.chain(part.value, part.slope[0]);
        self.moment(n, parts).map(by_time)
    }
}
