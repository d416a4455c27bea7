//! The reference page of design files, made from the schema.

use std::fmt::Write as _;

use super::schema::{Field, Kind, Limit, Presence, ROOT, Written};

/// `docs/design-file.md`: every table with its keys, what they mean, what is allowed and what holds where they are not written.
pub fn page() -> String {
    let mut page = String::from(HEAD);
    for table in ROOT.walk() {
        let title = if table == ROOT { "The file" } else { table.name };
        // what follows the first sentence is for readers of the code
        let doc = table.doc.trim().split(". ").next().unwrap_or_default().trim_end_matches('.');
        let _ = writeln!(page, "\n## {title}\n\n{doc}.\n");
        let _ = writeln!(page, "| key | meaning | allowed | if left out |\n| --- | --- | --- | --- |");
        for field in table.fields {
            let _ = writeln!(
                page,
                "| `{}` | {} | {} | {} |",
                field.key,
                field.doc.trim().replace('|', "\\|"),
                allowed(field).replace('|', "\\|"),
                left_out(field)
            );
        }
    }
    page
}

const HEAD: &str = "# Design files

One design is one TOML file. Keys carry their unit; numbers may be written as integers or with a decimal point. This page is made
from the schema that the program reads files by, and a test keeps it so. The shipped files in `designs/` are commented examples.

Each shaft has its own frame: **y runs along the shaft** from its start, x is horizontal, z vertical; tilts are about those
axes. Positions are counted from the shaft's start. The mesh point is relative to the mesh station, and the two lines of action are the
same physical vector, each in its own shaft's frame: the direction of the force on the gear.
";

fn allowed(field: &Field) -> String {
    let list = |words: &[&str]| words.iter().map(|word| format!("`\"{word}\"`")).collect::<Vec<_>>().join(", ");
    match field.kind {
        Kind::Number(quantity, limit) => match limit {
            Limit::Any => format!("a number, {}", quantity.unit()).trim_end_matches(", ").to_owned(),
            _ => limit.describe(quantity),
        },
        Kind::Whole(low, u64::MAX) => format!("a whole number, at least {low}"),
        Kind::Whole(low, high) if high == u64::from(u32::MAX) => format!("a whole number, at least {low}"),
        Kind::Whole(low, high) if low == high => format!("{low}"),
        Kind::Whole(low, high) => format!("a whole number from {low} to {high}"),
        Kind::Text => "text".into(),
        Kind::Name => "text that is not empty".into(),
        Kind::Texts => "a list of texts".into(),
        Kind::Word(words) => list(words),
        Kind::Words(words) => format!("a list of any of {}", list(words)),
        Kind::Vector(quantity) => format!("three numbers x, y, z {}", quantity.unit()).trim_end().to_owned(),
        Kind::Matrix => "six rows of six numbers: x, y, z (N/m, N/rad), thx, thy, thz (N, N m/rad)".into(),
        Kind::Table(table) => format!("a table, see {}", table.name),
        Kind::Tables(table, least) => format!("a list of tables, at least {least}, see {}", table.name),
        Kind::NamedTables(table) => format!("tables by name, see {}", table.name),
        Kind::Variant(variants) => {
            let words: Vec<&str> = variants.iter().map(|variant| variant.word).collect();
            format!("{}, each with keys of its own", list(&words))
        }
    }
}

fn left_out(field: &Field) -> String {
    let written = |written: Written| match written {
        Written::Number(value) => format!("{value}"),
        Written::Whole(value) => format!("{value}"),
        Written::Text(text) => format!("`\"{text}\"`"),
        Written::ByPlace(text) => format!("`\"{text}1\"`, `\"{text}2\"` by place"),
        Written::Empty => "the defaults, or none".into(),
    };
    match field.presence {
        Presence::Required => "must be there".into(),
        Presence::Unless(other) => format!("must be there, unless `{other}` is"),
        Presence::Optional => "-".into(),
        Presence::Default(value) => written(value),
        Presence::DefaultIn(name, value) => format!("{} in `{name}`, must be there in others", written(value)),
    }
}
