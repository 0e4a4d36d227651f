//! A `.zip` into memory, with nothing in it believed: neither its paths nor its sizes.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};

use flate2::read::MultiGzDecoder;
use zip::ZipArchive;
use zip::read::ZipFile;
use zip::result::ZipError;

use super::member_path::plain_member_path;
use gyradius_base::error::{Error, Result};

/// Most files an archive or a folder may hold: a session has tens.
pub(crate) const MAX_MEMBERS: usize = 4096;
/// Largest single file, bytes: six channels at 100 Hz as text are about 30 MB an hour, a swing
/// about 1 MB.
pub(crate) const MAX_MEMBER_BYTES: u64 = 256 << 20;
/// Largest sum of all files, bytes, decompressed: what a phone can hold in memory.
pub(crate) const MAX_TOTAL_BYTES: u64 = 512 << 20;
/// Highest ratio of decompressed to compressed size. Sensor text packs 2 to 10 times, a constant
/// column up to about 100 times; deflate's own limit, which bombs approach, is 1032.
const MAX_RATIO: u64 = 200;
/// Size below which the ratio is not looked at, bytes.
const RATIO_FREE_BYTES: u64 = 1 << 20;

/// Limits of one archive; tests lower them.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Limits {
    pub members: usize,
    pub member_bytes: u64,
    pub total_bytes: u64,
    pub ratio: u64,
}

const LIMITS: Limits = Limits {
    members: MAX_MEMBERS,
    member_bytes: MAX_MEMBER_BYTES,
    total_bytes: MAX_TOTAL_BYTES,
    ratio: MAX_RATIO,
};

/// All files of an archive by plain name.
pub(crate) fn unzip(archive: &str, bytes: &[u8]) -> Result<BTreeMap<String, Vec<u8>>> {
    unzip_within(archive, bytes, LIMITS)
}

pub(crate) fn unzip_within(
    archive: &str,
    bytes: &[u8],
    limits: Limits,
) -> Result<BTreeMap<String, Vec<u8>>> {
    let mut zip = ZipArchive::new(Cursor::new(bytes)).map_err(|e| not_a_zip(archive, &e))?;
    if zip.has_duplicate_names() {
        return Err(unsafe_archive(
            archive,
            "it holds two files of one name".into(),
        ));
    }
    if zip.len() > limits.members {
        let reason = format!("it holds {} files, more than {}", zip.len(), limits.members);
        return Err(unsafe_archive(archive, reason));
    }
    let mut files = BTreeMap::new();
    let whole = limits
        .total_bytes
        .min(allowed_by_ratio(bytes.len() as u64, limits));
    let mut left = whole;
    for index in 0..zip.len() {
        let member = zip.by_index(index).map_err(|e| not_a_zip(archive, &e))?;
        let Some(name) = checked_name(archive, &member)? else {
            continue;
        };
        let content = checked_content(archive, &name, member, left, limits)?;
        left -= content.len() as u64;
        if files.insert(name.clone(), content).is_some() {
            return Err(unsafe_archive(archive, format!("it holds `{name}` twice")));
        }
    }
    Ok(files)
}

/// Whether bytes are those of a file compressed by itself (RFC 1952).
pub(crate) fn is_gzip(bytes: &[u8]) -> bool {
    bytes.starts_with(&[0x1f, 0x8b])
}

/// A file that was compressed by itself, `name.csv.gz`, within the limits of a member.
pub(crate) fn gunzip(name: &str, bytes: &[u8]) -> Result<Vec<u8>> {
    let by_ratio = allowed_by_ratio(bytes.len() as u64, LIMITS);
    let limit = LIMITS.member_bytes.min(by_ratio);
    read_within(name, MultiGzDecoder::new(bytes), limit)?
        .ok_or_else(|| beyond(name, name, limit == by_ratio, LIMITS))
}

/// All that there is to read, no further than a limit; `None` where there is more.
fn read_within(file: &str, from: impl Read, limit: u64) -> Result<Option<Vec<u8>>> {
    let mut content = Vec::new();
    let read = from.take(limit + 1).read_to_end(&mut content);
    if content.len() as u64 > limit {
        return Ok(None);
    }
    read.map_err(|e| Error::Unreadable {
        file: file.to_owned(),
        reason: e.to_string(),
    })?;
    Ok(Some(content))
}

/// The plain name of a member; none for folders and for the shadow files that macOS adds.
fn checked_name<R: Read>(archive: &str, member: &ZipFile<'_, R>) -> Result<Option<String>> {
    let name = member.name().map_err(|e| not_a_zip(archive, &e))?;
    if member.is_symlink() {
        return Err(unsafe_archive(
            archive,
            format!("`{name}` is a symbolic link"),
        ));
    }
    let file = name.strip_suffix('/').unwrap_or(&name);
    if file == "." {
        return Ok(None);
    }
    let plain = plain_member_path(file)
        .map_err(|found| unsafe_archive(archive, format!("a member is {found}")))?;
    Ok((!member.is_dir() && !plain.starts_with("__MACOSX/")).then_some(plain))
}

/// Decompresses one member no further than the limits reach, whatever its header says of its size.
fn checked_content<R: Read>(
    archive: &str,
    name: &str,
    member: ZipFile<'_, R>,
    left: u64,
    limits: Limits,
) -> Result<Vec<u8>> {
    let by_ratio = allowed_by_ratio(member.compressed_size(), limits);
    let limit = limits.member_bytes.min(left).min(by_ratio);
    if let Some(content) = read_within(&format!("{archive}/{name}"), member, limit)? {
        return Ok(content);
    }
    if limit != left {
        return Err(beyond(archive, name, limit == by_ratio, limits));
    }
    let reason = format!(
        "it unpacks to far more than its size or {} MiB in all",
        limits.total_bytes >> 20
    );
    Err(unsafe_archive(archive, reason))
}

/// A file that unpacks to more than it may, by its ratio or by its size.
fn beyond(archive: &str, name: &str, by_ratio: bool, limits: Limits) -> Error {
    let most = match by_ratio {
        true => format!("{} times its size", limits.ratio),
        false => format!("{} bytes", limits.member_bytes),
    };
    unsafe_archive(archive, format!("`{name}` unpacks to more than {most}"))
}

fn allowed_by_ratio(compressed_bytes: u64, limits: Limits) -> u64 {
    compressed_bytes
        .saturating_mul(limits.ratio)
        .max(RATIO_FREE_BYTES)
}

fn unsafe_archive(archive: &str, reason: String) -> Error {
    Error::UnsafeArchive {
        file: archive.into(),
        reason,
    }
}

fn not_a_zip(archive: &str, error: &ZipError) -> Error {
    Error::Unreadable {
        file: archive.into(),
        reason: format!("not a .zip that can be read: {error}"),
    }
}
