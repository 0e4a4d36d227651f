//! Every valid session survives writing and reading; no text and no archive makes the readers
//! panic.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::collections::BTreeMap;

use gyradius_recording::{
    AddedMass, Attachment, Body, End, Excitation, Incline, InclineAngle, Instrument,
    InstrumentKind, ModeName, Orientation, Quantity, Recorded, RecordedEvent, RecordedRepair,
    RecordedSensor, RepairKind, Sensor, Session, Site, Store, Suspension, SuspensionKind, Swing,
    SwingData, load_store, read_session, session_zip_bytes, write_session,
    write_session_to_fill_in,
};
use gyradius_test_support::cases;
use proptest::collection::{btree_map, vec};
use proptest::option::of;
use proptest::prelude::*;
use proptest::sample::{Index, select};

const EXAMPLE: &str = include_str!("../fixtures/session-example.toml");

fn quantity(value: impl Strategy<Value = f64>) -> impl Strategy<Value = Quantity> {
    (value, prop_oneof![Just(0.0), 1e-12..10.0]).prop_map(|(value, u)| Quantity::new(value, u))
}

fn positive() -> impl Strategy<Value = f64> {
    prop_oneof![
        1e-3..1e3,
        Just(1.0),
        Just(5e-324),
        Just(1e12),
        1e-200..1e-190
    ]
}

fn vector(low: f64) -> impl Strategy<Value = [f64; 3]> {
    [low..9.0, low..9.0, low..9.0]
}

/// Free text: quotes, line ends, anything but what no session can hold.
fn text() -> impl Strategy<Value = String> {
    prop_oneof![any::<String>(), "[ -~\\n\"'\\\\]{0,20}"]
}

fn file() -> impl Strategy<Value = String> {
    "[a-zA-Z0-9 _ä=#\"'-]{1,8}(/[a-z.]{1,3}[a-z]){0,2}\\.csv"
}

fn mode() -> impl Strategy<Value = ModeName> {
    use ModeName::*;
    select(vec![
        Yaw,
        Sway,
        PitchInPhase,
        PitchOutOfPhase,
        RollInPhase,
        RollOutOfPhase,
        Compound,
        Other,
    ])
}

fn excitation() -> impl Strategy<Value = Excitation> {
    use Excitation::*;
    select(vec![Yaw, Sway, Surge, Pitch, Roll])
}

prop_compose! {
    /// The mass leaves room for the attachments.
    fn body()(name in text(), mass in of(quantity(1e4..1e6)), length in of(positive()), density in of(2.0..2e4))
        -> Body
    {
        Body { name, mass_kg: mass, length_overall_m: length, density_kg_m3: density }
    }
}

prop_compose! {
    fn site()(gravity in of(quantity(1.0..30.0)), latitude in of(-90.0..=90.0), altitude in of(-1e3..2e4),
        air in of(0.0..1.9)) -> Site
    {
        let latitude_deg = latitude.filter(|_| gravity.is_none());
        Site { gravity_m_s2: gravity, latitude_deg, altitude_m: altitude.filter(|_| latitude_deg.is_some()),
            air_density_kg_m3: air }
    }
}

prop_compose! {
    fn attachment()(name in text(), mass in quantity(1e-3..1e3), position in vector(-9.0), gyradii in vector(0.0))
        -> Attachment
    {
        Attachment { name, mass_kg: mass, position_m: position, position_u_m: 0.0, gyradii_m: gyradii }
    }
}

fn added_mass() -> impl Strategy<Value = AddedMass> {
    (quantity(positive()), vector(-9.0)).prop_map(|(mass_kg, position_m)| AddedMass {
        mass_kg,
        position_m,
    })
}

fn orientation() -> impl Strategy<Value = Orientation> {
    select(vec![Orientation::Athwartships, Orientation::ForeAndAft])
}

fn bifilar() -> impl Strategy<Value = Suspension> {
    let lengths = (
        quantity(2.0..50.0),
        quantity(0.1..3.0),
        of(quantity(0.1..3.0)),
    );
    (
        orientation(),
        lengths,
        of(quantity(-90.0..90.0)),
        of(quantity(-3.0..3.0)),
    )
        .prop_map(
            |(orientation, (line, spacing, top), pitch, moved)| Suspension {
                line_length_m: Some(line),
                spacing_m: Some(spacing),
                top_spacing_m: top,
                hull_pitch_deg: pitch,
                points_moved_m: moved,
                ..Suspension::unmeasured(SuspensionKind::Bifilar, orientation)
            },
        )
}

fn compound() -> impl Strategy<Value = Suspension> {
    (
        orientation(),
        quantity(positive()),
        of(quantity(-90.0..90.0)),
    )
        .prop_map(|(orientation, height, pitch)| Suspension {
            hull_pitch_deg: pitch,
            axis_height_m: Some(height),
            ..Suspension::unmeasured(SuspensionKind::Compound, orientation)
        })
}

/// Data with the amplitudes that may stand beside them.
fn data() -> impl Strategy<Value = (SwingData, BTreeMap<ModeName, f64>)> {
    let alone = |data: SwingData| (data, BTreeMap::new());
    prop_oneof![
        file().prop_map(move |file| alone(SwingData::Recording(file))),
        (file(), of(vector(-9.0)))
            .prop_map(move |(file, at_m)| alone(SwingData::Displacement { file, at_m })),
        (file(), btree_map(mode(), 0.0..180.0, 0..3))
            .prop_map(|(file, amplitudes)| (SwingData::Periods(file), amplitudes)),
        btree_map(mode(), (quantity(positive()), of(0.0..180.0)), 1..4).prop_map(|both| {
            let amplitudes = both
                .iter()
                .filter_map(|(mode, (_, angle))| angle.map(|angle| (*mode, angle)));
            let amplitudes = amplitudes.collect();
            (
                SwingData::PeriodsS(
                    both.into_iter()
                        .map(|(mode, (period, _))| (mode, period))
                        .collect(),
                ),
                amplitudes,
            )
        }),
    ]
}

prop_compose! {
    fn swing()(id in "[^\\p{C}]{0,5}", (data, amplitude_deg) in data(), excited in vec(excitation(), 0..3),
        added_masses in vec(added_mass(), 0..3), suspension in prop_oneof![bifilar(), compound()]) -> Swing
    {
        Swing { id, data, excited, added_masses, amplitude_deg, suspension }
    }
}

prop_compose! {
    fn incline()(end in select(vec![End::Bow, End::Stern]), mass in quantity(positive()),
        arm in quantity(positive()), depth in quantity(-9.0..9.0),
        angle in prop_oneof![quantity(0.01..89.0).prop_map(InclineAngle::Stated), file().prop_map(InclineAngle::Recording)])
        -> Incline
    {
        Incline { end, mass_kg: mass, arm_m: arm, depth_m: depth, angle }
    }
}

fn finite() -> impl Strategy<Value = f64> {
    any::<f64>().prop_filter("finite", |value| value.is_finite())
}

prop_compose! {
    fn recorded()(file in file(), origin_ns in any::<i64>(), measured_on in text(), phone in text(), logger in text(), bias in of(file()),
        notes in btree_map(text(), text(), 0..3),
        sensors in vec((text(), text(), of(positive())), 0..3),
        events in vec((finite(), text()), 0..3),
        repairs in vec((of(finite()), of(finite()), text()), 0..3)) -> Recorded
    {
        let sensor = |(stream, name, full_scale)| RecordedSensor { stream, name, full_scale };
        let event = |(t_s, key)| RecordedEvent { t_s, key };
        let repair = |(from_s, to_s, text)| RecordedRepair {
            from_s, to_s, text, kind: Some(RepairKind::Saturation), sensor: Some(Sensor::Gyroscope), count: Some(7),
        };
        Recorded {
            file, origin_ns, measured_on, phone, logger, bias, notes,
            sensors: sensors.into_iter().map(sensor).collect(),
            events: events.into_iter().map(event).collect(),
            repairs: repairs.into_iter().map(repair).collect(),
        }
    }
}

prop_compose! {
    fn session()(title in text(), measured_on in text(), phone in text(), logger in text(), body in body(), site in site(), attachments in vec(attachment(), 0..3),
        mut swings in vec(swing(), 1..4), inclines in vec(incline(), 0..3), recorded in vec(recorded(), 0..2)) -> Session
    {
        for (index, swing) in swings.iter_mut().enumerate() {
            swing.id.push_str(&index.to_string());
        }
        let instruments = instruments(&swings);
        let read_with = instruments.1;
        let instruments = instruments.0;
        Session { title, measured_on, phone, logger, body, site, attachments, swings, inclines, recorded, instruments, read_with, hung_as: BTreeMap::new() }
    }
}

/// A tape that every spacing was read with, where there is one.
fn instruments(swings: &[Swing]) -> (Vec<Instrument>, BTreeMap<String, String>) {
    let read = |(i, swing): (usize, &Swing)| {
        swing.suspension.spacing_m?;
        let key = format!("swing[{}].suspension.spacing", i + 1);
        Some((key, "a \"tape\"".to_owned()))
    };
    let read_with: BTreeMap<_, _> = swings.iter().enumerate().filter_map(read).collect();
    let tape = Instrument {
        id: "a \"tape\"".into(),
        kind: InstrumentKind::Tape,
        scale_u: 5e-4,
        zero_u: 0.0,
    };
    let instruments = if read_with.is_empty() {
        vec![]
    } else {
        vec![tape]
    };
    (instruments, read_with)
}

fn files_named(session: &Session) -> Vec<String> {
    let swings = session.swings.iter().filter_map(|swing| match &swing.data {
        SwingData::Recording(file)
        | SwingData::Periods(file)
        | SwingData::Displacement { file, .. } => Some(file),
        SwingData::PeriodsS(_) => None,
    });
    let inclines = session
        .inclines
        .iter()
        .filter_map(|incline| match &incline.angle {
            InclineAngle::Recording(file) => Some(file),
            InclineAngle::Stated(_) => None,
        });
    let recorded = session
        .recorded
        .iter()
        .flat_map(|one| std::iter::once(&one.file).chain(&one.bias));
    let mut files: Vec<String> = swings.chain(inclines).chain(recorded).cloned().collect();
    files.sort();
    files.dedup();
    files
}

proptest! {
    #![proptest_config(cases(256))]

    #[test]
    fn a_written_session_reads_back_equal(session in session()) {
        let text = write_session(&session);
        prop_assert_eq!(read_session(&text, "session.toml").map_err(|e| format!("{e}\n{text}")), Ok(session));
    }

    #[test]
    fn lines_to_fill_in_change_nothing(session in session()) {
        let text = write_session_to_fill_in(&session);
        prop_assert_eq!(read_session(&text, "session.toml").map_err(|e| format!("{e}\n{text}")), Ok(session));
    }

    #[test]
    fn a_zipped_session_keeps_text_and_recordings(session in session(), bytes in vec(any::<u8>(), 0..100)) {
        let files: Vec<_> = files_named(&session).into_iter().map(|name| (name, bytes.clone())).collect();
        let store = Store::from_zip_bytes("a.zip", &session_zip_bytes(&session, &files).unwrap()).unwrap();
        prop_assert_eq!(store.read("session.toml").unwrap(), write_session(&session).into_bytes());
        for (name, bytes) in files {
            prop_assert_eq!(store.read(&name).unwrap(), bytes);
        }
    }

    #[test]
    fn no_text_makes_the_reader_panic(text in any::<String>()) {
        let _ = read_session(&text, "session.toml");
        let _ = read_session(&format!("format = \"gyradius-session/1\"\n{text}"), "session.toml");
    }

    #[test]
    fn no_change_of_a_valid_text_makes_the_reader_panic(
        changes in vec((any::<Index>(), 0usize..12, "[-\\[\\]{}=\"'.,#a-z0-9\n]{0,6}"), 1..5)
    ) {
        let mut text: Vec<char> = EXAMPLE.chars().collect();
        for (at, cut, insert) in changes {
            let start = at.index(text.len());
            let end = (start + cut).min(text.len());
            text.splice(start..end, insert.chars());
        }
        let text: String = text.into_iter().collect();
        if let Err(error) = read_session(&text, "session.toml") {
            prop_assert!(error.to_string().starts_with("session.toml"), "{}", error);
        }
    }

    #[test]
    fn no_bytes_make_the_archive_reader_panic(bytes in vec(any::<u8>(), 0..400)) {
        let _ = Store::from_zip_bytes("a.zip", &bytes);
    }

    #[test]
    fn no_change_of_a_valid_archive_makes_its_reader_panic(changes in vec((any::<Index>(), any::<u8>()), 1..6)) {
        let session = read_session(EXAMPLE, "session.toml").unwrap();
        let rows = b"t,gx,gy,gz,ax,ay,az\n0,1,2,3,0,0,9.8\n0.01,1,2,3,0,0,9.8\n".repeat(3);
        let mut bytes = session_zip_bytes(&session, &[("yaw-1.csv".into(), rows)]).unwrap();
        for (at, value) in changes {
            let place = at.index(bytes.len());
            bytes[place] = value;
        }
        if let Ok(store) = Store::from_zip_bytes("a.zip", &bytes) {
            let _ = load_store(&store);
        }
    }
}
