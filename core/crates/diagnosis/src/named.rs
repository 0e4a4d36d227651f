//! Enumerations whose variants have a name in files.

/// Declares an enumeration whose variants have a name in files: the only place where their text is
/// written or read. Variants stand in the order of their names.
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
            type Err = gyradius_base::error::Error;

            fn from_str(text: &str) -> gyradius_base::error::Result<Self> {
                let known = || Self::ALL.iter().map(|k| k.name()).collect::<Vec<_>>().join(", ");
                let found = Self::ALL.iter().find(|kind| kind.name() == text);
                found
                    .copied()
                    .ok_or_else(|| gyradius_base::error::Error::argument($what, known(), text))
            }
        }
    };
}

/// Gives a type that is a text in files (`Display` and `FromStr`) the serialisation of that text.
macro_rules! written_as_text {
    ($kind:ty) => {
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
                let text = std::borrow::Cow::<str>::deserialize(from)?;
                text.parse().map_err(serde::de::Error::custom)
            }
        }
    };
}

pub(crate) use {named, written_as_text};
