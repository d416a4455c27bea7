//! What the cursor is on, in figures of the analysis lines.

use num_complex::Complex64;

use super::{Quantity, SpectraView};
use crate::agreement::Tolerance;
use crate::model::{ModelKind, pinion_speed_rpm};
use crate::number::{grouped, significant};

/// One figure, and the model whose it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    pub kind: Option<ModelKind>,
    pub text: String,
}

/// A level, dB; nothing to speak of where there is no number.
pub fn level_text(db: f64) -> String {
    if db.is_finite() { format!("{db:.2}") } else { "-".into() }
}

/// A value as it is drawn, with its unit.
pub fn value(of: Complex64, quantity: Quantity, linear: bool, ascii: bool) -> String {
    if linear {
        format!("{} {}", significant(of.norm(), 4), quantity.unit(ascii))
    } else {
        format!("{} dB", level_text(20.0 * of.norm().log10()))
    }
}

impl SpectraView {
    /// Frequency and speed, then each curve with its difference from finite elements.
    pub fn readout(&self, ascii: bool) -> Vec<Item> {
        let (Some(hz), Some(subject)) = (self.at_hz(), &self.known.subject) else { return Vec::new() };
        let plain = |text: String| Item { kind: None, text };
        let mut items = vec![plain(format!("{} Hz", frequency(hz)))];
        let fe = self.curve(ModelKind::Fe, self.quantity).map(|curve| curve.lines[self.cursor]);
        for kind in self.shown_kinds() {
            let Some(curve) = self.curve(kind, self.quantity) else { continue };
            let here = curve.lines[self.cursor];
            let mut text = format!("{} {}", legend_name(kind), value(here, self.quantity, self.linear_level, ascii));
            if let Some(fe) = fe.filter(|_| kind != ModelKind::Fe) {
                let difference = 20.0 * (here.norm() / fe.norm()).log10();
                text = format!("{text} ({} dB)", signed(difference));
            }
            items.push(Item { kind: Some(kind), text });
        }
        items.extend(pinion_speed_rpm(&subject.design, hz).map(|rpm| plain(format!("pinion {} rpm", grouped(rpm)))));
        items
    }

    /// The same as one line of text.
    pub fn readout_text(&self) -> Option<String> {
        let subject = self.known.subject.as_ref()?;
        let items: Vec<String> = self.readout(false).into_iter().map(|item| item.text).collect();
        (!items.is_empty()).then(|| format!("{}: {}", self.quantity.title(&subject.design), items.join(", ")))
    }
}

/// How the curves are called in legends.
pub fn legend_name(kind: ModelKind) -> String {
    match kind {
        ModelKind::Fe => "FE".into(),
        ModelKind::Reduced(modes) => format!("reduced:{modes}"),
        other => other.name().into_owned(),
    }
}

/// With its sign; none on what is rounded away.
fn signed(db: f64) -> String {
    if db.abs() < 0.005 { "0.00".into() } else { format!("{db:+.2}") }
}

fn frequency(hz: f64) -> String {
    let whole = grouped(hz.trunc());
    let rest = format!("{:.2}", hz.fract());
    rest.strip_prefix("0").map_or_else(|| grouped(hz), |rest| whole + rest)
}

impl SpectraView {
    /// What is said of the band at the cursor.
    pub fn why(&self) -> Vec<String> {
        let Some((at, findings)) = self.band_under().zip(self.findings()) else { return Vec::new() };
        let band = &findings.bands[at];
        let against = legend_name(findings.against);
        let place = format!(
            "Band {} of {}: {} to {} Hz, {against} at worst {:+.1} dB at {} Hz (tolerance {} dB).",
            at + 1,
            findings.bands.len(),
            frequency(band.band.from_hz),
            frequency(band.band.to_hz),
            band.band.worst_db,
            frequency(band.band.worst_at_hz),
            findings.tolerance
        );
        let mut lines = vec![place];
        if !band.sentences.is_empty() {
            lines.extend(band.sentences.iter().cloned());
        } else if findings.is_complete {
            lines.push("No mode can be told apart from the others in this force.".into());
        } else {
            lines.push("The modes are still being computed.".into());
        }
        lines
    }
}

impl SpectraView {
    /// What sets the trust limit: the first sixth-octave band that is off, such as `1,682 Hz: the band 1,682 to 1,888 Hz is 3.3 dB low`, and
    /// the same in brief; nothing for other quantities than the mesh force, whose limit is shown everywhere.
    pub fn limit(&self) -> Option<[String; 2]> {
        let bands = |kind| self.curve(kind, Quantity::MeshForce).map(|curve| &curve.bands);
        if self.quantity != Quantity::MeshForce {
            return None;
        }
        let (fe, lumped) = (bands(ModelKind::Fe)?, bands(self.against())?);
        let tolerance = Tolerance::default().band_level_db;
        let off = |((low, high, lumped), (.., fe)): (&(f64, f64, f64), &(f64, f64, f64))| (*low, *high, lumped - fe);
        let is_off = |difference: f64| difference.is_nan() || difference.abs() > tolerance;
        let mut bands = lumped.iter().zip(fe).map(off).enumerate();
        let (at, (low, high, difference)) = bands.find(|(_, (.., difference))| is_off(*difference))?;
        let how = if difference > 0.0 { "high" } else { "low" };
        let off = format!("{:.1} dB {how}", difference.abs());
        let (low, high) = (grouped(low), grouped(high));
        let limit = if at == 0 { "trusted nowhere".into() } else { format!("limit {low} Hz") };
        Some([format!("{limit}: the band {low} to {high} Hz is {off}"), format!("{limit}: next band {off}")])
    }
}

#[cfg(test)]
mod tests {
    use super::signed;

    #[test]
    fn what_is_rounded_away_has_no_sign() {
        for (db, text) in [(-0.004, "0.00"), (0.0, "0.00"), (0.004, "0.00"), (-0.006, "-0.01"), (1.0, "+1.00")] {
            assert_eq!(signed(db), text);
        }
    }
}
