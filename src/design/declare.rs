//! How a table of the file is declared: struct, schema and reader from one list of fields.

/// Declares structs that are read from tables of a design file. A field is
///
/// ```text
/// /// What it is.
/// pub length: f64 = "length_mm", Kind::Number(Quantity::Length, Limit::Positive), Presence::Required;
/// ```
///
/// and gives the struct field, its line in `TABLE` and its reading. Fields after `also` are keys without a struct field.
macro_rules! tables {
    ($(
        $(#[doc = $doc:literal])+
        #[derive($($derive:ident),*)]
        pub struct $name:ident as $table:literal {
            $(
                #[doc = $field_doc:literal]
                pub $field:ident : $type:ty = $key:literal, $kind:expr, $presence:expr;
            )*
        }
        $(also $extra:expr;)*
    )*) => {$(
        $(#[doc = $doc])+
        #[derive($($derive),*)]
        pub struct $name {
            $(
                #[doc = $field_doc]
                #[doc = concat!("\n\nIn files `", $key, "`.")]
                pub $field: $type,
            )*
        }

        impl $name {
            /// The keys it is read from.
            pub const TABLE: &'static $crate::design::schema::Table = &$crate::design::schema::Table {
                name: $table,
                doc: concat!($($doc),+).trim_ascii(),
                fields: &[
                    $($crate::design::schema::Field {
                        name: stringify!($field),
                        key: $key,
                        doc: $field_doc.trim_ascii(),
                        kind: $kind,
                        presence: $presence,
                    },)*
                    $($extra,)*
                ],
            };
        }

        impl $crate::design::read::FromTable for $name {
            const TABLE: &'static $crate::design::schema::Table = $name::TABLE;

            fn from_table(reader: &mut $crate::design::read::TableReader<'_>) -> Self {
                Self {
                    $($field: {
                        const FIELD: &$crate::design::schema::Field = &$crate::design::schema::Field {
                            name: stringify!($field),
                            key: $key,
                            doc: $field_doc.trim_ascii(),
                            kind: $kind,
                            presence: $presence,
                        };
                        $crate::design::read::FromFile::from_file(reader, FIELD)
                    },)*
                }
            }
        }
    )*};
}

/// Declares enums that are written as one of a few words; the first one stands in where none could be read.
macro_rules! words {
    ($(
        $(#[doc = $doc:literal])+
        pub enum $name:ident {
            $first:ident = $first_word:literal,
            $($(#[doc = $variant_doc:literal])* $variant:ident = $word:literal,)*
        }
    )*) => {$(
        $(#[doc = $doc])+
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum $name {
            #[doc = concat!("`", $first_word, "`")]
            $first,
            $(#[doc = concat!("`", $word, "`")] $variant,)*
        }

        impl $name {
            /// The words of design files.
            pub const WORDS: &'static [&'static str] = &[$first_word, $($word),*];

            /// The word of design files.
            pub fn word(self) -> &'static str {
                match self {
                    Self::$first => $first_word,
                    $(Self::$variant => $word,)*
                }
            }
        }

        impl $crate::design::read::FromFile for Option<$name> {
            fn from_file(
                reader: &mut $crate::design::read::TableReader<'_>,
                field: &'static $crate::design::schema::Field,
            ) -> Self {
                reader.is_written(field).then(|| $crate::design::read::FromFile::from_file(reader, field))
            }
        }

        impl $crate::design::read::FromFile for $name {
            fn from_file(
                reader: &mut $crate::design::read::TableReader<'_>,
                field: &'static $crate::design::schema::Field,
            ) -> Self {
                match reader.word(field, Self::WORDS) {
                    $(Some($word) => Self::$variant,)*
                    _ => Self::$first,
                }
            }
        }
    )*};
}
