//! The run that a column's name says it is of: `Run 1: Time (s)`, `Data Set 2:Angle(rad)`,
//! `Time (s) Run #3`, `time_2`, `x2 (mm)`.

/// What programs call a run.
const WORDS: [&str; 6] = ["run", "trial", "data set", "dataset", "series", "take"];
/// What Logger Pro calls the run that is not stored yet.
const LATEST: &str = "latest";

/// A column's name taken apart.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct RunLabel {
    /// Its number, or its word where it has none.
    pub run: String,
    /// The name without it.
    pub rest: String,
    /// Whether a word says that it is a run; else it is a bare number.
    pub is_worded: bool,
}

/// The run that a name tells.
pub(super) fn run_of(name: &str) -> Option<RunLabel> {
    in_front(name).or_else(|| behind(name))
}

/// The name without a run that is told in words.
pub(super) fn without_run(name: &str) -> String {
    match run_of(name).filter(|label| label.is_worded) {
        Some(label) => label.rest,
        None => name.to_owned(),
    }
}

/// `Run 1: Time (s)`, `Data Set 1:Time(s)`, `Latest: Time (s)`.
fn in_front(name: &str) -> Option<RunLabel> {
    let (run, rest) = name.split_once(':')?;
    let (word, number) = numbered(run.trim());
    let is_known = WORDS.iter().any(|known| word.eq_ignore_ascii_case(known));
    let run = match number {
        Some(number) if is_known => number,
        None if word.eq_ignore_ascii_case(LATEST) => word,
        _ => return None,
    };
    Some(RunLabel {
        run: run.to_owned(),
        rest: rest.trim().to_owned(),
        is_worded: true,
    })
}

/// `Time (s) Run #1`, `angle_1`, `x1 (mm)`.
fn behind(name: &str) -> Option<RunLabel> {
    let name = name.trim();
    let at = match name.ends_with([')', ']']) {
        true => name.rfind(['(', '['])?,
        false => name.len(),
    };
    let (bare, unit) = name.split_at(at);
    let (rest, number) = numbered(bare.trim_end());
    let word = WORDS.iter().find_map(|word| {
        let start = rest.len().checked_sub(word.len())?;
        let is_it = rest.get(start..)?.eq_ignore_ascii_case(word);
        let before = rest.get(..start)?;
        (is_it && !before.ends_with(char::is_alphanumeric)).then_some(before)
    });
    let left = word.unwrap_or(rest).trim_end_matches([' ', '_', '-', ',']);
    let run = number.filter(|_| !left.is_empty())?;
    Some(RunLabel {
        run: run.to_owned(),
        rest: format!("{left} {unit}").trim_end().to_owned(),
        is_worded: word.is_some(),
    })
}

/// A name and the number at its end.
fn numbered(name: &str) -> (&str, Option<&str>) {
    let bare = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let number = &name[bare.len()..];
    let bare = bare.trim_end_matches([' ', '#', '_', '-']);
    (bare, (!number.is_empty()).then_some(number))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_real_programs_are_taken_apart() {
        let of = |name: &str| run_of(name).map(|l| (l.run, l.rest, l.is_worded));
        let told = |run: &str, rest: &str, is_worded| Some((run.into(), rest.into(), is_worded));
        // Logger Pro, Graphical Analysis, Capstone.
        assert_eq!(of("Run 1: Time (s)"), told("1", "Time (s)", true));
        assert_eq!(
            of("Latest: Angle (rad)"),
            told("Latest", "Angle (rad)", true)
        );
        assert_eq!(of("Data Set 12:Angle(rad)"), told("12", "Angle(rad)", true));
        assert_eq!(of("Time (s) Run #3"), told("3", "Time (s)", true));
        assert_eq!(
            of("Angular Velocity (rad/s) Run #3"),
            told("3", "Angular Velocity (rad/s)", true)
        );
        assert_eq!(of("time_2"), told("2", "time", false));
        assert_eq!(of("x2 (mm)"), told("2", "x (mm)", false));
        for plain in [
            "Time (s)",
            "t",
            "gx",
            "clock: s",
            "Acceleration x (m/s^2)",
            "7",
        ] {
            assert_eq!(of(plain), None, "{plain}");
        }
    }
}
