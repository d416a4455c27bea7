//! Why a lumped model disagrees with finite elements over a band: figures first, then the sentences that they support.

use super::{DisagreementBand, ModalComparison, Parts, Responsible};
use crate::design::Side;
use crate::model::{LumpedMass, ModelKind, Rotors};
use crate::response::{Dominant, Mode};

/// A mode counts where its part in what is looked at is at least this, of the greatest of all modes: weaker ones hardly show in the spectrum.
pub const LEAST_PARTICIPATION: f64 = 0.05;
/// A rotor's plane counts where it has this share of the responsible mode's kinetic energy: a tenth shifts a frequency by a twentieth.
const LEAST_PLANE_SHARE: f64 = 0.1;
/// Energy that (56) may miss without being named: at 1 % the frequency of the mode is still right.
const LEAST_RESIDUAL: f64 = 0.01;
/// A mass or inertia is named where it is off the static one by this ratio: a tenth in frequency.
const LEAST_RATIO: f64 = 1.2;
/// A shift of a paired mode is named from here on, percent: less is within a half-power width at a loss factor of 1 %.
const LEAST_SHIFT_PERCENT: f64 = 0.5;

/// A plane of one rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RotorPlane {
    pub side: Side,
    /// "x-y" or "y-z"
    pub plane: &'static str,
}

/// Mass and inertia of a lumped rotor in one plane beside others that it could have had.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneFigures {
    pub rotor: RotorPlane,
    /// Share of the responsible mode's kinetic energy in this plane
    pub mode_share: f64,
    /// Share of the first bending mode's kinetic energy that effective mass and inertia miss (56)
    pub energy_residual: f64,
    pub mass_fallback: bool,
    pub inertia_fallback: bool,
    /// In the model, kg
    pub mass: f64,
    /// What the static shapes carry (Guyan 1965), kg
    pub static_mass: f64,
    /// Of the whole rotor, kg
    pub total_mass: f64,
    /// In the model, kg m^2; so the others
    pub inertia: f64,
    pub static_inertia: f64,
    pub total_inertia: f64,
}

/// A finite element mode without lumped partner.
#[derive(Debug, Clone, PartialEq)]
pub struct Unpaired {
    /// Index among the finite element modes
    pub fe: usize,
    pub frequency_hz: f64,
    pub name: String,
    pub dominant: Dominant,
    /// Its part in what is looked at over the largest of all modes: (phi . h)^2 of the mesh force
    pub participation: f64,
}

/// The lumped partner of a mode lies elsewhere.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Shift {
    pub fe: usize,
    pub fe_hz: f64,
    pub lumped_hz: f64,
    /// (lumped - FE) / FE
    pub percent: f64,
    pub mac: f64,
    /// (phi . h)^2 of the lumped mode over that of the finite element mode
    pub participation_ratio: f64,
}

/// All figures behind the disagreement over one band.
#[derive(Debug, Clone, PartialEq)]
pub struct Causes {
    pub model: ModelKind,
    pub band: DisagreementBand,
    pub responsible: Option<Responsible>,
    /// Name, frequency (Hz) and dominant motion of the responsible mode
    pub mode: Option<(String, f64, Dominant)>,
    /// Shift of the responsible mode's pair
    pub shift: Option<Shift>,
    /// Finite element modes in the band (and the responsible one) that no lumped mode pairs with
    pub unpaired: Vec<Unpaired>,
    /// Both planes of both rotors; empty for reduced models, whose masses are those of the shaft
    pub planes: Vec<PlaneFigures>,
}

impl Causes {
    /// Of a band of the mesh force, or of the transmission error.
    pub fn new(modes: &ModalComparison, rotors: &Rotors, band: DisagreementBand) -> Self {
        Self::in_parts(modes, &Parts::of_mesh(modes), rotors, band)
    }

    /// Of a band of what the modes have the given parts in.
    pub fn in_parts(modes: &ModalComparison, parts: &Parts, rotors: &Rotors, band: DisagreementBand) -> Self {
        let responsible = modes.responsible_in(parts, band.worst_at_hz);
        let mode = responsible.and_then(|responsible| modes.mode(&responsible));
        let fe = responsible.and_then(|responsible| responsible.fe);
        let pair = fe.and_then(|fe| modes.pairs.iter().find(|pair| pair.fe == fe));
        let shift = pair.map(|pair| {
            let (of_fe, lumped) = (&modes.fe.0[pair.fe], &modes.lumped.0[pair.lumped]);
            let (fe_hz, lumped_hz) = (of_fe.frequency_hz, lumped.frequency_hz);
            Shift {
                fe: pair.fe,
                fe_hz,
                lumped_hz,
                percent: 100.0 * (lumped_hz / fe_hz - 1.0),
                mac: pair.mac,
                participation_ratio: lumped.participation / of_fe.participation,
            }
        });
        let own: Vec<f64> = (0..modes.fe.0.len()).map(|i| modes.part_of_fe(parts, i)).collect();
        let largest = own.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
        let unpaired = modes.fe.0.iter().enumerate().filter(|(i, mode)| {
            let inside = (band.from_hz..=band.to_hz).contains(&mode.frequency_hz) || fe == Some(*i);
            inside && modes.partner(*i).is_none()
        });
        let unpaired = unpaired.map(|(i, mode)| Unpaired {
            fe: i,
            frequency_hz: mode.frequency_hz,
            name: mode.name(),
            dominant: mode.dominant(),
            participation: own[i] / largest,
        });
        Self {
            model: modes.lumped_model.kind,
            band,
            responsible,
            mode: mode.map(|mode| (mode.name(), mode.frequency_hz, mode.dominant())),
            shift,
            unpaired: unpaired.collect(),
            planes: planes(modes.lumped_model.kind, rotors, mode),
        }
    }

    /// One to five plain sentences; each only where its figure passes its threshold.
    pub fn sentences(&self) -> Vec<String> {
        const MOST: usize = 5;
        let model = self.model.name();
        let high = if self.band.worst_db > 0.0 { "above" } else { "below" };
        let mut out = vec![format!(
            "At {:.0} Hz the {model} model is {:.1} dB {high} finite elements.",
            self.band.worst_at_hz,
            self.band.worst_db.abs()
        )];
        if let (Some(responsible), Some((name, hz, dominant))) = (self.responsible, &self.mode) {
            let what = format!("mode at {hz:.0} Hz ({})", with_share(name, dominant));
            match (responsible.fe, self.shift) {
                (Some(_), Some(shift)) if shift.percent.abs() >= LEAST_SHIFT_PERCENT => out.push(format!(
                    "The {what} lies at {:.0} Hz in the {model} model, {:+.1} %.",
                    shift.lumped_hz, shift.percent
                )),
                (Some(_), Some(shift)) => out.push(format!(
                    "The {what} is there ({:+.2} %), with {:.2} times the participation in the mesh force.",
                    shift.percent, shift.participation_ratio
                )),
                (Some(_), None) => out.push(format!("The {what} is missing in the {model} model.")),
                (None, _) => out.push(format!("The {model} model has a {what} that finite elements do not have.")),
            }
        }
        let responsible = self.responsible.and_then(|responsible| responsible.fe);
        let others: Vec<String> = self
            .unpaired
            .iter()
            .filter(|mode| Some(mode.fe) != responsible && mode.participation >= LEAST_PARTICIPATION)
            .map(|mode| format!("{:.0} Hz ({})", mode.frequency_hz, mode.name))
            .collect();
        if !others.is_empty() {
            out.push(format!("Also missing in the {model} model, in this band: {}.", others.join(", ")));
        }
        for plane in self.planes.iter().filter(|plane| plane.mode_share >= LEAST_PLANE_SHARE) {
            out.extend(plane.sentence(self.model));
        }
        out.truncate(MOST);
        out
    }
}

/// A mode's name with the share of the motion that it has most of, which is said once: `gear lateral 71 %, x-y plane`.
fn with_share(name: &str, dominant: &Dominant) -> String {
    let motion = format!("{} {}", dominant.side.name(), dominant.group.name());
    match name.strip_prefix(&motion) {
        Some(rest) => format!("{dominant}{rest}"),
        None => format!("{name}; {dominant}"),
    }
}

impl PlaneFigures {
    fn sentence(&self, model: ModelKind) -> Option<String> {
        let RotorPlane { side, plane } = self.rotor;
        let place = format!("the {} in the {plane} plane", side.name());
        if model == ModelKind::Basic {
            let heavy = self.mass / self.static_mass;
            return (heavy >= LEAST_RATIO || heavy <= 1.0 / LEAST_RATIO).then(|| {
                format!(
                    "At the mesh it moves the whole mass of {place}, {:.2} kg, where static shapes carry {:.2} kg.",
                    self.mass, self.static_mass
                )
            });
        }
        match (self.mass_fallback, self.inertia_fallback) {
            (true, true) => {
                return Some(format!(
                    "Mass and inertia of {place} are static ones: its first bending mode gives neither."
                ));
            }
            (true, false) => {
                return Some(format!(
                    "The mass of {place} is the static one: its first bending mode does not give it."
                ));
            }
            (false, true) => {
                return Some(format!(
                    "The inertia of {place} is the static one: its first bending mode does not give it."
                ));
            }
            (false, false) => {}
        }
        if self.energy_residual >= LEAST_RESIDUAL {
            return Some(format!(
                "Mass and inertia of {place} miss {:.1} % of the kinetic energy of its first bending mode.",
                100.0 * self.energy_residual
            ));
        }
        let ratio = self.inertia / self.static_inertia;
        (ratio >= LEAST_RATIO || ratio <= 1.0 / LEAST_RATIO).then(|| {
            format!(
                "The effective inertia of {place} is {ratio:.2} times what static shapes carry: right for its first bending mode \
                 only."
            )
        })
    }
}

fn planes(kind: ModelKind, rotors: &Rotors, mode: Option<&Mode>) -> Vec<PlaneFigures> {
    let masses = match kind {
        ModelKind::Enhanced => LumpedMass::Enhanced,
        ModelKind::Basic => LumpedMass::Basic,
        ModelKind::Fe | ModelKind::Reduced(_) => return Vec::new(),
    };
    let mut out = Vec::new();
    for side in Side::BOTH {
        let rotor = rotors.get(side);
        let own = masses.diagonal(rotor);
        let shares = mode.map_or([0.0; 2], |mode| mode.plane_shares(side));
        let in_plane = [("x-y", &rotor.bending_x, [0, 5]), ("y-z", &rotor.bending_z, [2, 3])];
        for ((plane, bending, [deflection, rotation]), mode_share) in in_plane.into_iter().zip(shares) {
            let enhanced = kind == ModelKind::Enhanced;
            out.push(PlaneFigures {
                rotor: RotorPlane { side, plane },
                mode_share,
                energy_residual: bending.energy_residual,
                mass_fallback: enhanced && bending.mass_fallback,
                inertia_fallback: enhanced && bending.inertia_fallback,
                mass: own[deflection],
                static_mass: rotor.statics.static_mass[deflection],
                total_mass: rotor.totals.mass,
                inertia: own[rotation],
                static_inertia: rotor.statics.static_mass[rotation],
                total_inertia: rotor.totals.diametral_inertia,
            });
        }
    }
    out
}
