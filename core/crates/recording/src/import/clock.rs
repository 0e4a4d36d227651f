//! Time that is written as text: a clock, or a date and a clock.

/// A text as seconds on its own clock, and whether it has a date; `None` where it is no time.
///
/// # Conventions
/// `2024-05-06 10:27:38.103 +0200`, `2024/05/06T10:27:38,103`, `10:27:38.103`, `10:27:38 PM`,
/// `27:38.103` (minutes), `10:27:38:103` (ms) and `2024-05-06T10.27.38.103`. A year comes first or
/// the date is passed over: days then follow from the clock. The zone does not change in a record.
pub(super) fn seconds_of_text(text: &str) -> Option<(f64, bool)> {
    let text = text.trim();
    let mut tokens = text
        .split([' ', 'T', '_', 'Z'])
        .filter(|token| !token.is_empty());
    let date = tokens.clone().next().and_then(days);
    let clock = tokens.find_map(clock)?;
    let after = text.to_uppercase();
    let hour = (clock / 3600.0).floor();
    let half_day = match () {
        _ if after.ends_with("PM") && hour < 12.0 => 43_200.0,
        _ if after.ends_with("AM") && (12.0..13.0).contains(&hour) => -43_200.0,
        _ => 0.0,
    };
    let of_date = date.map_or(0.0, |days| days as f64 * 86_400.0);
    Some((of_date + clock + half_day, date.is_some()))
}

/// The day in a text that begins with a date, as `2024-05-06`.
pub(super) fn date_of_text(text: &str) -> Option<String> {
    let date = text.trim().split([' ', 'T', '_']).next()?;
    days(date).map(|_| date.replace('/', "-"))
}

/// Times in order: where only the clock is written, it goes on past midnight.
pub(super) fn unwrapped(texts: &[String]) -> Vec<Option<f64>> {
    let mut days_s = 0.0;
    let mut last: Option<f64> = None;
    let mut one = |text: &String| {
        let (seconds, dated) = seconds_of_text(text)?;
        if !dated && last.is_some_and(|last| seconds < last - 43_200.0) {
            days_s += 86_400.0;
        }
        last = Some(seconds);
        Some(seconds + days_s)
    };
    texts.iter().map(&mut one).collect()
}

/// `10:27:38.103` and its like as seconds of the day.
fn clock(token: &str) -> Option<f64> {
    let token = token.split(['+', '-', 'A', 'P', 'a', 'p']).next()?;
    let separator = if token.contains(':') { ':' } else { '.' };
    let parts: Vec<&str> = token.split(separator).collect();
    let digits = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    let whole = |text: &str| {
        text.parse::<f64>()
            .ok()
            .filter(|_| digits(text) && text.len() <= 2)
    };
    let second = |text: &str| {
        let text = text.replace(',', ".");
        let (whole_part, rest) = text.split_once('.').unwrap_or((&text, "0"));
        (digits(whole_part) && digits(rest) && whole_part.len() <= 2)
            .then(|| text.parse::<f64>().ok())
            .flatten()
    };
    match parts[..] {
        [h, m, s] if separator == ':' => Some(3600.0 * whole(h)? + 60.0 * whole(m)? + second(s)?),
        // Minutes and seconds, as a video's time; hours and minutes have no fraction.
        [m, s] if separator == ':' && s.contains(['.', ',']) => Some(60.0 * whole(m)? + second(s)?),
        [h, m] if separator == ':' => Some(3600.0 * whole(h)? + 60.0 * whole(m)?),
        // Two digits are the frames of a time code, which need a rate.
        [h, m, s, fraction] if digits(fraction) && (3..=9).contains(&fraction.len()) => {
            let seconds = second(&format!("{s}.{fraction}"))?;
            Some(3600.0 * whole(h)? + 60.0 * whole(m)? + seconds)
        }
        _ => None,
    }
}

/// `2024-05-06` or `2024/05/06` as days since 1970.
fn days(token: &str) -> Option<i64> {
    let mut parts = token.split(['-', '/']).map(|part| part.parse::<i64>().ok());
    let (year, month, day) = (parts.next()??, parts.next()??, parts.next()??);
    let in_range =
        (1000..=9999).contains(&year) && (1..=12).contains(&month) && (1..=31).contains(&day);
    (in_range && parts.next().is_none()).then(|| days_since_1970(year, month, day))
}

/// Days of the Gregorian calendar, years counted from March so that the leap day is the last.
fn days_since_1970(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let month = (month + 9) % 12;
    let day_of_year = (153 * month + 2) / 5 + day - 1;
    365 * year + year.div_euclid(4) - year.div_euclid(100) + year.div_euclid(400) + day_of_year
        - 719_468
}
