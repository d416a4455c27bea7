//! What holds a shaft: bearings to ground, with the series springs of the paper's Fig. 5.

use nalgebra::{DMatrix, DVector, Matrix6, Vector6};

use super::{MeanStates, Rolling, RotorError};
use crate::bearing::{Matrix, frames};
use crate::design::{Bearing, BearingModel, RotorDesign};

/// Index of the axial direction y in the six coordinates of a station.
const AXIAL: usize = 1;

/// One bearing as it acts on its station.
#[derive(Debug, Clone, PartialEq)]
pub struct Support {
    pub name: String,
    /// Stiffness to ground after Kc and before Khb, order x, y, z, thx, thy, thz; zero where the bearing is rigid.
    pub stiffness: Matrix6<f64>,
    /// Translations x, y, z that are held
    pub held: [bool; 3],
}

/// All bearings of a rotor, and the housing bolt behind them.
#[derive(Debug, Clone, PartialEq)]
pub struct Supports {
    pub bearings: Vec<Support>,
    housing: Housing,
}

/// How the housing bolt Khb acts.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Housing {
    /// No bolt, or none of the bearings carries thrust.
    Stiff,
    /// All axial reactions pass through the bolt: K - u u^T / (sum K_yy + Khb); holds sum K_yy + Khb.
    InSeries(f64),
    /// The one rigid axial support rests on the bolt alone: index of the bearing and Khb.
    Instead(usize, f64),
}

impl Supports {
    /// Applies Kc to each bearing and decides how Khb acts.
    ///
    /// # Errors
    ///
    /// Kc on a bearing that holds y, or Khb with rigid and elastic axial supports mixed or with two rigid ones.
    pub fn new(rotor: &RotorDesign, mean_states: &MeanStates) -> Result<Self, RotorError> {
        let stiffness = |(bearing, state): (&Bearing, &Option<Rolling>)| {
            in_series(bearing, own_stiffness(bearing, state.as_ref().map(|state| &state.state.stiffness)))
        };
        let bearings =
            rotor.bearings.iter().zip(mean_states.bearings.iter()).map(stiffness).collect::<Result<Vec<_>, _>>()?;
        let housing = match rotor.housing_axial_stiffness {
            None => Housing::Stiff,
            Some(bolt) => housing(&bearings, bolt)?,
        };
        Ok(Self { bearings, housing })
    }

    /// The bearings alone, without Kc and Khb, as the mean state knows them; ball and roller bearings with the stiffness that
    /// `rolling` gives for their place.
    pub fn of_mean_state(rotor: &RotorDesign, rolling: impl Fn(usize) -> Option<Matrix>) -> Self {
        let support = |(place, bearing): (usize, &Bearing)| own_stiffness(bearing, rolling(place).as_ref());
        Self { bearings: rotor.bearings.iter().enumerate().map(support).collect(), housing: Housing::Stiff }
    }

    /// Whether a bearing holds the translation (0, 1, 2 for x, y, z) of its station.
    pub fn holds(&self, bearing: usize, translation: usize) -> bool {
        let released = translation == AXIAL && matches!(self.housing, Housing::Instead(i, _) if i == bearing);
        self.bearings[bearing].held[translation] && !released
    }

    /// Rows of one bearing's own share of the elastic supports, over six coordinates a station: its force on the shaft is minus these
    /// times the displacements. Behind a housing bolt a bearing's other side moves with the bolt, so all bearings have a part in it;
    /// the shares of all bearings make up what [`Supports::add_to`] adds.
    pub fn share(&self, bearing: usize, at: &[usize], coordinates: usize) -> DMatrix<f64> {
        let stiffness = self.bearings[bearing].stiffness;
        let mut rows = DMatrix::zeros(6, coordinates);
        rows.fixed_view_mut::<6, 6>(0, 6 * at[bearing]).copy_from(&stiffness);
        match self.housing {
            Housing::Instead(only, bolt) if only == bearing => rows[(AXIAL, 6 * at[bearing] + AXIAL)] += bolt,
            Housing::InSeries(total) => {
                for (support, &station) in self.bearings.iter().zip(at) {
                    let mut block = rows.fixed_view_mut::<6, 6>(0, 6 * station);
                    block -= stiffness.column(AXIAL) * support.stiffness.column(AXIAL).transpose() / total;
                }
            }
            Housing::Stiff | Housing::Instead(..) => {}
        }
        rows
    }

    /// Adds the stiffness of all supports to `target`, six coordinates a station; `at` gives each bearing's station.
    pub fn add_to(&self, target: &mut DMatrix<f64>, at: &[usize]) {
        for (support, &station) in self.bearings.iter().zip(at) {
            let mut block = target.fixed_view_mut::<6, 6>(6 * station, 6 * station);
            block += support.stiffness;
        }
        match self.housing {
            Housing::Stiff => {}
            Housing::Instead(bearing, bolt) => {
                let i = 6 * at[bearing] + AXIAL;
                target[(i, i)] += bolt;
            }
            Housing::InSeries(total) => {
                let mut u = DVector::zeros(target.nrows());
                for (support, &station) in self.bearings.iter().zip(at) {
                    let mut rows = u.fixed_rows_mut::<6>(6 * station);
                    rows += support.stiffness.column(AXIAL);
                }
                target.ger(-1.0 / total, &u, &u, 1.0);
            }
        }
    }
}

/// The bearing before Kc.
fn own_stiffness(bearing: &Bearing, rolling: Option<&Matrix>) -> Support {
    let mut held = [false; 3];
    let mut stiffness = Matrix6::zeros();
    match &bearing.model {
        BearingModel::Diagonal(k) => {
            stiffness.set_diagonal(&Vector6::new(k.kx, k.ky, k.kz, k.krx, 0.0, k.krz));
        }
        BearingModel::Matrix(rows) => stiffness = Matrix6::from_fn(|i, j| rows[i][j]),
        BearingModel::Rigid(hold) => held = [hold.x, hold.y, hold.z],
        BearingModel::Ball(_) | BearingModel::Roller(_) => {
            stiffness = rolling.map_or_else(Matrix6::zeros, frames::stiffness_to_station);
        }
    }
    Support { name: bearing.name.clone(), stiffness, held }
}

fn in_series(bearing: &Bearing, mut support: Support) -> Result<Support, RotorError> {
    let Support { stiffness, held, .. } = &mut support;
    if let Some(series) = bearing.axial_series_stiffness {
        if held[AXIAL] {
            return Err(RotorError::SeriesOnRigid(bearing.name.clone()));
        }
        let column: Vector6<f64> = stiffness.column(AXIAL).into();
        *stiffness -= column * column.transpose() / (stiffness[(AXIAL, AXIAL)] + series);
    }
    Ok(support)
}

fn housing(bearings: &[Support], bolt: f64) -> Result<Housing, RotorError> {
    let rigid: Vec<usize> = (0..bearings.len()).filter(|&i| bearings[i].held[AXIAL]).collect();
    let elastic: f64 = bearings.iter().map(|support| support.stiffness[(AXIAL, AXIAL)]).sum();
    match (rigid.as_slice(), elastic > 0.0) {
        ([], false) => Ok(Housing::Stiff),
        ([], true) => Ok(Housing::InSeries(elastic + bolt)),
        (&[only], false) => Ok(Housing::Instead(only, bolt)),
        _ => Err(RotorError::HousingAmbiguous),
    }
}
