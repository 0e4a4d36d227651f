//! Structures that are lists of named numbers: what a simulation can be asked to differentiate by.

/// The name and unit of a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Number {
    /// Name, its unit at its end.
    pub name: &'static str,
    /// Unit.
    pub unit: &'static str,
}

/// A structure of named numbers, in a fixed order.
pub trait Numbers<S>: Sized {
    /// Names and units, in order.
    const NUMBERS: &'static [Number];
    /// The numbers, in order.
    fn to_numbers(&self) -> Vec<S>;
    /// From the numbers, in order; `None` where they are too few.
    fn from_numbers(numbers: &mut dyn Iterator<Item = S>) -> Option<Self>;
}

/// Declares a structure of numbers: `name: "unit"` for each.
macro_rules! numbers {
    ($(#[$doc:meta])* pub struct $name:ident { $($(#[$field_doc:meta])* $field:ident: $unit:literal,)* }) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct $name<S = f64> {
            $($(#[$field_doc])* pub $field: S,)*
        }

        impl<S: Copy> $crate::Numbers<S> for $name<S> {
            const NUMBERS: &'static [$crate::Number] =
                &[$($crate::Number { name: stringify!($field), unit: $unit },)*];
            fn to_numbers(&self) -> Vec<S> {
                vec![$(self.$field,)*]
            }
            fn from_numbers(numbers: &mut dyn Iterator<Item = S>) -> Option<Self> {
                Some(Self { $($field: numbers.next()?,)* })
            }
        }

        impl<S: Copy> $name<S> {
            /// The same structure over other numbers.
            #[allow(dead_code, reason = "not every structure of numbers is mapped")]
            pub fn map<T>(&self, f: impl Fn(S) -> T) -> $name<T> {
                $name { $($field: f(self.$field),)* }
            }
        }

        impl Default for $name<f64> {
            fn default() -> Self {
                Self { $($field: 0.0,)* }
            }
        }
    };
}
pub(crate) use numbers;
