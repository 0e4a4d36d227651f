//! The recorder's file: what goes in comes out to the bit, and whatever happens to the file is
//! told.
//!
//! Expected values are what was pushed; the file itself is only cut, flipped and joined, never read
//! by the tests.
#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use gyradius_base::Error;
use gyradius_recording::recorder::{
    Damage, DamageKind, Event, Header, Piece, Reader, SensorInfo, Stream, Writer, convert,
};
use gyradius_recording::{
    LoadedData, Orientation, Overwrite, Quantity, RepairKind, Session, Suspension, SuspensionKind,
    Swing, SwingData, Triad, load_session, save_session,
};
use gyradius_test_support::cases;
use gyradius_test_support::fresh;
use proptest::prelude::*;
use rand::{Rng, RngExt};

const SECOND_NS: i64 = 1_000_000_000;
/// Samples of one block wait half a second; a cut inside a block loses no more of a stream.
const MOST_LOST_NS: i64 = SECOND_NS;

fn header() -> Header {
    Header {
        phone: "Pixel 7".into(),
        sensors: vec![
            SensorInfo {
                stream: Stream::Gyroscope,
                name: "LSM6DSO".into(),
                full_scale: Some(17.453_293),
            },
            SensorInfo {
                stream: Stream::Accelerometer,
                name: "".into(),
                full_scale: None,
            },
        ],
        notes: BTreeMap::from([("operator".to_owned(), "\"Ä\"\n=".to_owned())]),
    }
}

/// Stamps and the bits of the values.
type Bits = Vec<(i64, [u64; 3])>;

/// Everything that a reader finds.
#[derive(Default)]
struct Found {
    header: Option<Header>,
    samples: BTreeMap<Stream, Bits>,
    events: Vec<Event>,
    damage: Vec<Damage>,
}

fn read(bytes: &[u8]) -> Result<Found, Error> {
    let mut reader = Reader::new(bytes, "swing.gyr");
    let mut found = Found::default();
    while let Some(piece) = reader.next_piece()? {
        match piece {
            Piece::Header(header) => found.header = Some(header),
            Piece::Event(event) => found.events.push(event),
            Piece::Samples(samples) => {
                let all = samples.stamps_ns.iter().zip(&samples.values);
                let bits = all.map(|(stamp, value)| (*stamp, value.map(f64::to_bits)));
                found
                    .samples
                    .entry(samples.stream)
                    .or_default()
                    .extend(bits);
            }
            Piece::Resumed { .. } => {}
        }
    }
    found.damage = reader.damage().to_vec();
    Ok(found)
}

/// What was pushed, and how much of it the file held at each length that it had.
#[derive(Default, Clone)]
struct Told {
    samples: BTreeMap<Stream, Bits>,
    /// Length of the file and, by stream, samples in it.
    lengths: Vec<(u64, BTreeMap<Stream, usize>)>,
}

impl Told {
    /// Pushes one batch and notes what is in the file after it.
    fn push(&mut self, writer: &mut Writer, stream: Stream, stamps: &[i64], values: &[[f64; 3]]) {
        let written = writer.push(stream, stamps, values).unwrap();
        let bits = stamps
            .iter()
            .zip(values)
            .map(|(stamp, value)| (*stamp, value.map(f64::to_bits)));
        self.samples.entry(stream).or_default().extend(bits);
        assert!(written.waiting <= 300, "{} samples wait", written.waiting);
    }

    fn note(&mut self, length: u64) {
        let counts = self
            .samples
            .iter()
            .map(|(stream, all)| (*stream, all.len()))
            .collect();
        self.lengths.push((length, counts));
    }
}

/// Some seconds of a gyroscope at 200 Hz and an accelerometer at 100 Hz, in batches as a phone
/// gives them.
fn record(rng: &mut impl Rng, writer: &mut Writer, told: &mut Told, from_ns: i64, seconds: i64) {
    let mut now = from_ns;
    while now < from_ns + seconds * SECOND_NS {
        let span = rng.random_range(1..80_i64) * 5_000_000;
        for (stream, step) in [
            (Stream::Gyroscope, 5_000_000),
            (Stream::Accelerometer, 10_000_000),
        ] {
            let stamps: Vec<i64> = (now / step + 1..=(now + span) / step)
                .map(|i| i * step)
                .collect();
            let values: Vec<[f64; 3]> = stamps.iter().map(|_| rng.random()).collect();
            told.push(writer, stream, &stamps, &values);
        }
        now += span;
        if rng.random_range(0..4) == 0 {
            let length = writer.flush().unwrap().length;
            told.note(length);
        }
    }
}

fn recorded(rng: &mut impl Rng, path: &Path, seconds: i64) -> Told {
    let mut told = Told::default();
    let mut writer = Writer::create(path, &header()).unwrap();
    record(rng, &mut writer, &mut told, 86_400 * SECOND_NS, seconds);
    let length = writer.flush().unwrap().length;
    told.note(length);
    writer.end(86_500 * SECOND_NS).unwrap();
    told
}

/// Starts of the blocks after the first: every sync word of a file whose values are below 1 begins
/// one.
fn block_starts(bytes: &[u8]) -> Vec<usize> {
    (0..bytes.len() - 3)
        .filter(|&at| bytes[at..at + 4] == [0x89, b'G', b'R', b'1'])
        .collect()
}

#[test]
fn a_whole_file_reads_back_to_the_bit_and_has_no_damage() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("swing.gyr");
    let told = recorded(&mut fresh("whole file"), &path, 20);
    let found = read(&fs::read(&path).unwrap()).unwrap();
    assert_eq!(found.header.unwrap(), header());
    assert_eq!(found.samples, told.samples);
    assert_eq!(
        found.events,
        [Event {
            stamp_ns: 86_500 * SECOND_NS,
            key: "end".into()
        }]
    );
    assert_eq!(found.damage, []);
}

#[test]
fn a_thousand_cuts_lose_at_most_the_last_second_and_say_so() {
    let mut rng = fresh("cuts");
    let dir = tempfile::tempdir().unwrap();
    for file in 0..5 {
        let path = dir.path().join(format!("{file}.gyr"));
        let told = recorded(&mut rng, &path, 12);
        let bytes = fs::read(&path).unwrap();
        for _ in 0..200 {
            let cut = rng.random_range(0..bytes.len());
            let found = read(&bytes[..cut]).unwrap();
            let flushed = told
                .lengths
                .iter()
                .rfind(|(length, _)| *length <= cut as u64);
            let next = told.lengths.iter().find(|(length, _)| *length > cut as u64);
            for (stream, all) in &told.samples {
                let kept = found.samples.get(stream).cloned().unwrap_or_default();
                assert_eq!(kept[..], all[..kept.len()], "cut at {cut}");
                let sure = flushed.map_or(0, |(_, counts)| counts[stream]);
                assert!(kept.len() >= sure, "cut at {cut}: {} of {sure}", kept.len());
                // What the file could hold at the cut ends within a second of what is read.
                let most = next.map_or(all.len(), |(_, counts)| counts[stream]);
                assert!(kept.len() <= most);
            }
            let last = found.damage.last().unwrap();
            assert!(
                matches!(last.kind, DamageKind::CutTail | DamageKind::NoEnd),
                "cut at {cut}: {last:?}"
            );
            assert!(
                last.text().contains("cut off") && found.damage.len() == 1,
                "{:?}",
                found.damage
            );
            assert_eq!(last.at_byte + last.bytes, cut as u64);
        }
    }
}

/// Cut where a block is just not whole: the stamps read end less than a second before those of the
/// block.
#[test]
fn the_block_that_a_cut_loses_is_shorter_than_a_second() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("swing.gyr");
    let told = recorded(&mut fresh("shortest loss"), &path, 10);
    let bytes = fs::read(&path).unwrap();
    let whole = |end: usize, stream| {
        read(&bytes[..end])
            .unwrap()
            .samples
            .get(&stream)
            .map_or(0, Vec::len)
    };
    for start in block_starts(&bytes).into_iter().skip(1) {
        for (stream, all) in &told.samples {
            let (before, after) = (whole(start - 1, *stream), whole(start, *stream));
            if after > before {
                assert!(all[after - 1].0 - all[before].0 < MOST_LOST_NS);
            }
        }
    }
}

#[test]
fn a_flipped_bit_loses_one_block_at_most_and_is_always_told() {
    let mut rng = fresh("flips");
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("swing.gyr");
    let told = recorded(&mut rng, &path, 12);
    let bytes = fs::read(&path).unwrap();
    let starts = block_starts(&bytes);
    for _ in 0..1000 {
        let bit = rng.random_range(0..8 * bytes.len());
        let mut flipped = bytes.clone();
        flipped[bit / 8] ^= 1 << (bit % 8);
        let found = read(&flipped).unwrap();
        let block = starts.iter().rposition(|&start| start <= bit / 8).unwrap();
        let end = starts.get(block + 1).copied().unwrap_or(bytes.len());
        let is_last = end == bytes.len();
        let [damage] = &found.damage[..] else {
            panic!("bit {bit}: {:?}", found.damage)
        };
        assert_eq!(
            damage.kind,
            if is_last {
                DamageKind::CutTail
            } else {
                DamageKind::LostBlock
            }
        );
        assert_eq!(
            (damage.at_byte, damage.bytes),
            (starts[block] as u64, (end - starts[block]) as u64)
        );
        assert_eq!(damage.blocks, u32::from(!is_last));
        // All samples but those of the one block, which stand together in one stream.
        let lost: Vec<usize> = told
            .samples
            .iter()
            .map(|(stream, all)| {
                let kept = &found.samples[stream];
                let lost = all.len() - kept.len();
                let same = kept.iter().zip(all).take_while(|(a, b)| a == b).count();
                assert_eq!(kept[same..], all[same + lost..], "bit {bit}");
                lost
            })
            .collect();
        assert!(
            lost.iter().filter(|&&lost| lost > 0).count() <= 1,
            "bit {bit}: {lost:?}"
        );
    }
}

#[test]
fn a_recorder_that_was_killed_goes_on_and_says_so() {
    let mut rng = fresh("resume");
    let dir = tempfile::tempdir().unwrap();
    for i in 0..30 {
        let path = dir.path().join(format!("{i}.gyr"));
        let mut told = recorded(&mut rng, &path, 3);
        let mut bytes = fs::read(&path).unwrap();
        // Where each block *resumed* begins, and what it must say.
        let mut resumed: Vec<(usize, u64)> = Vec::new();
        for segment in 1..4 {
            let cut = rng.random_range(0..=bytes.len());
            told.samples = read(&bytes[..cut]).unwrap().samples;
            let ends = block_starts(&bytes)
                .into_iter()
                .skip(1)
                .chain([bytes.len()]);
            let whole = ends.filter(|&end| end <= cut).max().unwrap_or(0);
            resumed.retain(|(start, _)| *start < whole);
            resumed.push((whole, (cut - whole) as u64));
            fs::write(&path, &bytes[..cut]).unwrap();
            let mut writer = Writer::resume(&path).unwrap();
            record(
                &mut rng,
                &mut writer,
                &mut told,
                (86_400 + 10 * segment) * SECOND_NS,
                2,
            );
            writer.end(86_500 * SECOND_NS).unwrap();
            bytes = fs::read(&path).unwrap();
            let found = read(&bytes).unwrap();
            assert_eq!(found.samples, told.samples);
            assert!(
                found
                    .damage
                    .iter()
                    .all(|damage| damage.kind == DamageKind::Resumed)
            );
            let said: Vec<(usize, u64)> = found
                .damage
                .iter()
                .map(|d| (d.at_byte as usize, d.bytes))
                .collect();
            assert_eq!(said, resumed);
        }
    }
}

#[test]
fn blocks_that_are_absent_or_doubled_are_told_by_their_numbers() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("swing.gyr");
    recorded(&mut fresh("absent"), &path, 5);
    let bytes = fs::read(&path).unwrap();
    let starts = block_starts(&bytes);
    let without = [&bytes[..starts[2]], &bytes[starts[4]..]].concat();
    let found = read(&without).unwrap();
    let [damage] = &found.damage[..] else {
        panic!("{:?}", found.damage)
    };
    assert_eq!((damage.kind, damage.blocks), (DamageKind::OutOfSequence, 2));
    let doubled = [&bytes[..starts[4]], &bytes[starts[3]..]].concat();
    assert_eq!(
        read(&doubled).unwrap().damage[0].kind,
        DamageKind::OutOfSequence
    );
    let foreign = [&bytes[..starts[4]], b"something else", &bytes[starts[4]..]].concat();
    let found = read(&foreign).unwrap();
    let [damage] = &found.damage[..] else {
        panic!("{:?}", found.damage)
    };
    assert_eq!(
        (damage.kind, damage.blocks, damage.bytes),
        (DamageKind::LostBlock, 0, 14)
    );
}

#[test]
fn what_is_no_recorder_file_is_refused_and_not_touched() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("letter.txt");
    fs::write(&path, "Dear phone, ").unwrap();
    let error = Writer::resume(&path).err().unwrap();
    let expected = "expected a recorder's file (gyradius-recorder/1), found no block of one";
    assert!(
        matches!(error, Error::Malformed { .. }) && error.to_string().ends_with(expected),
        "{error}"
    );
    assert_eq!(fs::read_to_string(&path).unwrap(), "Dear phone, ");
    let error = Writer::create(&path, &header()).err().unwrap().to_string();
    assert!(
        error.contains("letter.txt: cannot be written: making the file: "),
        "{error}"
    );
    let error = Writer::resume(dir.path().join("gone.gyr"))
        .err()
        .unwrap()
        .to_string();
    assert!(
        error.contains("gone.gyr: cannot be read: opening: "),
        "{error}"
    );
}

#[test]
fn arguments_that_do_not_fit_are_refused() {
    let dir = tempfile::tempdir().unwrap();
    let mut writer = Writer::create(dir.path().join("a.gyr"), &header()).unwrap();
    let error = writer
        .push(Stream::Gyroscope, &[1, 2], &[[0.0; 3]])
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "argument `values`: expected as many values as stamps, found 2 stamps and 1 values"
    );
    let long = Event {
        stamp_ns: 0,
        key: "x".repeat(1 << 19),
    };
    assert!(matches!(writer.mark(&long), Err(Error::Argument { .. })));
    let header = Header {
        phone: "x".repeat(1 << 19),
        ..Header::default()
    };
    assert!(matches!(
        Writer::create(dir.path().join("b.gyr"), &header),
        Err(Error::Argument { .. })
    ));
}

fn triad_bits(triad: &Triad, origin_ns: i64) -> Bits {
    let [x, y, z] = &triad.axes;
    let stamp = |t: &f64| origin_ns + (t * 1e9).round() as i64;
    let values = x
        .iter()
        .zip(y)
        .zip(z)
        .map(|((x, y), z)| [x, y, z].map(|value| value.to_bits()));
    triad.t_s.iter().map(stamp).zip(values).collect()
}

fn swing_session(file: &str) -> Session {
    let suspension = Suspension {
        line_length_m: Some(Quantity::exact(3.0)),
        spacing_m: Some(Quantity::exact(1.5)),
        ..Suspension::unmeasured(SuspensionKind::Bifilar, Orientation::Athwartships)
    };
    let swing = Swing {
        id: "yaw-1".into(),
        data: SwingData::Recording(file.into()),
        excited: vec![],
        added_masses: vec![],
        amplitude_deg: BTreeMap::new(),
        suspension,
    };
    Session {
        swings: vec![swing],
        ..Session::default()
    }
}

/// Bits, marks and repairs through the session's own folder.
#[test]
fn a_session_holds_every_bit_of_a_file_and_tells_its_repairs() {
    let mut rng = fresh("conversion");
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("yaw-1.gyr");
    let mut told = Told::default();
    let mut writer = Writer::create(&path, &header()).unwrap();
    let start = 5 * 86_400 * SECOND_NS + 123_456_789;
    record(&mut rng, &mut writer, &mut told, start, 4);
    let bias = [[1e-3, -2e-3, 0.1 + 0.2]; 2];
    writer
        .push(Stream::GyroscopeBias, &[start, start + 1], &bias)
        .unwrap();
    writer
        .mark(&Event {
            stamp_ns: start + SECOND_NS + 1,
            key: "release".into(),
        })
        .unwrap();
    drop(writer);

    let folder = dir.path().join("session");
    let recorded = convert(&path, &folder, "yaw-1").unwrap();
    let mut session = swing_session(&recorded.file);
    session.recorded.push(recorded.clone());
    save_session(&folder, &session, &[], Overwrite::Refuse).unwrap();
    let loaded = load_session(&folder).unwrap();
    assert_eq!(loaded.session, session);
    let LoadedData::Recording(recording) = &loaded.data[0].data else {
        panic!("no recording")
    };
    for (stream, triad) in [
        (Stream::Gyroscope, &recording.gyroscope),
        (Stream::Accelerometer, &recording.accelerometer),
    ] {
        assert_eq!(
            triad_bits(triad.as_ref().unwrap(), recorded.origin_ns),
            told.samples[&stream]
        );
    }
    assert_eq!(recording.repairs.len(), 1, "{:?}", recording.repairs);
    assert_eq!(recording.repairs[0].kind, RepairKind::LostByRecorder);
    assert!(recording.repairs[0].text.contains("without an end mark"));
    assert_eq!(
        (recorded.phone.as_str(), recorded.events[0].key.as_str()),
        ("Pixel 7", "release")
    );
    let event_ns = recorded.origin_ns + (recorded.events[0].t_s * 1e9).round() as i64;
    assert_eq!(event_ns, start + SECOND_NS + 1);
    let text = fs::read_to_string(folder.join(recorded.bias.unwrap())).unwrap();
    let since = |stamp: i64| (stamp - recorded.origin_ns) as f64 / 1e9;
    let row = |stamp| format!("{},0.001,-0.002,0.30000000000000004\n", since(stamp));
    assert_eq!(
        text,
        format!("t,gx,gy,gz\n{}{}", row(start), row(start + 1))
    );
}

#[test]
fn a_file_without_samples_has_no_recording() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("empty.gyr");
    Writer::create(&path, &header()).unwrap().end(0).unwrap();
    let error = convert(&path, dir.path(), "empty").unwrap_err();
    assert!(matches!(error, Error::NoResult { .. }), "{error}");
}

/// One sensor that stops must not hold back the rows of the other.
#[test]
fn rows_are_in_time_order_and_a_silent_sensor_holds_nothing_back() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("a.gyr");
    let mut writer = Writer::create(&path, &header()).unwrap();
    writer
        .push(
            Stream::Accelerometer,
            &[0, 15_000_000],
            &[[1.0; 3], [2.0; 3]],
        )
        .unwrap();
    for i in 0..20_000 {
        writer
            .push(Stream::Gyroscope, &[5_000_000 * i], &[[i as f64; 3]])
            .unwrap();
    }
    writer.end(0).unwrap();
    let recorded = convert(&path, dir.path(), "a").unwrap();
    assert_eq!(recorded.repairs, []);
    let text = fs::read_to_string(dir.path().join("a.csv")).unwrap();
    let first: Vec<&str> = text.lines().take(5).collect();
    let expected = [
        "t,gx,gy,gz,ax,ay,az",
        "0,0,0,0,1,1,1",
        "0.005,1,1,1,,,",
        "0.01,2,2,2,,,",
        "0.015,3,3,3,2,2,2",
    ];
    assert_eq!(first, expected);
    assert_eq!(text.lines().count(), 20_001);
}

fn batches() -> impl Strategy<Value = Vec<(usize, Bits)>> {
    let sample = (any::<i64>(), any::<[u64; 3]>());
    proptest::collection::vec((0..3_usize, proptest::collection::vec(sample, 0..20)), 0..6)
}

proptest! {
    #![proptest_config(cases(64))]

    /// Any stamps and any bits, NaNs with their payloads among them.
    #[test]
    fn any_samples_round_trip(batches in batches()) {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("a.gyr");
        let mut writer = Writer::create(&path, &header()).unwrap();
        let mut pushed: BTreeMap<Stream, Bits> = BTreeMap::new();
        for (stream, samples) in batches {
            let stamps: Vec<i64> = samples.iter().map(|sample| sample.0).collect();
            let values: Vec<[f64; 3]> = samples.iter().map(|sample| sample.1.map(f64::from_bits)).collect();
            writer.push(Stream::ALL[stream], &stamps, &values).unwrap();
            if !samples.is_empty() {
                pushed.entry(Stream::ALL[stream]).or_default().extend(samples);
            }
        }
        writer.end(0).unwrap();
        let found = read(&fs::read(&path).unwrap()).unwrap();
        prop_assert_eq!(found.samples, pushed);
        prop_assert_eq!(found.damage, vec![]);
    }

    #[test]
    fn no_bytes_make_the_reader_panic(bytes in proptest::collection::vec(any::<u8>(), 0..200)) {
        let _ = read(&bytes);
        let _ = read(&[&[0x89, b'G', b'R', b'1'], &bytes[..]].concat());
    }
}
