//! Files that hold several tables: databases and workbooks. The fixtures hold the motion of
//! `import.rs`, written by Python's own SQLite and by the rules of ECMA-376.
#![allow(clippy::unwrap_used, clippy::panic)]

use gyradius_recording::Store;
use gyradius_recording::import::{Format, ImportOptions, ImportedData, import_files};

use crate::import::{ROWS, acc, assert_triad, bytes, gyro, import, one};
use crate::tables::zip;

fn refused(name: &str, bytes: Vec<u8>) -> String {
    let error = import_files(&[(name.to_owned(), bytes)], &ImportOptions::default());
    error.unwrap_err().to_string()
}

#[test]
fn a_database_of_sensor_logger_is_its_archive() {
    for file in ["sensor-logger-utf8.sqlite", "sensor-logger-utf16.sqlite"] {
        let imported = import(&[file]);
        assert_eq!(imported.source, Format::SensorLogger);
        assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
        let every_other = (0..ROWS).step_by(2);
        assert_triad(one(&imported).accelerometer.as_ref(), every_other, acc);
        assert_eq!(imported.device["device name"], "Phone Ä");
        // 6000 characters, on pages of 512 bytes.
        assert_eq!(imported.device["notes"], "long, ".repeat(1000).trim());
        assert_eq!(imported.recordings[0].facts.phone, "Phone Ä");
        assert_eq!(imported.recordings[0].not_used, Vec::<String>::new());
    }
}

#[test]
fn the_database_of_the_shared_case_is_read() {
    let folder = concat!(
        env!("CARGO_MANIFEST_DIR"),
        "/../../../../shared/cases/sensor-logger-json-sqlite"
    );
    let Ok(bytes) = std::fs::read(format!("{folder}/rec.sqlite")) else {
        println!("skipped: no ../shared/cases beside this clone");
        return;
    };
    let imported = import_files(
        &[("rec.sqlite".to_owned(), bytes)],
        &ImportOptions::default(),
    );
    let imported = imported.unwrap();
    let gyroscope = one(&imported).gyroscope.as_ref().unwrap();
    // Counted and summed by the `sqlite3` module of Python.
    assert_eq!(gyroscope.t_s.len(), 6000);
    let sum: f64 = gyroscope.axes[2].iter().sum();
    assert!((sum - 17.97319382038063).abs() < 1e-9, "{sum}");
    assert_eq!(gyroscope.axes[0][0], 0.01144944560869977);
}

#[test]
fn a_database_that_is_cut_or_goes_round_in_circles_is_an_error() {
    let whole = bytes("sensor-logger-utf8.sqlite");
    for length in [16, 99, 100, 511, 512, 2000, whole.len() - 512] {
        let text = refused("a.sqlite", whole[..length].to_vec());
        assert!(
            text.contains("a.sqlite") && text.contains("SQLite"),
            "{text}"
        );
    }
    // Page 1 without a cell: no table.
    let mut empty = whole[..512].to_vec();
    empty[103..105].copy_from_slice(&[0, 0]);
    empty[100] = 13;
    let text = refused("a.sqlite", empty);
    assert!(text.contains("no table") && text.contains("-wal"), "{text}");
    // The table on page 2 spans several pages: its root has its children's numbers from byte 12 on,
    // and that of the last at byte 8. It becomes its own last child.
    let mut circle = whole.clone();
    assert_eq!(circle[512], 5);
    circle[512 + 8..512 + 12].copy_from_slice(&2_u32.to_be_bytes());
    let text = refused("a.sqlite", circle);
    assert!(text.contains("page 2 twice"), "{text}");
}

#[test]
fn workbooks_of_phyphox_are_their_archives() {
    let imported = import(&["phyphox.xlsx"]);
    assert_eq!(imported.source, Format::Phyphox);
    assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
    let facts = &imported.recordings[0].facts;
    let told = (&*facts.measured_on, &*facts.phone, &*facts.logger);
    assert_eq!(told, ("2023-11-14", "Pixel 0", "phyphox 1.1.16"));

    let imported = import(&["phyphox-padded.xlsx"]);
    assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
    let every_other = (0..ROWS).step_by(2);
    assert_triad(one(&imported).accelerometer.as_ref(), every_other, acc);
}

#[test]
fn databases_and_workbooks_are_found_inside_an_archive() {
    for (member, file) in [
        ("a/rec.sqlite", "sensor-logger-utf8.sqlite"),
        ("a/b.xlsx", "phyphox.xlsx"),
    ] {
        let inner = bytes(file);
        let archive = zip(&[(member, &inner[..]), ("readme.pdf", &b"x"[..])]);
        let inputs = [("all.zip".to_owned(), archive)];
        let imported = import_files(&inputs, &ImportOptions::default()).unwrap();
        assert_triad(one(&imported).gyroscope.as_ref(), 0..ROWS, gyro);
        let left = &imported.recordings[0].not_used;
        assert!(
            left.iter().any(|text| text.contains("readme.pdf")),
            "{left:?}"
        );
    }
}

/// phyphox's workbook with a text of its parts replaced.
fn changed(old: &str, new: &str) -> Vec<u8> {
    let store = Store::from_zip_bytes("a.xlsx", &bytes("phyphox.xlsx")).unwrap();
    let names = store.names().unwrap();
    let members: Vec<(&str, String)> = names
        .iter()
        .map(|name| {
            let text = String::from_utf8(store.read(name).unwrap()).unwrap();
            (name.as_str(), text.replace(old, new))
        })
        .collect();
    zip(&members)
}

#[test]
fn cells_far_out_or_twice_are_refused_by_their_sheet() {
    // A dense table up to such a cell would not fit into any memory.
    let text = refused("a.xlsx", changed("r=\"E41\"", "r=\"XFD1048576\""));
    assert!(
        text.contains("a.xlsx") && text.contains("1000 columns"),
        "{text}"
    );
    let text = refused("a.xlsx", changed("r=\"D41\"", "r=\"C41\""));
    assert!(text.contains("out of order"), "{text}");
}

#[test]
fn frames_are_counted_where_no_column_numbers_them() {
    // 50 frames a second; the numbers of the frames start at 100 where a column has them.
    for (header, first_s) in [("frame,angle", 2.0), ("picture,angle", 0.0)] {
        let rows: String = (0..30)
            .map(|i| format!("{},{}\n", 100 + i, i % 3))
            .collect();
        let text = format!("{header}\n{rows}");
        let options = ImportOptions {
            mapping: Some(
                gyradius_recording::import::ColumnMapping::from_entries([
                    "t=frame:50/s",
                    "angle=angle:deg",
                ])
                .unwrap(),
            ),
            ..ImportOptions::default()
        };
        let imported =
            import_files(&[("video.csv".to_owned(), text.into_bytes())], &options).unwrap();
        let ImportedData::Channel(channel) = &imported.recordings[0].data else {
            panic!("{imported:?}")
        };
        assert!((channel.t_s[0] - first_s).abs() < 1e-12);
        assert!((channel.t_s[29] - first_s - 0.58).abs() < 1e-12);
    }
}
