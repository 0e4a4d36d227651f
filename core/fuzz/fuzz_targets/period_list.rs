//! A list of periods from any bytes.
#![no_main]

use gyradius_core::recording::read_period_list;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Ok(list) = read_period_list(bytes, "fuzz.csv") else {
        return;
    };
    assert!(list.t_s.windows(2).all(|pair| pair[0] < pair[1]));
    assert!(
        list.period_s
            .iter()
            .all(|period| *period > 0.0 && period.is_finite())
    );
});
