//! The bands of disagreement, or the peaks in pairs, as a list that follows the cursor.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::panel::Title;
use crate::model::ModelKind;
use crate::number::grouped;
use crate::text::{cut, printable};
use crate::tui::spectra::{Band, Findings, Labelled, Listed, SpectraView};
use crate::tui::theme::Theme;

/// What is listed, and how much of it there is.
pub fn title(view: &SpectraView, theme: &Theme) -> Title<'static> {
    let Some(findings) = view.findings() else { return Title::left(theme.glyphs.ellipsis) };
    let (count, word) = match view.listed {
        Listed::Peaks => (findings.peaks.len(), "peak"),
        _ => (findings.bands.len(), "band"),
    };
    let plural = if count == 1 { "" } else { "s" };
    let against = crate::tui::spectra::legend_name(findings.against);
    let long = match view.listed {
        Listed::Peaks => format!("{count} {word}{plural}, FE and {against}; * the highest"),
        _ => format!("{count} {word}{plural}, {against} off by >{} dB line by line", findings.tolerance),
    };
    Title { left: vec![long, format!("{count} {word}{plural}")], right: Vec::new() }
}

/// Draws the list with its head.
pub fn render(view: &SpectraView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let Some(findings) = view.findings().filter(|_| !area.is_empty()) else { return };
    let width = usize::from(area.width);
    // a mode's name is worth more than the other model's peak
    let has_beside = width >= 60 && findings.beside.is_some();
    // the row that is in sight, and whether the cursor is in it
    let (head, rows, (near, at)): (String, Vec<String>, (Option<usize>, Option<usize>)) = match view.listed {
        Listed::Peaks => {
            (peak_heads(findings, has_beside), peak_rows(findings, has_beside), (view.peak_at(), view.peak_at()))
        }
        _ => (
            " from Hz   to Hz  worst dB  mode".into(),
            findings.bands.iter().map(|band| band_row(band, findings.is_complete)).collect(),
            (view.band_near(), view.band_under()),
        ),
    };
    buffer.set_stringn(area.x + 1, area.y, head, width.saturating_sub(1), theme.faint);
    let room = usize::from(area.height.saturating_sub(1));
    let top = near.map_or(0, |at| at.saturating_sub(room.saturating_sub(1) / 2)).min(rows.len().saturating_sub(room));
    for ((place, row), y) in rows.iter().enumerate().skip(top).zip(area.y + 1..area.bottom()) {
        let is_here = Some(place) == at;
        let mark = if is_here { theme.glyphs.selected } else { " " };
        let text = cut(row, width.saturating_sub(2), theme.glyphs.ellipsis);
        buffer.set_stringn(area.x, y, mark, 1, theme.key);
        buffer.set_stringn(area.x + 1, y, text, width - 1, if is_here { theme.title } else { Style::new() });
    }
    if rows.is_empty() && room > 0 {
        let text = if view.listed == Listed::Peaks { "none" } else { "no line is beyond the tolerance" };
        buffer.set_stringn(area.x + 1, area.y + 1, text, width.saturating_sub(1), theme.faint);
    }
}

fn band_row(Band { band, mode, .. }: &Band, is_complete: bool) -> String {
    let mode = match mode {
        Some((hz, name)) => format!("{} Hz {}", grouped(*hz), printable(name)),
        None if is_complete => "-".into(),
        None => "..".into(),
    };
    format!("{:>8}{:>8}{:>+10.1}  {mode}", grouped(band.from_hz), grouped(band.to_hz), band.worst_db)
}

/// Units above the columns of [`peak_row`].
fn peak_heads(findings: &Findings, has_beside: bool) -> String {
    let short = |kind: ModelKind| match kind {
        ModelKind::Enhanced => "enh. Hz".into(),
        ModelKind::Reduced(modes) => format!("r:{modes} Hz"),
        kind => format!("{} Hz", crate::tui::spectra::legend_name(kind)),
    };
    let beside = findings.beside.filter(|_| has_beside).map_or(String::new(), |kind| format!("{:>9}", short(kind)));
    format!(" #  FE Hz{:>8}   shift%  FE dB  diff dB{beside}  mode", short(findings.against))
}

fn peak_rows(findings: &Findings, has_beside: bool) -> Vec<String> {
    let highest = findings.highest_peak();
    let row = |(at, peak)| peak_row(at, peak, Some(at) == highest, has_beside);
    findings.peaks.iter().enumerate().map(row).collect()
}

fn peak_row(at: usize, peak: &Labelled, is_highest: bool, has_beside: bool) -> String {
    let Labelled { pair, beside_hz, mode, fe_db } = peak;
    let hz = |hz: Option<f64>| hz.map_or_else(|| "-".into(), grouped);
    let signed =
        |value: Option<f64>, digits: usize| value.map_or_else(|| "-".into(), |value| format!("{value:+.digits$}"));
    let shift = match pair.shift_percent {
        Some(_) => signed(pair.shift_percent, 2),
        None => "unpaired".into(),
    };
    let (height, mode) = (signed(pair.height_db, 1), printable(mode.as_deref().unwrap_or("")));
    let (fe, lumped) = (hz(pair.fe_hz), hz(pair.lumped_hz));
    let beside = if has_beside { format!("{:>9}", hz(*beside_hz)) } else { String::new() };
    let level = fe_db.map_or_else(|| "-".into(), |level| format!("{level:.1}"));
    let mark = if is_highest { "*" } else { " " };
    format!("{:>2}{fe:>7}{lumped:>8}{shift:>9}{level:>7}{mark}{height:>8}{beside}  {mode}", at + 1)
}
