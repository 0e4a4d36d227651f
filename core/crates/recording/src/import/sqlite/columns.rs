//! The columns of a table by the statement that made it.

/// Columns as they are declared.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Declared {
    pub names: Vec<String>,
    /// The column that is another name of the rowid.
    pub rowid: Option<usize>,
}

/// Words that begin a constraint of the table instead of a column.
const CONSTRAINTS: [&str; 5] = ["CONSTRAINT", "PRIMARY", "UNIQUE", "CHECK", "FOREIGN"];

/// The columns of `CREATE TABLE name (…)`; `None` where it is another statement, or the table has
/// no rowids.
pub(super) fn declared(statement: &str) -> Option<Declared> {
    let tokens = tokens(statement);
    let open = tokens.iter().position(|token| token.is("("))?;
    let mut depth = 0_usize;
    let mut definitions: Vec<Vec<&Token>> = vec![Vec::new()];
    let mut after = tokens.len();
    for (place, token) in tokens.iter().enumerate().skip(open + 1) {
        match token.mark() {
            Some("(") => depth += 1,
            Some(")") if depth == 0 => {
                after = place + 1;
                break;
            }
            Some(")") => depth -= 1,
            Some(",") if depth == 0 => {
                definitions.push(Vec::new());
                continue;
            }
            _ => {}
        }
        if let Some(last) = definitions.last_mut() {
            last.push(token);
        }
    }
    let tail = tokens.get(after..).unwrap_or_default();
    if tail
        .windows(2)
        .any(|two| two[0].is("WITHOUT") && two[1].is("ROWID"))
    {
        return None;
    }
    let mut columns = Declared {
        names: Vec::new(),
        rowid: None,
    };
    for definition in &definitions {
        let Some((name, rest)) = definition.split_first() else {
            continue;
        };
        if CONSTRAINTS.iter().any(|word| name.is(word)) {
            continue;
        }
        let is_integer = rest.first().is_some_and(|kind| kind.is("INTEGER"));
        let is_key = rest
            .windows(2)
            .any(|two| two[0].is("PRIMARY") && two[1].is("KEY"));
        if is_integer && is_key {
            columns.rowid = Some(columns.names.len());
        }
        columns.names.push(name.text.clone());
    }
    Some(columns)
}

/// A word, a name in quotes or a mark.
struct Token {
    text: String,
    is_quoted: bool,
}

impl Token {
    /// True for a word or a mark that is not in quotes.
    fn is(&self, word: &str) -> bool {
        !self.is_quoted && self.text.eq_ignore_ascii_case(word)
    }

    fn mark(&self) -> Option<&str> {
        (!self.is_quoted).then_some(self.text.as_str())
    }
}

fn tokens(statement: &str) -> Vec<Token> {
    let mut tokens = Vec::new();
    let mut chars = statement.chars().peekable();
    while let Some(first) = chars.next() {
        let close = match first {
            '"' | '`' | '\'' => Some(first),
            '[' => Some(']'),
            _ => None,
        };
        let mut text = String::new();
        if let Some(close) = close {
            while let Some(c) = chars.next() {
                if c == close {
                    // A quote that stands twice is one of the name.
                    if close == ']' || chars.next_if_eq(&close).is_none() {
                        break;
                    }
                }
                text.push(c);
            }
        } else if first.is_whitespace() {
            continue;
        } else {
            text.push(first);
            let is_word = |c: &char| c.is_alphanumeric() || *c == '_' || *c == '$';
            if is_word(&first) {
                while let Some(c) = chars.next_if(is_word) {
                    text.push(c);
                }
            }
        }
        tokens.push(Token {
            text,
            is_quoted: close.is_some(),
        });
    }
    tokens
}
