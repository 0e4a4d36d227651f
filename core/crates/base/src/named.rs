//! Types whose values have a name in files: the only place where that text is written or read.

/// Declares an enumeration whose variants have a name in files. Variants stand in the order of
/// their names.
#[macro_export]
macro_rules! named {
    (
        $(#[$about:meta])*
        $kind:ident: $what:literal {
            $($(#[$variant_about:meta])* $variant:ident = $name:literal),+ $(,)?
        }
    ) => {
        $(#[$about])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[derive(serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        pub enum $kind {
            $($(#[$variant_about])* #[serde(rename = $name)] $variant),+
        }

        impl $kind {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$variant),+];

            /// Its name in files.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name),+
                }
            }
        }

        impl std::fmt::Display for $kind {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.pad(self.name())
            }
        }

        impl std::str::FromStr for $kind {
            type Err = $crate::error::Error;

            fn from_str(text: &str) -> $crate::error::Result<Self> {
                let known = || Self::ALL.iter().map(|k| k.name()).collect::<Vec<_>>().join(", ");
                let found = Self::ALL.iter().find(|kind| kind.name() == text);
                found
                    .copied()
                    .ok_or_else(|| $crate::error::Error::argument($what, known(), text))
            }
        }
    };
}

/// Gives a type that is a text in files (`Display` and `FromStr`) the serialisation of that text;
/// with a description, the schema of a text so described too.
#[macro_export]
macro_rules! written_as_text {
    ($kind:ident) => {
        impl serde::Serialize for $kind {
            fn serialize<S: serde::Serializer>(
                &self,
                to: S,
            ) -> std::result::Result<S::Ok, S::Error> {
                to.collect_str(self)
            }
        }

        impl<'de> serde::Deserialize<'de> for $kind {
            fn deserialize<D: serde::Deserializer<'de>>(
                from: D,
            ) -> std::result::Result<Self, D::Error> {
                let text = <std::borrow::Cow<str> as serde::Deserialize>::deserialize(from)?;
                text.parse().map_err(serde::de::Error::custom)
            }
        }
    };
    ($kind:ident, $about:literal) => {
        $crate::written_as_text!($kind);

        impl schemars::JsonSchema for $kind {
            fn schema_name() -> std::borrow::Cow<'static, str> {
                stringify!($kind).into()
            }

            fn json_schema(_: &mut schemars::SchemaGenerator) -> schemars::Schema {
                schemars::json_schema!({ "type": "string", "description": $about })
            }
        }
    };
}

/// Gives a type the order of its texts: files list it so.
#[macro_export]
macro_rules! ordered_as_text {
    ($kind:ident) => {
        impl PartialOrd for $kind {
            fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
                Some(self.cmp(other))
            }
        }

        impl Ord for $kind {
            fn cmp(&self, other: &Self) -> std::cmp::Ordering {
                self.to_string().cmp(&other.to_string())
            }
        }
    };
}
