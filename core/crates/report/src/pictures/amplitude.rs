//! Period and decay of a mode against its amplitude.

use super::Figure;
use crate::chart::{Mark, Panel, colour, stacked};
use crate::digits::{prefix, with_u};
use crate::scale::{drawable, extent};
use crate::words::{self, figure, id_in, plain, say};
use gyradius_base::language::Language;
use gyradius_identification::{AmplitudePoint, AmplitudeUnit, ModeResult, SwingResult};

/// Fewer windows than this show no dependence.
const LEAST_POINTS: usize = 2;

/// One picture for each mode of a swing that was seen at more than one amplitude.
pub(crate) fn against_amplitude(swing: &SwingResult, language: Language) -> Vec<Figure> {
    swing
        .modes
        .iter()
        .enumerate()
        .filter_map(|(i, mode)| picture(swing, i, mode, language))
        .collect()
}

fn picture(swing: &SwingResult, i: usize, mode: &ModeResult, language: Language) -> Option<Figure> {
    let points: Vec<&AmplitudePoint> = mode
        .against_amplitude
        .iter()
        .filter(|p| is_drawable(p))
        .collect();
    if points.len() < LEAST_POINTS || !drawable(mode.period_s) {
        return None;
    }
    let data = Columns::of(&points, mode, language);
    let named = [
        ("swing", plain(id_in(&swing.id, language))),
        ("mode", plain(words::mode_text(mode.mode, language))),
    ];
    let title = say(language, "against_amplitude", named);
    let panels = [data.period_panel(language), data.decrement_panel(language)];
    let svg = stacked(&title, &panels, language);
    let limit = figure(with_u(mode.period_s, mode.period_se_s));
    let caption = say(language, "each_window", [("limit", limit)]);
    let id = format!(
        "{}-amplitude-{}-{}",
        swing.id,
        i + 1,
        words::mode_id(mode.mode)
    );
    Some(Figure::new(&id, title, caption, svg))
}

fn is_drawable(point: &AmplitudePoint) -> bool {
    drawable(point.amplitude) && drawable(point.period_s)
}

/// Columns to draw, in the units of the picture.
struct Columns {
    amplitude: Vec<f64>,
    amplitude_label: String,
    range: [f64; 2],
    shift: Vec<f64>,
    shift_u: Vec<f64>,
    limit_u: f64,
    heading: String,
    decrement: Vec<f64>,
    decrement_u: Vec<f64>,
}

impl Columns {
    fn of(points: &[&AmplitudePoint], mode: &ModeResult, language: Language) -> Self {
        let (factor, amplitude_label) = match mode.amplitude_unit {
            AmplitudeUnit::Radian => (1f64.to_degrees(), "amplitude_degrees"),
            AmplitudeUnit::Metre => (1e3, "amplitude_mm"),
            AmplitudeUnit::RadianPerSecond => (1f64.to_degrees(), "amplitude_degrees_s"),
            AmplitudeUnit::None => (1.0, "amplitude_bare"),
        };
        let column =
            |value: fn(&AmplitudePoint) -> f64| points.iter().map(|p| value(p)).collect::<Vec<_>>();
        let amplitude: Vec<f64> = points.iter().map(|p| factor * p.amplitude).collect();
        let largest = points
            .iter()
            .map(|p| (p.period_s - mode.period_s).abs())
            .fold(0.0, f64::max);
        let (scale, letter) = prefix(largest);
        let top = extent(amplitude.iter().copied()).map_or(1.0, |[_, high]| high);
        Self {
            range: [0.0, if top > 0.0 { 1.05 * top } else { 1.0 }],
            amplitude,
            amplitude_label: say(language, amplitude_label, []),
            shift: points
                .iter()
                .map(|p| scale * (p.period_s - mode.period_s))
                .collect(),
            shift_u: points.iter().map(|p| scale * p.period_se_s).collect(),
            limit_u: scale * mode.period_se_s,
            heading: say(
                language,
                "period_less_limit",
                [("unit", plain(format!("{letter}s")))],
            ),
            decrement: column(|p| p.decrement),
            decrement_u: column(|p| p.decrement_se),
        }
    }

    fn period_panel(&self, language: Language) -> Panel<'_> {
        let limit = Mark::Level {
            y: 0.0,
            u: self.limit_u,
            name: say(language, "small_amplitude_limit", []),
        };
        let dots = Mark::Points {
            x: &self.amplitude,
            y: &self.shift,
            u: &self.shift_u,
            colour: colour::MODEL,
        };
        self.panel(
            self.heading.clone(),
            String::new(),
            110.0,
            vec![limit, dots],
        )
    }

    fn decrement_panel(&self, language: Language) -> Panel<'_> {
        let dots = Mark::Points {
            x: &self.amplitude,
            y: &self.decrement,
            u: &self.decrement_u,
            colour: colour::MODEL,
        };
        self.panel(
            say(language, "decrement_per_cycle", []),
            self.amplitude_label.clone(),
            90.0,
            vec![dots],
        )
    }

    fn panel<'a>(
        &self,
        heading: String,
        x_label: String,
        height: f64,
        marks: Vec<Mark<'a>>,
    ) -> Panel<'a> {
        Panel {
            heading,
            legend: vec![],
            x_label,
            x_range: Some(self.range),
            log_y: false,
            height,
            marks,
        }
    }
}
