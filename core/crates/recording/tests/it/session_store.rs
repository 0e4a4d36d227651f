//! Sessions on disk: folders and archives, loaded whole, refused where they are unsafe, saved
//! without loss.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use std::fs;
use std::io::{Cursor, Write};

use gyradius_base::Error;
use gyradius_recording::{
    LoadedData, Overwrite, Store, load_session, load_store, read_session, save_session,
    save_session_zip, session_zip_bytes,
};
use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, ZipWriter};

const SESSION: &str = r#"format = "gyradius-session/1"
[body]
mass = 10.0

[[swing]]
id = "a"
recording = "sub/a.csv"
[swing.suspension]
kind = "compound"
orientation = "athwartships"
axis_height = 2.0

[[swing]]
id = "b"
periods_s = { compound = 3.0 }
[swing.suspension]
kind = "compound"
orientation = "athwartships"
axis_height = 2.0

[[incline]]
end = "bow"
mass = 1.0
arm = 0.8
depth = 0.1
recording = "i.csv"
"#;

fn recording() -> Vec<u8> {
    let mut text = String::from("t,gx,gy,gz,ax,ay,az\n");
    for row in 0..200 {
        let t = f64::from(row) / 100.0;
        text.push_str(&format!(
            "{t},{},0.02,0.001,0.1,0.2,9.8\n",
            0.1 * (3.0 * t).sin()
        ));
    }
    text.into_bytes()
}

fn recordings() -> Vec<(String, Vec<u8>)> {
    vec![
        ("sub/a.csv".into(), recording()),
        ("i.csv".into(), recording()),
    ]
}

fn zipped(members: &[(&str, &[u8])]) -> Vec<u8> {
    zipped_with(members, SimpleFileOptions::default())
}

fn zipped_with(members: &[(&str, &[u8])], options: SimpleFileOptions) -> Vec<u8> {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    for (name, bytes) in members {
        zip.start_file(*name, options).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap().into_inner()
}

/// Puts another text of the same length in the place of every occurrence.
fn patched(mut bytes: Vec<u8>, old: &[u8], new: &[u8]) -> Vec<u8> {
    assert_eq!(old.len(), new.len());
    let places: Vec<usize> = (0..=bytes.len() - old.len())
        .filter(|&at| bytes[at..].starts_with(old))
        .collect();
    assert!(!places.is_empty());
    for at in places {
        bytes[at..at + new.len()].copy_from_slice(new);
    }
    bytes
}

fn assert_unsafe(bytes: &[u8], reason: &str) {
    let error = Store::from_zip_bytes("boat.zip", bytes).expect_err(reason);
    assert!(matches!(error, Error::UnsafeArchive { .. }), "{error}");
    let message = error.to_string();
    assert!(
        message.starts_with("boat.zip: unsafe archive: ") && message.contains(reason),
        "{message}"
    );
}

#[test]
fn a_folder_a_zip_and_a_zipped_folder_load_the_same() {
    let dir = tempfile::tempdir().unwrap();
    let session = read_session(SESSION, "session.toml").unwrap();
    save_session(dir.path(), &session, &recordings(), Overwrite::Refuse).unwrap();
    let from_folder = load_session(dir.path()).unwrap();
    assert_eq!(from_folder.session, session);
    let bytes = recording();
    let members: [(&str, &[u8]); 3] = [
        ("boat/session.toml", SESSION.as_bytes()),
        ("boat/sub/a.csv", &bytes),
        ("boat/i.csv", &bytes),
    ];
    let nested = load_store(&Store::from_zip_bytes("n.zip", &zipped(&members)).unwrap()).unwrap();
    let flat_bytes = session_zip_bytes(&session, &recordings()).unwrap();
    let flat = load_store(&Store::from_zip_bytes("f.zip", &flat_bytes).unwrap()).unwrap();
    for loaded in [&from_folder, &nested, &flat] {
        assert_eq!(loaded.session, session);
        let [a, b] = &loaded.data[..] else {
            panic!("two swings")
        };
        let LoadedData::Recording(recording) = &a.data else {
            panic!("a recording")
        };
        assert_eq!(
            (
                a.id.as_str(),
                recording.gyroscope.as_ref().unwrap().t_s.len()
            ),
            ("a", 200)
        );
        assert_eq!((b.id.as_str(), &b.data), ("b", &LoadedData::Typed));
        assert!(loaded.inclines[0].as_ref().unwrap().accelerometer.is_some());
    }
}

#[test]
fn shadow_files_of_macos_do_not_hide_the_top_folder() {
    let members: [(&str, &[u8]); 2] = [
        ("boat/session.toml", b"x"),
        ("__MACOSX/boat/._session.toml", b"y"),
    ];
    let store = Store::from_zip_bytes("boat.zip", &zipped(&members)).unwrap();
    assert_eq!(store.names().unwrap(), ["session.toml"]);
}

#[test]
fn a_missing_recording_names_session_line_and_file() {
    let store = Store::from_files(
        "boat",
        [("session.toml".to_string(), SESSION.as_bytes().to_vec())],
    )
    .unwrap();
    assert_eq!(
        load_store(&store).unwrap_err().to_string(),
        "boat/session.toml, line 7: expected `swing[1].recording` to name a file of the session, \
         found `sub/a.csv`, which is not there"
    );
}

#[test]
fn a_source_without_a_session_and_one_in_other_bytes_are_clear() {
    let empty = Store::from_files("boat", []).unwrap();
    let message = load_store(&empty).unwrap_err().to_string();
    assert!(
        message.contains("boat/session.toml") && message.contains("no such file"),
        "{message}"
    );
    let latin = Store::from_files(
        "boat",
        [("session.toml".into(), b"format = 1\n# \xe9\n".to_vec())],
    )
    .unwrap();
    let message = load_store(&latin).unwrap_err().to_string();
    assert!(
        message.contains("session.toml, line 2: expected text in UTF-8"),
        "{message}"
    );
    for bytes in [&b""[..], b"PK", b"not a zip at all"] {
        let error = Store::from_zip_bytes("boat.zip", bytes).unwrap_err();
        assert!(matches!(error, Error::Unreadable { .. }), "{error}");
    }
}

#[test]
fn archives_whose_members_climb_out_are_refused() {
    for (name, reason) in [
        ("../a.csv", "climbs out"),
        ("a/../../b", "climbs out"),
        ("/etc/passwd", "absolute"),
        ("C:/a.csv", "absolute"),
        ("a//b.csv", "empty folder name"),
    ] {
        // The writer of the archive cleans some names itself, so the name is put in afterwards.
        let stand_in = "x".repeat(name.len());
        let bytes = patched(
            zipped(&[(&stand_in, b"1")]),
            stand_in.as_bytes(),
            name.as_bytes(),
        );
        assert_unsafe(&bytes, reason);
    }
    assert_unsafe(
        &patched(zipped(&[("..xa.csv", b"1")]), b"..xa.csv", b"..\\a.csv"),
        "backslash",
    );
    assert_unsafe(
        &patched(zipped(&[("a.csv", b"1")]), b"a.csv", b"a\0csv"),
        "control character",
    );
}

#[test]
fn symbolic_links_and_doubled_names_are_refused() {
    let mut zip = ZipWriter::new(Cursor::new(Vec::new()));
    zip.add_symlink("link.csv", "/etc/passwd", SimpleFileOptions::default())
        .unwrap();
    assert_unsafe(&zip.finish().unwrap().into_inner(), "symbolic link");
    let doubled = patched(
        zipped(&[("a.csv", b"1"), ("b.csv", b"2")]),
        b"b.csv",
        b"a.csv",
    );
    assert_unsafe(&doubled, "two files of one name");
    let disguised = patched(
        zipped(&[("xxa.csv", b"1"), ("a.csv", b"2")]),
        b"xxa.csv",
        b"./a.csv",
    );
    assert_unsafe(&disguised, "twice");
}

#[test]
fn bombs_are_refused_whatever_their_headers_say() {
    let zeros = vec![0u8; 64 << 20];
    let bomb = zipped(&[("a.csv", &zeros)]);
    assert!(bomb.len() < 100_000);
    assert_unsafe(&bomb, "times");
    let size = (zeros.len() as u32).to_le_bytes();
    assert_unsafe(
        &patched(bomb.clone(), &size, &(1u32 << 31).to_le_bytes()),
        "times",
    );
    let understated = patched(bomb, &size, &10u32.to_le_bytes());
    let message = Store::from_zip_bytes("boat.zip", &understated)
        .unwrap_err()
        .to_string();
    assert!(
        message.contains("boat.zip/a.csv") && message.contains("larger than its declared"),
        "{message}"
    );
    let many: Vec<String> = (0..5000).map(|n| n.to_string()).collect();
    let many: Vec<(&str, &[u8])> = many.iter().map(|name| (name.as_str(), &b""[..])).collect();
    assert_unsafe(&zipped(&many), "5000 files");
}

#[test]
fn many_small_members_that_make_one_bomb_are_refused() {
    let zeros = vec![0u8; 1 << 20];
    let names: Vec<String> = (0..64).map(|n| format!("{n}.csv")).collect();
    let members: Vec<(&str, &[u8])> = names
        .iter()
        .map(|name| (name.as_str(), &zeros[..]))
        .collect();
    assert_unsafe(&zipped(&members), "in all");
}

#[test]
fn a_spoilt_member_and_an_unknown_packing_are_errors() {
    let stored = SimpleFileOptions::default().compression_method(CompressionMethod::Stored);
    let spoilt = patched(
        zipped_with(&[("a.csv", b"t,gx,gy,gz")], stored),
        b"t,gx",
        b"t,gy",
    );
    assert!(matches!(
        Store::from_zip_bytes("boat.zip", &spoilt),
        Err(Error::Unreadable { .. })
    ));
    let whole = zipped(&[("a.csv", &recording())]);
    for cut in [1, 10, whole.len() / 2] {
        assert!(Store::from_zip_bytes("boat.zip", &whole[..whole.len() - cut]).is_err());
    }
}

#[test]
fn saving_overwrites_only_when_told_to() {
    let dir = tempfile::tempdir().unwrap();
    let session = read_session(SESSION, "session.toml").unwrap();
    fs::write(dir.path().join("i.csv"), b"precious").unwrap();
    let refused = save_session(dir.path(), &session, &recordings(), Overwrite::Refuse).unwrap_err();
    assert!(
        matches!(&refused, Error::Unwritable { file, .. } if file.ends_with("i.csv")),
        "{refused}"
    );
    assert_eq!(fs::read(dir.path().join("i.csv")).unwrap(), b"precious");
    assert!(!dir.path().join("session.toml").exists() && !dir.path().join("sub").exists());
    save_session(dir.path(), &session, &recordings(), Overwrite::Replace).unwrap();
    assert_eq!(fs::read(dir.path().join("i.csv")).unwrap(), recording());
    assert_eq!(
        Store::open(dir.path()).unwrap().names().unwrap(),
        ["i.csv", "session.toml", "sub/a.csv"]
    );
}

#[test]
fn saving_a_zip_overwrites_only_when_told_to_and_gives_the_same_bytes() {
    let dir = tempfile::tempdir().unwrap();
    let path = dir.path().join("boat.zip");
    let session = read_session(SESSION, "session.toml").unwrap();
    save_session_zip(&path, &session, &recordings(), Overwrite::Refuse).unwrap();
    let first = fs::read(&path).unwrap();
    assert!(save_session_zip(&path, &session, &recordings(), Overwrite::Refuse).is_err());
    save_session_zip(&path, &session, &recordings(), Overwrite::Replace).unwrap();
    assert_eq!(fs::read(&path).unwrap(), first);
    assert_eq!(load_session(&path).unwrap().session, session);
}

#[test]
fn sessions_that_could_not_be_read_back_are_not_saved() {
    let dir = tempfile::tempdir().unwrap();
    let good = read_session(SESSION, "session.toml").unwrap();
    let mut negative = good.clone();
    negative.body.length_overall_m = Some(-1.0);
    assert!(save_session(dir.path(), &negative, &recordings(), Overwrite::Refuse).is_err());
    let missing =
        save_session(dir.path(), &good, &recordings()[..1], Overwrite::Refuse).unwrap_err();
    assert!(missing.to_string().contains("i.csv"), "{missing}");
    for name in ["../x.csv", "session.toml", "i.csv"] {
        let mut files = recordings();
        files.push((name.into(), vec![]));
        assert!(
            matches!(
                session_zip_bytes(&good, &files),
                Err(Error::Argument { .. })
            ),
            "{name}"
        );
    }
    assert!(fs::read_dir(dir.path()).unwrap().next().is_none());
}
