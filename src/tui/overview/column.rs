//! The columns that designs are ordered by.

use crate::number::{grouped, significant};
use crate::tui::library::{Row, RowState};

/// A column.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Column {
    #[default]
    Design,
    EnhancedLimit,
    EnhancedRms,
    BasicLimit,
    BasicRms,
    PeakFrequency,
    PeakForce,
}

impl Column {
    pub const ALL: [Self; 7] = [
        Self::Design,
        Self::EnhancedLimit,
        Self::EnhancedRms,
        Self::BasicLimit,
        Self::BasicRms,
        Self::PeakFrequency,
        Self::PeakForce,
    ];

    /// With its unit.
    pub fn name(self) -> &'static str {
        match self {
            Self::Design => "design",
            Self::EnhancedLimit => "enhanced limit Hz",
            Self::EnhancedRms => "enhanced RMS dB",
            Self::BasicLimit => "basic limit Hz",
            Self::BasicRms => "basic RMS dB",
            Self::PeakFrequency => "FE peak Hz",
            Self::PeakForce => "FE peak N",
        }
    }

    /// In files, with its unit.
    pub fn key(self) -> &'static str {
        match self {
            Self::Design => "design",
            Self::EnhancedLimit => "enhanced_limit_hz",
            Self::EnhancedRms => "enhanced_rms_db",
            Self::BasicLimit => "basic_limit_hz",
            Self::BasicRms => "basic_rms_db",
            Self::PeakFrequency => "fe_peak_hz",
            Self::PeakForce => "fe_peak_n",
        }
    }

    /// Both lines of its heading.
    pub fn heads(self) -> [&'static str; 2] {
        match self {
            Self::Design => ["", "design"],
            Self::EnhancedLimit => ["enh.", "limit Hz"],
            Self::EnhancedRms => ["enh.", "RMS dB"],
            Self::BasicLimit => ["basic", "limit Hz"],
            Self::BasicRms => ["basic", "RMS dB"],
            Self::PeakFrequency => ["FE peak", "Hz"],
            Self::PeakForce => ["FE peak", "N"],
        }
    }

    /// In characters, with a gap before it; the design has what is left.
    pub fn width(self) -> usize {
        match self {
            Self::Design => 0,
            Self::EnhancedLimit | Self::BasicLimit => 10,
            _ => 8,
        }
    }

    /// After the last the first.
    #[must_use]
    pub fn next(self) -> Self {
        let after = Self::ALL.into_iter().skip_while(|column| *column != self).nth(1);
        after.unwrap_or_default()
    }

    /// Before the first the last.
    #[must_use]
    pub fn previous(self) -> Self {
        let before = Self::ALL.into_iter().take_while(|column| *column != self).last();
        before.unwrap_or(Self::PeakForce)
    }

    /// The number in it; none for names, and where there is none.
    pub fn figure(self, row: &Row) -> Option<f64> {
        let RowState::Solved(summary) = &row.state else { return None };
        let figure = match self {
            Self::Design => None,
            Self::EnhancedLimit => Some(summary.enhanced.agreement_limit_hz),
            Self::EnhancedRms => Some(summary.enhanced.rms_db),
            Self::BasicLimit => Some(summary.basic.agreement_limit_hz),
            Self::BasicRms => Some(summary.basic.rms_db),
            Self::PeakFrequency => summary.fe_peak.map(|peak| peak.frequency_hz),
            Self::PeakForce => summary.fe_peak.map(|peak| peak.force()),
        };
        figure.filter(|figure| !figure.is_nan())
    }

    /// What stands in it.
    pub fn shown(self, row: &Row) -> String {
        let Some(figure) = self.figure(row) else {
            return if self == Self::Design { row.stem.clone() } else { "-".into() };
        };
        match self {
            Self::EnhancedRms | Self::BasicRms => format!("{figure:.2}"),
            Self::PeakForce if figure < 1000.0 => significant(figure, 4),
            Self::EnhancedLimit | Self::BasicLimit if figure <= 0.0 => "nowhere".into(),
            _ => grouped(figure),
        }
    }
}
