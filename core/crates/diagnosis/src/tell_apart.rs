//! The swing that would tell two causes apart which somebody names, whether the criticism would
//! have named them or not.

use gyradius_base::error::{Error, Result};
use gyradius_base::progress::tell;
use gyradius_identification::measure::{Prepared, prepare};
use gyradius_identification::{MeasureOptions, analyse};
use gyradius_recording::{LoadedData, LoadedSession};

use super::base::by_periods;
use super::by_periods::tell_apart_by_periods;
use super::cause_id::CauseId;
use super::fitted_swing::Base;
use super::found::Found;
use super::found::Tried;
use super::next_swing::{Explained, next_swing};
use super::point::Model;
use super::result::{NextSwing, Progress};

/// The swing, among those thought of, in which the two causes, each fitted to the session beside
/// nothing else, differ most: that of the criticism's verdict, for causes of one's own choice.
///
/// # Errors
/// [`Error::Argument`] for a cause that this kind of session does not show; [`Error::NoResult`]
/// where the session cannot be simulated, or no swing tells the two.
pub fn tell_apart(
    loaded: &LoadedSession,
    causes: [CauseId; 2],
    progress: &Progress,
) -> Result<NextSwing> {
    if causes[0] == causes[1] {
        return Err(Error::argument(
            "tell_apart",
            "two different causes",
            causes[0],
        ));
    }
    tell(progress, 0.0, "reading the swings")?;
    if !loaded
        .data
        .iter()
        .any(|data| matches!(data.data, LoadedData::Recording(_)))
    {
        let found = tell_apart_by_periods(
            loaded,
            &analyse(loaded, &MeasureOptions::default())?,
            causes,
        )?;
        return found.ok_or_else(|| not_told(causes));
    }
    let mut prepared = prepare(loaded)?;
    let x = by_periods(&mut prepared);
    tell(progress, 0.05, "fitting each swing")?;
    let Prepared {
        works,
        system,
        inclines,
        ..
    } = prepared;
    let Some((mut base, start)) = Base::begin(&system, &works, &inclines, &x)? else {
        let reason = "no swing on two lines that a simulation can be fitted to";
        return Err(Error::no_result("telling causes apart", reason));
    };
    tell(progress, 0.3, "fitting all swings together")?;
    let fitted = base.fit(&start)?;
    let model = Model::of(&base);
    let found = Found::begun(model, start, fitted)?;
    tell(progress, 0.5, "fitting the two causes")?;
    let [one, other] = [found.by_name(causes[0])?, found.by_name(causes[1])?];
    let models = [&one, &other].map(|tried: &Tried| found.model.with(&tried.cause));
    tell(progress, 0.7, "looking for the swing")?;
    let next = next_swing(
        &Explained {
            model: &models[0],
            point: &one.fitted.point,
            id: one.cause.id,
        },
        &Explained {
            model: &models[1],
            point: &other.fitted.point,
            id: other.cause.id,
        },
    );
    next.ok_or_else(|| not_told(causes))
}

fn not_told([one, other]: [CauseId; 2]) -> Error {
    Error::no_result(
        "telling causes apart",
        format!("no swing thought of tells {one} from {other}"),
    )
}
