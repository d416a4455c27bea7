//! The answer: up to where each lumped model can be trusted.
//!
//! ```text
//!  enhanced: trust up to 2,997 Hz,  3.72 dB RMS, FRAC 0.56, at worst 12.7 dB at 3,412 Hz
//!     basic: trust up to   236 Hz, 10.13 dB RMS, FRAC 0.12, at worst 31.0 dB at 4,980 Hz
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use crate::agreement::Agreement;
use crate::number::grouped;
use crate::tui::app::{App, Outcome};

/// Rows that the figures take.
pub const HEIGHT: u16 = 2;

/// Draws a line a model, the enhanced one first.
pub fn render(app: &App, area: Rect, buffer: &mut Buffer) {
    let Some(Outcome::Solved { summary, .. }) = &app.detail.outcome else {
        if app.library.selected().is_some() && area.height > 0 {
            let text = if app.has_text() { " agreement: none without a solution" } else { " agreement: not known yet" };
            buffer.set_stringn(area.x, area.y, text, usize::from(area.width), app.theme.faint);
        }
        return;
    };
    let models = [("enhanced", &summary.enhanced, app.theme.enhanced), ("basic", &summary.basic, app.theme.basic)];
    let limits = models.map(|(_, agreement, _)| limit(agreement));
    let wide = limits.iter().map(String::len).max().unwrap_or(0);
    for (row, ((name, agreement, style), limit)) in models.into_iter().zip(limits).enumerate() {
        if row as u16 >= area.height {
            break;
        }
        let mut spans = vec![
            Span::styled(format!(" {name:>8}: "), style),
            Span::styled(format!("{limit:>wide$}"), app.theme.title),
            Span::raw(format!(", {:>5.2} dB RMS, FRAC {:.2}", agreement.rms_db, agreement.frac)),
        ];
        let worst = format!(", at worst {:.1} dB at {} Hz", agreement.max_db.abs(), grouped(agreement.max_at_hz));
        let line = Line::from(spans.clone());
        if line.width() + worst.len() < usize::from(area.width) {
            spans.push(Span::styled(worst, app.theme.faint));
        }
        buffer.set_line(area.x, area.y + row as u16, &Line::from(spans), area.width);
    }
}

fn limit(agreement: &Agreement) -> String {
    if agreement.agreement_limit_hz > 0.0 {
        format!("trust up to {} Hz", grouped(agreement.agreement_limit_hz))
    } else {
        "trust nowhere".into()
    }
}
