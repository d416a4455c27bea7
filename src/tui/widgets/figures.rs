//! The answer: up to where each lumped model can be trusted.
//!
//! ```text
//!  enhanced: trust up to 2,997 Hz,  3.72 dB RMS, FRAC 0.56, ! static inertia, at worst 12.7 dB at 3,412 Hz
//!     basic: trust up to   236 Hz, 10.13 dB RMS, FRAC 0.12, at worst 31.0 dB at 4,980 Hz
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::text::{Line, Span};

use crate::agreement::Agreement;
use crate::model::Caveat;
use crate::number::grouped;
use crate::tui::app::{App, Outcome};
use crate::tui::solving::Summary;
use crate::tui::theme::Theme;

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
    render_models(summary, None, &app.theme, area, buffer);
}

/// Draws the figures, beside those of the saved state where they differ.
pub fn render_models(summary: &Summary, was: Option<&Summary>, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let agreements = |summary: &Summary| [summary.enhanced.clone(), summary.basic.clone()];
    let now = agreements(summary);
    let was = was.map(agreements);
    let limits = now.each_ref().map(limit);
    let before: [String; 2] = std::array::from_fn(|at| match &was {
        Some(was) if limit(&was[at]) != limits[at] => format!(" (was {}),", short_limit(&was[at])),
        _ => ",".into(),
    });
    let mut wide: [usize; 2] =
        [limits.iter().map(String::len).max().unwrap_or(0), before.iter().map(String::len).max().unwrap_or(0)];
    let rms_before: [String; 2] = std::array::from_fn(|at| match &was {
        Some(was) if format!("{:.2}", was[at].rms_db) != format!("{:.2}", now[at].rms_db) => {
            format!(" (was {:.2})", was[at].rms_db)
        }
        _ => String::new(),
    });
    let widest_rms = rms_before.iter().map(String::len).max().unwrap_or(0);
    let models = [("enhanced", theme.enhanced), ("basic", theme.basic)];
    // both lines have the same columns, and where there is little room both are brief
    let all = 11 + wide[0] + wide[1] + " 10.13 dB RMS".len() + widest_rms + ", FRAC 0.56".len();
    let up_to = if all < usize::from(area.width) { "up to" } else { "to" };
    let limits = limits.map(|limit| limit.replace("up to", up_to));
    wide[0] = limits.iter().map(String::len).max().unwrap_or(0);
    for (row, (name, style)) in models.into_iter().enumerate().take(usize::from(area.height)) {
        let agreement = &now[row];
        let gap = widest_rms - rms_before[row].len();
        let parts = [
            Span::styled(format!(" {name:>8}: "), style),
            Span::styled(format!("{:>1$}", limits[row], wide[0]), theme.title),
            Span::raw(format!("{:<1$}", before[row], wide[1])),
            Span::raw(format!(" {:>5.2} dB RMS{}", agreement.rms_db, rms_before[row])),
            Span::raw(format!(",{:gap$} FRAC {:.2}", "", agreement.frac)),
        ];
        let worst = format!(", at worst {:.1} dB at {} Hz", agreement.max_db.abs(), grouped(agreement.max_at_hz));
        let mut line = Line::default();
        let caveat = (row == 0).then(|| caveats(&summary.caveats, usize::from(area.width))).flatten();
        let caveat = caveat.map(|text| Span::styled(format!(", ! {text}"), theme.warning));
        // the limit is by levels of bands, the rest line by line
        let by = [", limit by 1/6 octave", ", RMS over all lines"][row.min(1)];
        let after = [Span::styled(by, theme.faint), Span::styled(worst, theme.faint)];
        for part in parts.into_iter().chain(caveat).chain(after) {
            // what does not fit as a whole is left out
            if line.width() + part.width() < usize::from(area.width) {
                line.push_span(part);
            } else {
                break;
            }
        }
        buffer.set_line(area.x, area.y + row as u16, &line, area.width);
    }
}

/// Both agreements in a line, to be pasted somewhere.
pub fn sentence(summary: &Summary) -> String {
    let of = |name: &str, agreement: &Agreement| {
        let Agreement { rms_db, frac, max_db, max_at_hz, .. } = agreement;
        let worst = format!("at worst {:.1} dB at {} Hz", max_db.abs(), grouped(*max_at_hz));
        format!("{name}: {}, {rms_db:.2} dB RMS, FRAC {frac:.2}, {worst}", limit(agreement))
    };
    format!("{}; {}", of("enhanced", &summary.enhanced), of("basic", &summary.basic))
}

/// What the enhanced model rests on besides its modes, in as many words as there is room for.
fn caveats(caveats: &[Caveat], width: usize) -> Option<String> {
    let (first, others) = caveats.split_first()?;
    if width >= 120 {
        return Some(caveats.iter().map(Caveat::long).collect::<Vec<_>>().join(", "));
    }
    let more = if others.is_empty() { String::new() } else { format!(" +{}", others.len()) };
    Some(first.short() + &more)
}

fn short_limit(agreement: &Agreement) -> String {
    if agreement.agreement_limit_hz > 0.0 { grouped(agreement.agreement_limit_hz) } else { "nowhere".into() }
}

fn limit(agreement: &Agreement) -> String {
    if agreement.agreement_limit_hz > 0.0 {
        format!("trust up to {} Hz", grouped(agreement.agreement_limit_hz))
    } else {
        "trust nowhere".into()
    }
}
