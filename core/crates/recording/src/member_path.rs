//! Names of files inside a session: plain relative paths, the same on every system.

/// The name in its plain form (`a/b.csv`), or why it cannot name a file inside a session.
///
/// # Conventions
/// Folders are joined by `/` on every system; a leading or inner `./` means nothing and is dropped.
pub(crate) fn plain_member_path(name: &str) -> std::result::Result<String, String> {
    if name.is_empty() {
        return Err("an empty name".into());
    }
    if name.chars().any(char::is_control) {
        return Err(format!("a name with a control character, {name:?}"));
    }
    if name.contains('\\') {
        return Err(format!("a backslash in `{name}`"));
    }
    if name.starts_with('/') || has_drive_letter(name) {
        return Err(format!("the absolute path `{name}`"));
    }
    if name.ends_with('/') {
        return Err(format!("the folder `{name}`"));
    }
    joined_parts(name)
}

fn joined_parts(name: &str) -> std::result::Result<String, String> {
    let mut parts = Vec::new();
    for part in name.split('/') {
        match part {
            "." => {}
            ".." => return Err(format!("`{name}`, which climbs out of the session")),
            "" => return Err(format!("an empty folder name in `{name}`")),
            _ => parts.push(part),
        }
    }
    if parts.is_empty() {
        Err(format!("the folder `{name}`"))
    } else {
        Ok(parts.join("/"))
    }
}

/// `C:` would leave the session on Windows, in any folder depth of the name.
fn has_drive_letter(name: &str) -> bool {
    name.split('/').any(|part| {
        let bytes = part.as_bytes();
        bytes.len() >= 2 && bytes[0].is_ascii_alphabetic() && bytes[1] == b':'
    })
}

#[cfg(test)]
mod tests {
    use super::plain_member_path;

    #[test]
    fn plain_names_pass() {
        for (name, plain) in [
            ("a.csv", "a.csv"),
            ("./a/b.csv", "a/b.csv"),
            ("..a/b..csv", "..a/b..csv"),
        ] {
            assert_eq!(plain_member_path(name).as_deref(), Ok(plain));
        }
    }

    #[test]
    fn names_that_leave_the_session_are_refused() {
        for name in [
            "",
            ".",
            "/etc/passwd",
            "../a",
            "a/../../b",
            "a//b",
            "a/",
            "a\\b",
            "..\\a",
            "C:a",
            "a/C:/b",
            "a\0b",
            "a\nb",
            "//host/a",
        ] {
            assert!(plain_member_path(name).is_err(), "{name:?}");
        }
    }
}
