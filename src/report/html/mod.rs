//! Studies as one HTML page that needs nothing but itself: no script, no other file, no network. It is well-formed XML too.

mod bands;
mod design;
mod figures;
mod masses;
mod modes;
mod pair;
mod shown;
mod table;

pub use shown::shown;

use std::fmt::Write as _;

use super::markup::escape;
use super::study::Study;
use super::svg::{self, Picture, STYLE};
use crate::design::{Loaded, hash};
use crate::model::mesh_frequency_hz;

/// One design of a page.
#[derive(Debug, Clone, Copy)]
pub struct Entry<'a> {
    pub loaded: &'a Loaded,
    pub study: &'a Study,
}

/// The whole page; `date` as `2026-01-31`. The same entries and date give the same bytes.
pub fn page(entries: &[Entry<'_>], date: &str) -> String {
    let one = match entries {
        [entry] => Some(entry.loaded.design.name.clone()),
        _ => None,
    };
    let title = one.clone().unwrap_or_else(|| format!("{} geared rotor designs", entries.len()));
    let mut out = start(&title);
    if one.is_none() {
        out.push_str(&contents(entries, &title));
    }
    out.push_str("<main>\n");
    for (i, entry) in entries.iter().enumerate() {
        let article =
            Article { entry: *entry, id: format!("d{}", i + 1), level: if one.is_some() { 1 } else { 2 }, date };
        out.push_str(&article.render());
    }
    out.push_str("</main>\n</body>\n</html>\n");
    out
}

/// All before the content of the body.
fn start(title: &str) -> String {
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<title>{} - bevelscope</title>\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n\
         <meta name=\"color-scheme\" content=\"light dark\"/>\n<style>{STYLE}{}</style>\n</head>\n<body>\n",
        escape(title),
        include_str!("page.css"),
    )
}

fn contents(entries: &[Entry<'_>], title: &str) -> String {
    let mut out = format!("<header>\n<h1>{}</h1>\n<nav aria-label=\"designs\">\n<ol>\n", escape(title));
    for (i, Entry { loaded, study }) in entries.iter().enumerate() {
        // writing to a String cannot fail
        let _ = writeln!(
            out,
            "<li><a href=\"#d{}\"><bdi>{}</bdi></a>: {}</li>",
            i + 1,
            escape(&loaded.design.name),
            escape(&figures::trust(study))
        );
    }
    out.push_str("</ol>\n</nav>\n</header>\n");
    out
}

/// The part of the page about one design.
struct Article<'a> {
    entry: Entry<'a>,
    /// Before all ids in it
    id: String,
    /// Of its heading
    level: u8,
    date: &'a str,
}

impl Article<'_> {
    fn render(&self) -> String {
        let Entry { loaded, study } = self.entry;
        let design = &loaded.design;
        let id = &self.id;
        let figure = |picture: &Picture, caption: &str| {
            let picture = picture.inline(&format!("{id}-"));
            format!("<figure>\n{picture}\n<figcaption>{}</figcaption>\n</figure>\n", escape(caption))
        };
        let spectra = figure(
            &svg::spectra(design, study),
            &format!(
                "Resonances and antiresonances are drawn exactly, also between the lines of the analysis. Numbered bands: the list below.{}",
                mesh_frequency_hz(design).map_or_else(String::new, svg::harmonics_in_words)
            ),
        );
        let levels = figure(&svg::levels(design, study), "Mean square of the lines in each band.");
        let side_view = figure(
            &svg::side_view(design),
            "Bodies are the cylinders with their mass and inertias (dashed); triangles are bearings, filled where rigid; the cross is the \
             mesh point.",
        );
        [
            format!("<article id=\"{id}\" aria-labelledby=\"{id}-name\">\n"),
            self.head(),
            self.section("Figures", &figures::render(study)),
            self.section("Dynamic mesh force", &spectra),
            self.section("Where the enhanced model disagrees, and why", &bands::render(study)),
            self.section("Sixth-octave levels", &format!("{levels}{}", bands::levels(study))),
            self.section("Resonance peaks", &figures::peaks(study)),
            self.section("Natural modes with the mesh", &modes::render(study)),
            self.section("Gear pair", &pair::render(design, figure)),
            self.section("Masses at the mesh", &masses::render(study)),
            self.section("Side view", &side_view),
            self.section("The design", &design::render(loaded)),
            self.section("Warnings and fallbacks", &design::warnings(loaded, study)),
            "</article>\n".to_owned(),
        ]
        .concat()
    }

    fn head(&self) -> String {
        let Entry { loaded, .. } = self.entry;
        let design = &loaded.design;
        let level = self.level;
        let mut out =
            format!("<header>\n<h{level} id=\"{}-name\"><bdi>{}</bdi></h{level}>\n", self.id, escape(&design.name));
        for text in [&design.description, &design.note].into_iter().flatten().filter(|text| !text.trim().is_empty()) {
            let lines: Vec<String> = text.trim().lines().map(escape).collect();
            let _ = writeln!(out, "<p dir=\"auto\">{}</p>", lines.join("<br/>\n"));
        }
        // a page is passed on: the folders are nobody else's business
        let file = loaded.file_name();
        let facts = [
            ("File", format!("<bdi>{}</bdi>", escape(&file))),
            ("Design hash", format!("{} (SHA-256)", hash(loaded.text.as_bytes()))),
            ("Program", format!("bevelscope {}", env!("CARGO_PKG_VERSION"))),
            ("Date", format!("<time datetime=\"{0}\">{0}</time>", escape(self.date))),
        ];
        out.push_str("<dl class=\"facts\">\n");
        for (name, fact) in facts {
            let _ = writeln!(out, "<dt>{name}</dt><dd>{fact}</dd>");
        }
        out.push_str("</dl>\n</header>\n");
        out
    }

    fn section(&self, heading: &str, content: &str) -> String {
        let level = self.level + 1;
        format!("<section>\n<h{level}>{heading}</h{level}>\n{content}</section>\n")
    }
}
