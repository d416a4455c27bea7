//! The modes of finite elements beside their partners.
//!
//! ```text
//!     #    FE Hz  name                    enh. Hz shift %  MAC basic Hz shift %  MAC
//! ▌   3    236.4  gear tilt, x-y plane        236.1    -0.1 1.00    228.9    -3.2 0.97
//!     -        -  pinion axial                412.3       -    -        -       -    -
//! ```
//!
//! Where there is room the reduced model stands beside the others, else in place of the basic one while it is drawn.

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;
use unicode_width::UnicodeWidthStr;

use crate::text::cut;
use crate::tui::modes::{MODELS, ModeRow, ModesView, Partner, Study};
use crate::tui::theme::Theme;

/// Columns of number and frequency, and of a model beside them.
const FE: usize = 13;
const MODEL: usize = 22;

/// Columns of a name that is not worth cutting further.
const NAME: usize = 30;

/// Draws heading and rows; the view's scroll follows the cursor.
pub fn render(view: &mut ModesView, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.height == 0 {
        return;
    }
    view.scroll.fit(view.rows.len(), usize::from(area.height).saturating_sub(1));
    view.scroll.show(view.cursor);
    let width = usize::from(area.width);
    let Some(study) = view.study().cloned() else { return };
    let shown: &[usize] = match view.model {
        _ if width >= FE + 2 + NAME + MODELS * MODEL && study.reduced().is_some() => &[0, 1, 2],
        2 => &[0, 2],
        _ => &[0, 1],
    };
    let room = width.saturating_sub(FE + shown.len() * MODEL + 2);
    // a name of a few letters says less than none
    let room = if room >= 14 { room } else { 0 };
    let name = |text: &str| {
        let text = cut(text, room, theme.glyphs.ellipsis);
        let gap = " ".repeat(room.saturating_sub(text.width()));
        if room == 0 { String::new() } else { format!("  {text}{gap}") }
    };
    let heads = ["enh. Hz", "basic Hz", "red. Hz"];
    let models: Vec<String> = shown.iter().map(|at| format!("{:>9}{:>8}{:>5}", heads[*at], "shift %", "MAC")).collect();
    let models = models.concat();
    buffer.set_stringn(
        area.x,
        area.y,
        format!(" {:>3}{:>9}{}{models}", "#", "FE Hz", name("name")),
        width,
        theme.faint,
    );
    for ((at, row), y) in view.rows.iter().enumerate().skip(view.scroll.top).zip(area.y + 1..area.bottom()) {
        let is_selected = at == view.cursor;
        let style = match (is_selected, row.fe) {
            (true, _) => theme.selected,
            (false, None) => theme.faint,
            _ => Style::new(),
        };
        let marker = if is_selected { theme.glyphs.selected } else { " " };
        buffer.set_style(Rect::new(area.x, y, area.width, 1), style);
        buffer.set_stringn(area.x, y, format!("{marker}{}", line(row, &study, shown, &name)), width, style);
    }
}

fn line(row: &ModeRow, study: &Study, shown: &[usize], name: &dyn Fn(&str) -> String) -> String {
    let mode = row.mode(study);
    let dash = || "-".to_owned();
    let number = row.fe.map_or_else(dash, |fe| (fe + 1).to_string());
    let hz = row.fe.and(mode).map_or_else(dash, |mode| hertz(mode.frequency_hz));
    let named = name(&mode.map_or(String::new(), crate::response::Mode::name));
    let partner = |one: &Option<Partner>| {
        let hz = one.map_or_else(dash, |one| hertz(one.hz));
        let shift = one.and_then(|one| one.shift_percent).map_or_else(dash, percent);
        let mac = one.and_then(|one| one.mac).map_or_else(dash, |mac| format!("{mac:.2}"));
        format!("{hz:>9}{shift:>8}{mac:>5}")
    };
    let partners: Vec<String> = shown.iter().map(|at| partner(&row.partners[*at])).collect();
    format!("{number:>3}{hz:>9}{named}{}", partners.concat())
}

/// What rounds to nothing has no sign.
fn percent(shift: f64) -> String {
    if shift.abs() < 0.05 { "0.0".into() } else { format!("{shift:+.1}") }
}

/// A frequency in eight letters at most.
pub fn hertz(hz: f64) -> String {
    match hz {
        ..0.01 => "0".into(),
        ..99_999.95 => format!("{hz:.1}"),
        ..99_999_999.5 => format!("{hz:.0}"),
        _ => format!("{hz:.1e}"),
    }
}
