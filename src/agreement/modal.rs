//! The modes of a lumped model beside those of finite elements, and which of them makes the two differ at a frequency.

use std::f64::consts::TAU;
use std::ops::ControlFlow;
use std::sync::Arc;

use num_complex::Complex64;

use super::parts::{Part, Parts};
use super::{ModePair, pair_modes};
use crate::design::Design;
use crate::model::{Model, ModelError, ModelKind, Rotors};
use crate::response::{Mode, Modes, ResponseError, Solved};

/// Finite element modes that lumped ones are paired with: the lowest, since the shape of a high one at the mesh alone says little.
pub const COMPARED_FE_MODES: usize = 40;

/// Modes of two models with their partners.
#[derive(Debug, Clone)]
pub struct ModalComparison {
    pub fe_model: Arc<Model>,
    /// All of them
    pub fe: Modes,
    pub lumped_model: Arc<Model>,
    pub lumped: Modes,
    /// By [`pair_modes`], among the lowest [`COMPARED_FE_MODES`], or twice as many as the model has where that is more
    pub pairs: Vec<ModePair>,
}

/// Why modes cannot be compared.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ModalError {
    #[error(transparent)]
    Model(#[from] ModelError),
    #[error("{} model: {error}", kind.name())]
    Response { kind: ModelKind, error: ResponseError },
    #[error("cancelled")]
    Cancelled,
}

/// The mode that makes most of the difference at a frequency: one of finite elements, or a lumped one that these do not have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Responsible {
    /// Index among the finite element modes
    pub fe: Option<usize>,
    /// Index among the lumped ones; both where the two are paired
    pub lumped: Option<usize>,
    /// Size of its contribution to the difference over the sum of all sizes, 0 to 1
    pub share: f64,
}

impl ModalComparison {
    /// # Errors
    ///
    /// A model that cannot be built, or whose modes cannot be computed.
    pub fn new(kind: ModelKind, design: &Design, rotors: &Rotors) -> Result<Self, ModalError> {
        let solved = |kind| -> Result<Solved, ModalError> {
            let model = Model::new(kind, design, rotors)?;
            Solved::new(model).map_err(|error| ModalError::Response { kind, error })
        };
        Self::of(&solved(ModelKind::Fe)?, &solved(kind)?, design, rotors, &mut || ControlFlow::Continue(()))
    }

    /// As [`Self::new`], of two models of the design that are solved; `done` is asked often whether to go on.
    ///
    /// # Errors
    ///
    /// As [`Self::new`]; [`ModalError::Cancelled`] where `done` breaks.
    pub fn of(
        fe: &Solved,
        lumped: &Solved,
        design: &Design,
        rotors: &Rotors,
        done: &mut dyn FnMut() -> ControlFlow<()>,
    ) -> Result<Self, ModalError> {
        let mut modes = |solved: &Solved| {
            solved.modes_over(&mut |_| done()).map_err(|error| match error {
                ResponseError::Cancelled => ModalError::Cancelled,
                error => ModalError::Response { kind: solved.model.kind, error },
            })
        };
        let (fe_model, lumped_model) = (Arc::clone(&fe.model), Arc::clone(&lumped.model));
        let (fe, lumped) = (modes(fe)?, modes(lumped)?);
        let enhanced = Model::new(ModelKind::Enhanced, design, rotors)?;
        let compared = Modes(fe.0.iter().take(COMPARED_FE_MODES.max(2 * lumped.0.len())).cloned().collect());
        let pairs = pair_modes((&lumped_model, &lumped), (&fe_model, &compared), &enhanced);
        Ok(Self { fe_model, fe, lumped_model, lumped, pairs })
    }

    /// The lumped partner of a finite element mode.
    pub fn partner(&self, fe: usize) -> Option<usize> {
        self.pairs.iter().find(|pair| pair.fe == fe).map(|pair| pair.lumped)
    }

    /// The mode with the greatest contribution to the difference of the two mesh forces at a frequency (Hz), of those within an octave.
    ///
    /// F_m + k_m* e = k_m*^2 e h^T H^-1 h is a sum over the modes with the mesh, (phi . h)^2 / (lambda_r (1 + j eta_r) - w^2), so the difference of two models
    /// is the sum of the differences of paired modes and of what the modes without partner give. A pair that agrees cancels, and an unpaired mode
    /// counts whole. All models have the same static compliance at the mesh, so of every mode only what exceeds its static part is looked at:
    /// without that the high modes, which share the static part out differently, would be named at any frequency. eta_r is the loss factor by modal strain energy (Johnson and Kienholz 1982): the sum explains, the spectra are exact.
    pub fn responsible(&self, at_hz: f64) -> Option<Responsible> {
        self.responsible_in(&Parts::of_mesh(self), at_hz)
    }

    /// The same of what the modes have the given parts in.
    pub fn responsible_in(&self, parts: &Parts, at_hz: f64) -> Option<Responsible> {
        let of_fe = |i: usize| moving(&self.fe_model, &self.fe.0[i], parts.fe.get(i), at_hz);
        let of_lumped = |i: usize| moving(&self.lumped_model, &self.lumped.0[i], parts.lumped.get(i), at_hz);
        let pairs = (0..self.fe.0.len()).map(|i| {
            let lumped = self.partner(i);
            let (own, other) = (of_fe(i), lumped.map(of_lumped).unwrap_or_default());
            let difference: Vec<Complex64> =
                own.iter().enumerate().map(|(i, own)| other.get(i).copied().unwrap_or_default() - own).collect();
            (Some(i), lumped, size(&difference))
        });
        let alone = (0..self.lumped.0.len()).filter(|i| !self.pairs.iter().any(|pair| pair.lumped == *i));
        let all: Vec<_> = pairs.chain(alone.map(|i| (None, Some(i), size(&of_lumped(i))))).collect();
        let sum: f64 = all.iter().map(|(.., size)| size).sum();
        // modes farther off than an octave give a smooth part only; where there are none nearer they are all there is
        let hz = |&(fe, lumped, _): &(Option<usize>, Option<usize>, f64)| {
            let of = |modes: &Modes, i: Option<usize>| i.map(|i| modes.0[i].frequency_hz);
            [of(&self.fe, fe), of(&self.lumped, lumped)]
        };
        let near = |hz: f64| (0.5 * at_hz..=2.0 * at_hz).contains(&hz);
        let some_near = all.iter().any(|mode| mode.2 > 0.0 && hz(mode).into_iter().flatten().any(near));
        let candidates = all.into_iter().filter(|mode| !some_near || hz(mode).into_iter().flatten().any(near));
        let (fe, lumped, size) = candidates.max_by(|a, b| a.2.total_cmp(&b.2))?;
        (size > 0.0 && sum.is_finite()).then(|| Responsible { fe, lumped, share: size / sum })
    }

    /// The mode that makes a peak of finite elements, or of the lumped model, in what the modes have the given parts in: of those within 3 %, or on
    /// this side of the next of the lines (Hz, ascending), the one that gives most there. It need not be one that the mesh drives much: a small
    /// peak has a weak mode.
    pub fn behind_peak(&self, parts: &Parts, of_lumped: bool, at_hz: f64, lines: &[f64]) -> Option<&Mode> {
        /// A loss factor of 6 % moves a peak by less.
        const NEAR: f64 = 0.03;
        let (model, modes, parts) = if of_lumped {
            (&self.lumped_model, &self.lumped, &parts.lumped)
        } else {
            (&self.fe_model, &self.fe, &parts.fe)
        };
        let after = lines.partition_point(|line| *line <= at_hz);
        let before = lines.partition_point(|line| *line < at_hz).checked_sub(1);
        let line = |at: Option<usize>| at.and_then(|at| lines.get(at)).map_or(at_hz, |line| *line);
        let range = line(before).min(at_hz * (1.0 - NEAR))..=line(Some(after)).max(at_hz * (1.0 + NEAR));
        let near = modes.0.iter().enumerate().filter(|(_, mode)| range.contains(&mode.frequency_hz));
        let sizes = near.map(|(i, mode)| (mode, size(&moving(model, mode, parts.get(i), at_hz))));
        sizes.filter(|(_, size)| *size > 0.0).max_by(|a, b| a.1.total_cmp(&b.1)).map(|(mode, _)| mode)
    }

    /// The size of a finite element mode's part in what is looked at, at its own frequency.
    pub(super) fn part_of_fe(&self, parts: &Parts, mode: usize) -> f64 {
        let omega = TAU * self.fe.0[mode].frequency_hz;
        let factor = self.fe_model.structural_factor(omega);
        let sizes = parts.fe.get(mode).into_iter().flatten().map(|part| part.at(omega, factor).norm());
        sizes.fold(0.0, f64::hypot)
    }

    /// The finite element mode of a responsible one, or the lumped one where there is none.
    pub fn mode(&self, responsible: &Responsible) -> Option<&Mode> {
        match (responsible.fe, responsible.lumped) {
            (Some(i), _) => self.fe.0.get(i),
            (None, Some(i)) => self.lumped.0.get(i),
            (None, None) => None,
        }
    }
}

/// What a mode gives at a frequency (Hz) beyond its static part, over k_m* e; nothing where it is at rest, since the rigid rotation strains nothing,
/// the mesh included.
fn moving(model: &Model, mode: &Mode, parts: Option<&Vec<Part>>, at_hz: f64) -> Vec<Complex64> {
    let omega = TAU * at_hz;
    let lambda = (TAU * mode.frequency_hz).powi(2);
    let factor = model.structural_factor(omega);
    let mesh = model.complex_mesh_stiffness(omega).im / model.mesh_stiffness;
    let loss = factor.im + (mesh - factor.im) * mode.mesh_strain_share;
    let stiffness = Complex64::new(lambda, lambda * loss);
    let of = |part: &Part| {
        let moving = part.at(omega, factor) / (stiffness - omega * omega) - part.at(0.0, factor) / stiffness;
        if mode.mesh_strain_share > 0.0 && moving.is_finite() { moving } else { Complex64::ZERO }
    };
    parts.into_iter().flatten().map(of).collect()
}

/// sqrt(sum |x|^2)
fn size(values: &[Complex64]) -> f64 {
    values.iter().fold(0.0, |size: f64, value| size.hypot(value.norm()))
}
