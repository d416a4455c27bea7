//! All that a report says of one design.

use std::ops::ControlFlow;

use crate::agreement::{
    Causes, ModalComparison, ModalError, ModePair, band_level_db, difference_db, disagreement_bands, pair_modes,
    sixth_octave_bands,
};
use crate::comparison::{self, Comparison, SolveError};
use crate::design::Design;
use crate::model::Rotors;
use crate::response::{Modes, ResponseError, Solved, Spectrum, refined_lines};

/// A design solved for a report.
#[derive(Debug)]
pub struct Study {
    pub rotors: Rotors,
    pub comparison: Comparison,
    /// For drawing
    pub curves: Curves,
    pub levels: Vec<Levels>,
    /// Beyond which lines disagree, dB
    pub tolerance_db: f64,
    /// Bands in which the enhanced model disagrees, ascending, and why
    pub causes: Vec<Causes>,
    /// Finite elements and the enhanced model
    pub modes: ModalComparison,
    pub basic_modes: Modes,
    /// Of the basic model with the finite element modes compared
    pub basic_pairs: Vec<ModePair>,
}

/// Levels of the mesh force of the three models, dB re 1 N, on the lines of the analysis and on their resonances and antiresonances.
#[derive(Debug, Clone, PartialEq)]
pub struct Curves {
    /// Ascending
    pub frequency_hz: Vec<f64>,
    pub fe_db: Vec<f64>,
    pub enhanced_db: Vec<f64>,
    pub basic_db: Vec<f64>,
}

/// Levels of a sixth-octave band, dB re 1 N.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Levels {
    pub low_hz: f64,
    pub high_hz: f64,
    pub fe_db: f64,
    pub enhanced_db: f64,
    pub basic_db: f64,
}

impl Study {
    /// # Errors
    ///
    /// As [`comparison::compare`].
    pub fn new(design: &Design, tolerance_db: f64) -> Result<Self, SolveError> {
        Self::of_rotors(design, Rotors::new(design)?, tolerance_db)
    }

    /// As [`new`](Self::new), of a design whose rotors are there already.
    ///
    /// # Errors
    ///
    /// As [`comparison::compare_rotors`].
    pub fn of_rotors(design: &Design, rotors: Rotors, tolerance_db: f64) -> Result<Self, SolveError> {
        let go_on = || ControlFlow::Continue(());
        let (comparison, solved) = comparison::compare_solved(design, &rotors, None, &mut |_| go_on())?;
        let [fe, enhanced, basic] = &solved;
        let modes = ModalComparison::of(fe, enhanced, design, &rotors, &mut { go_on })?;
        let failed = |error: ResponseError| ModalError::Response { kind: basic.model.kind, error };
        let basic_modes = basic.modes_over(&mut |_| go_on()).map_err(failed)?;
        let compared = Modes(modes.fe.0.iter().take(crate::agreement::COMPARED_FE_MODES).cloned().collect());
        let basic_pairs = pair_modes((&basic.model, &basic_modes), (&fe.model, &compared), &enhanced.model);
        let models = [(fe, &modes.fe), (enhanced, &modes.lumped), (basic, &basic_modes)];
        let curves = Curves::new(&comparison, models)?;
        let Comparison { frequency_hz, fe, enhanced, .. } = &comparison;
        let bands = disagreement_bands(frequency_hz, &enhanced.mesh_force, &fe.mesh_force, tolerance_db);
        let causes = bands.into_iter().map(|band| Causes::new(&modes, &rotors, band)).collect();
        let levels = levels(&comparison);
        Ok(Self { rotors, comparison, curves, levels, tolerance_db, causes, modes, basic_modes, basic_pairs })
    }
}

impl Curves {
    fn new(comparison: &Comparison, models: [(&Solved, &Modes); 3]) -> Result<Self, SolveError> {
        let lines = &comparison.frequency_hz;
        let (Some(&low), Some(&high)) = (lines.first(), lines.last()) else {
            return Ok(Self {
                frequency_hz: Vec::new(),
                fe_db: Vec::new(),
                enhanced_db: Vec::new(),
                basic_db: Vec::new(),
            });
        };
        let mut added = Vec::new();
        let mut compliances = Vec::new();
        for (solved, modes) in models {
            let (hz, compliance) = (modes.0.iter().map(|mode| mode.frequency_hz), solved.compliance());
            added.extend(refined_lines(solved, &compliance, hz, [low, high]));
            compliances.push(compliance);
        }
        added.sort_by(f64::total_cmp);
        added.dedup();
        added.retain(|hz| lines.binary_search_by(|line| line.total_cmp(hz)).is_err());
        let mut frequency_hz: Vec<f64> = lines.iter().chain(&added).copied().collect();
        frequency_hz.sort_by(f64::total_cmp);
        let solved = [&comparison.fe, &comparison.enhanced, &comparison.basic];
        let mut levels = Vec::new();
        for (((Solved { model, .. }, _), compliance), on_lines) in models.into_iter().zip(&compliances).zip(solved) {
            let mut between = Spectrum::with_capacity(added.len(), model.coordinates());
            let failed = |error| SolveError::Response { kind: model.kind, error };
            between.extend(model, compliance, &added).map_err(failed)?;
            let both = lines.iter().zip(&on_lines.mesh_force).chain(added.iter().zip(&between.mesh_force));
            let mut both: Vec<(f64, f64)> = both.map(|(hz, force)| (*hz, 20.0 * force.norm().log10())).collect();
            both.sort_by(|a, b| a.0.total_cmp(&b.0));
            levels.push(both.into_iter().map(|(_, level)| level).collect::<Vec<f64>>());
        }
        let mut levels = levels.into_iter();
        let mut next = || levels.next().unwrap_or_default();
        Ok(Self { frequency_hz, fe_db: next(), enhanced_db: next(), basic_db: next() })
    }
}

fn levels(comparison: &Comparison) -> Vec<Levels> {
    let Comparison { frequency_hz, fe, enhanced, basic, .. } = comparison;
    let bands = sixth_octave_bands(frequency_hz).into_iter();
    let levels = bands.map(|band| {
        let level = |spectrum: &Spectrum| band_level_db(&spectrum.mesh_force[band.lines.clone()]);
        Levels {
            low_hz: band.low_hz,
            high_hz: band.high_hz,
            fe_db: level(fe),
            enhanced_db: level(enhanced),
            basic_db: level(basic),
        }
    });
    levels.collect()
}

/// Largest |difference| of the lumped models from finite elements on the lines of the analysis, dB.
pub fn widest_difference_db(comparison: &Comparison) -> f64 {
    let of = |lumped: &Spectrum| {
        let all = difference_db(&lumped.mesh_force, &comparison.fe.mesh_force);
        all.into_iter().map(f64::abs).fold(0.0, f64::max)
    };
    of(&comparison.enhanced).max(of(&comparison.basic))
}
