//! Over the gear pair: a face width while it is typed, a table of mesh numbers, and what it would change.

use ratatui::buffer::Buffer;
use ratatui::layout::{Position, Rect};
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::number::significant;
use crate::pair::METHOD;
use crate::text::{cut, printable, wrap};
use crate::tui::action::Action;
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::pair::Preview;
use crate::tui::widgets::panel::{self, Title};

const WIDTH: u16 = 72;

/// Draws the two values that are typed, and what follows from them; returns where the cursor stands.
pub fn render_estimate(app: &App, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let theme = app.theme;
    let form = app.pair.as_ref()?.estimate.as_ref()?;
    let room = usize::from(area.width.min(WIDTH).saturating_sub(4));
    let mut lines: Vec<(String, Style)> = vec![(String::new(), theme.fe)];
    match form.estimate() {
        Ok(estimate) => {
            lines.push((format!("estimate  {} N/m", estimate.written()), theme.title));
            lines.push((format!("          = {}", estimate.formula), theme.fe));
        }
        Err(wanted) => {
            let untouched = form.width.is_empty();
            let text = if untouched { "estimate  none without a face width, e.g. 21.59 mm".into() } else { wanted };
            let style = if untouched { theme.faint } else { theme.error };
            lines.extend(wrap(&text, room).into_iter().map(|line| (line, style)));
        }
    }
    let now = app.editors.open().and_then(|editing| editing.last_design.as_ref());
    if let Some(design) = now {
        lines.push((format!("now       {} N/m", significant(design.mesh.stiffness, 4)), theme.fe));
    }
    let keys = |action| app.keys.of(Mode::FaceWidth, action, theme.glyphs.ascii).join(" ");
    let said = format!(
        "An {METHOD}. {} takes it over, which can be undone; {} leaves all as it is.",
        keys(Action::Accept),
        keys(Action::Back)
    );
    lines.push((String::new(), theme.fe));
    lines.extend(wrap(&said, room).into_iter().map(|line| (line, theme.faint)));
    let window = super::window(area, WIDTH, lines.len() as u16 + 4, buffer);
    let inner = panel::frame(window, buffer, &Title::left("Mesh stiffness: an estimate"), true, &theme);
    for ((line, style), y) in lines.iter().zip((inner.top() + 2)..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, room, *style);
    }
    let line = |y: u16| Rect { y: inner.y + y, height: u16::from(y < inner.height), ..inner };
    let width = super::typed(" effective face width: ", &form.width, &theme, line(0), buffer);
    let angle = super::typed(" mean spiral or helix angle: ", &form.angle, &theme, line(1), buffer);
    if form.on_angle { angle } else { width }
}

/// Draws the name of the table; returns where the cursor stands.
pub fn render_file(app: &App, area: Rect, buffer: &mut Buffer) -> Option<Position> {
    let theme = app.theme;
    let form = app.pair.as_ref()?.import.as_ref()?;
    let room = usize::from(area.width.min(WIDTH).saturating_sub(4));
    let key = app.keys.of(Mode::MeshFile, Action::OtherFlank, theme.glyphs.ascii).join(" ");
    let (style, text) = match &form.refused {
        _ if form.pending.is_some() => (theme.faint, format!("reading{}", theme.glyphs.ellipsis)),
        Some(error) => (theme.error, format!("{} {error}", theme.glyphs.broken)),
        None => {
            (theme.faint, "CSV: mesh point, line of action, stiffness, transmission error; nothing changes yet".into())
        }
    };
    let lines = wrap(&text, room);
    let height = (lines.len() as u16).saturating_add(4);
    let window = super::window(area, WIDTH, height, buffer);
    let inner = panel::frame(window, buffer, &Title::left("Import averaged mesh numbers"), true, &theme);
    let flank = format!("flank: {} ({key}: {})", form.flank.word(), form.flank.other().word());
    let lines = std::iter::once((flank, theme.fe)).chain(lines.into_iter().map(|line| (line, style)));
    for ((line, style), y) in lines.zip(inner.top() + 1..inner.bottom()) {
        buffer.set_stringn(inner.x + 1, y, line, room, style);
    }
    super::typed(" file: ", &form.field, &theme, Rect { height: inner.height.min(1), ..inner }, buffer)
}

/// Draws what the flank would change.
pub fn render_import(app: &mut App, area: Rect, buffer: &mut Buffer) {
    let theme = app.theme;
    let keys = |action| app.keys.of(Mode::MeshImport, action, theme.glyphs.ascii).join(" ");
    let [accept, other, back] = [Action::Accept, Action::OtherFlank, Action::Back].map(keys);
    let Some(form) = app.pair.as_mut().and_then(|view| view.import.as_mut()) else { return };
    let room = usize::from(area.width.min(WIDTH).saturating_sub(4));
    let other = format!("{other}: {} flank", form.flank.other().word());
    let (mut lines, ask) = match &form.preview {
        Some(Ok(preview)) => {
            let lines = changes(preview, room).into_iter().map(|line| (line, theme.fe));
            let findings = preview.findings.iter().flat_map(|finding| wrap(&format!("! {finding}"), room));
            let lines: Vec<_> = lines.chain(findings.map(|line| (line, theme.warning))).collect();
            (lines, format!("{accept}: take over   {other}   {back}: leave as it is"))
        }
        Some(Err(error)) => {
            let lines = wrap(&printable(error), room).into_iter().map(|line| (line, theme.error));
            (lines.collect(), format!("{other}   {back}: leave as it is"))
        }
        None => (Vec::new(), String::new()),
    };
    if lines.is_empty() {
        lines.push(("nothing would change: the design has these numbers".into(), theme.fe));
    }
    let window = super::window(area, WIDTH, u16::try_from(lines.len() + 4).unwrap_or(u16::MAX), buffer);
    let title = format!("Import: the {} flank would change", form.flank.word());
    let inner = panel::frame(window, buffer, &Title::left(title), true, &theme);
    let height = inner.height.saturating_sub(2);
    form.scroll.fit(lines.len(), usize::from(height));
    for ((line, style), y) in lines.iter().skip(form.scroll.top).zip(inner.top()..inner.top() + height) {
        buffer.set_stringn(inner.x + 1, y, cut(line, room, theme.glyphs.ellipsis), room, *style);
    }
    let y = inner.bottom().saturating_sub(1);
    buffer.set_stringn(inner.x + 1, y, cut(&ask, room, theme.glyphs.ellipsis), room, theme.title);
    if let Some(position) = form.scroll.position() {
        panel::bottom(window, buffer, &Title::left(format!("lines {position}")), true, &theme);
    }
}

/// `stiffness of mesh   6.4e8 -> 5.1e8 N/m`, in columns.
fn changes(preview: &Preview, room: usize) -> Vec<String> {
    let label = preview.changes.iter().map(|[label, ..]| label.width()).max().unwrap_or(0).min(room / 2);
    let old = preview.changes.iter().map(|[_, old, ..]| old.width()).max().unwrap_or(0).min(room / 4);
    let line = |[name, a, b, unit]: &[String; 4]| {
        format!("{:label$}  {:>old$} -> {b} {unit}", cut(name, label, "."), cut(a, old, "."))
    };
    preview.changes.iter().map(line).collect()
}
