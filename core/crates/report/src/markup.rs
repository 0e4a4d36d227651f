//! HTML and SVG that is well formed by construction: tags and attribute names are the program's
//! own, all else is escaped.

use super::pictures::Figure;
use super::words;
use gyradius_base::language::Language;
use gyradius_base::message::Argument;

/// Attributes of an element: names are the program's, values are escaped.
pub(super) type Attributes<'a> = &'a [(&'static str, &'a str)];

/// A piece of a document.
#[derive(Debug, Default)]
pub(super) struct Markup {
    text: String,
    language: Language,
}

impl Markup {
    /// An empty piece in a language.
    pub fn in_language(language: Language) -> Self {
        Self {
            language,
            ..Self::default()
        }
    }

    /// The language that it is written in.
    pub fn language(&self) -> Language {
        self.language
    }

    /// A text of the report.
    pub fn say(&self, key: &str) -> String {
        words::say(self.language, key, [])
    }

    /// A text of the report with what it names.
    pub fn tell<'a>(
        &self,
        key: &str,
        named: impl IntoIterator<Item = (&'a str, Argument)>,
    ) -> String {
        words::say(self.language, key, named)
    }

    /// Message, escaped.
    pub fn write(&mut self, text: &str) {
        text.chars().for_each(|character| self.push(character));
    }

    fn push(&mut self, character: char) {
        match character {
            '&' => self.raw("&amp;"),
            '<' => self.raw("&lt;"),
            '>' => self.raw("&gt;"),
            '"' => self.raw("&quot;"),
            '\'' => self.raw("&#39;"),
            // Other control characters are not allowed in a document.
            '\n' | '\t' => self.text.push(character),
            _ if character.is_control() => self.text.push(char::REPLACEMENT_CHARACTER),
            _ => self.text.push(character),
        }
    }

    /// The program's own markup, as it stands.
    pub fn raw(&mut self, markup: &'static str) {
        self.text.push_str(markup);
    }

    /// A picture that was drawn with this writer.
    pub fn picture(&mut self, figure: &Figure) {
        self.text.push_str(&figure.svg);
    }

    /// Another piece.
    pub fn append(&mut self, other: Self) {
        self.text.push_str(&other.text);
    }

    /// JSON inside a script element: no character is left that HTML could take for a tag or an
    /// entity.
    pub fn json(&mut self, json: &str) {
        self.text.push_str(
            &json
                .replace('<', "\\u003c")
                .replace('>', "\\u003e")
                .replace('&', "\\u0026"),
        );
    }

    /// An element around whatever `inner` writes.
    pub fn within(
        &mut self,
        name: &'static str,
        attributes: Attributes,
        inner: impl FnOnce(&mut Self),
    ) {
        self.start(name, attributes);
        self.raw(">");
        inner(self);
        self.raw("</");
        self.raw(name);
        self.raw(">");
    }

    /// An element with text alone.
    pub fn element(&mut self, name: &'static str, attributes: Attributes, text: &str) {
        self.within(name, attributes, |inner| inner.write(text));
    }

    /// A part of the report that is shown once its heading is clicked; open on paper.
    pub fn folded(&mut self, id: &str, heading: &str, inner: impl FnOnce(&mut Self)) {
        let heading = self.say(heading);
        self.within("details", &[("id", id), ("class", "part")], |out| {
            out.within("summary", &[], |out| out.element("h2", &[], &heading));
            inner(out);
        });
    }

    /// An element without content.
    pub fn empty(&mut self, name: &'static str, attributes: Attributes) {
        self.start(name, attributes);
        self.raw("/>");
    }

    fn start(&mut self, name: &'static str, attributes: Attributes) {
        self.raw("<");
        self.raw(name);
        for (key, value) in attributes {
            self.raw(" ");
            self.raw(key);
            self.raw("=\"");
            self.write(value);
            self.raw("\"");
        }
    }

    /// The text so far.
    pub fn into_string(self) -> String {
        self.text
    }
}
