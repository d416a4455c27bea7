//! A rotor reduced to its interface and its lowest modes with the interface held (Craig and Bampton 1968).
//!
//! The interface is what the lumped models have: the six coordinates of the mesh station, and the drive where there is one. With no mode it is the static
//! (Guyan 1965) model; with all of them it is the finite element rotor in other coordinates.

use std::ops::ControlFlow;
use std::sync::Arc;

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::eigen::{RotorModes, WorkDone, natural_modes_over, uncoupled_parts};
use super::tridiagonal::QrError;
use super::{Coordinate, ModelError, Reduction, RotorModel, fe, lumped};
use crate::design::{Design, Side};
use crate::rotor::{Motion, Rotor};

/// The static shapes and all fixed-interface modes of one rotor, from which any number of modes can be kept.
#[derive(Debug, Clone)]
pub struct CraigBampton {
    full: Arc<RotorModel>,
    /// K of the interface: that of the lumped models, since static condensation is exact; x, y, z, thx, thy, thz of the mesh station, then
    /// the drive if any
    interface_stiffness: DMatrix<f64>,
    /// phi^T K phi of the fixed-interface modes, ascending in frequency
    modal_stiffness: Vec<f64>,
    mesh_vector: DVector<f64>,
    /// Displacements of the finite element coordinates: static shapes for unit motion of each interface coordinate, then the modes
    basis: DMatrix<f64>,
}

impl CraigBampton {
    /// Solves the static shapes and the fixed-interface modes of a rotor.
    ///
    /// # Errors
    ///
    /// Values that lie too many orders of magnitude apart.
    pub fn new(design: &Design, rotor: &Rotor, side: Side) -> Result<Self, ModelError> {
        Self::new_over(design, rotor, side, &mut |_| ControlFlow::Continue(()))
    }

    /// As [`CraigBampton::new`]; `done` hears of the work between its steps, and may end it.
    ///
    /// # Errors
    ///
    /// As [`CraigBampton::new`]; [`ModelError::Cancelled`] where `done` breaks.
    pub fn new_over(design: &Design, rotor: &Rotor, side: Side, done: &mut WorkDone<'_>) -> Result<Self, ModelError> {
        let failed = ModelError::IllConditioned(side);
        let full = fe::rotor(design, rotor, side);
        let parted = Parted::new(&full).ok_or(failed.clone())?;
        let free = DVector::zeros(parted.interior.len());
        let modes = match natural_modes_over(&parted.inside, &parted.inside_mass, &free, done) {
            Ok(modes) => modes,
            Err(QrError::Ended) => return Err(ModelError::Cancelled),
            Err(QrError::NotConverged) => return Err(failed),
        };
        Self::join(full, &parted, &modes, (design, rotor, side)).ok_or(failed)
    }

    fn join(
        full: RotorModel,
        parted: &Parted,
        modes: &RotorModes,
        (design, rotor, side): (&Design, &Rotor, Side),
    ) -> Option<Self> {
        let Parted { interface, interior, .. } = parted;
        let held = interface.len();
        let mut order: Vec<usize> = (0..interior.len()).collect();
        // kappa + s theta = 1: the greater the modal mass, the lower the frequency
        order.sort_by(|&a, &b| modes.mass[b].total_cmp(&modes.mass[a]));
        let mut basis = parted.static_shapes()?.resize_horizontally(held + order.len(), 0.0);
        for (row, &i) in interior.iter().enumerate() {
            for (column, &mode) in order.iter().enumerate() {
                basis[(i, held + column)] = modes.shapes[(row, mode)];
            }
        }
        let interface_stiffness = lumped::stiffness(design, rotor, side);
        let mesh_vector = DVector::from_iterator(held, interface.iter().map(|&i| full.mesh_vector[i]));
        let pushed = basis.columns(0, held) * under_mesh_force(&interface_stiffness, &mesh_vector)?;
        let modal_mass: Vec<f64> = order.iter().map(|&mode| modes.mass[mode]).collect();
        join_equal(&mut basis, held, &modal_mass, &(&full.mass * pushed));
        if !basis.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        Some(Self {
            interface_stiffness,
            modal_stiffness: order.iter().map(|&mode| modes.stiffness[mode]).collect(),
            mesh_vector: mesh_vector.resize_vertically(basis.ncols(), 0.0),
            basis,
            full: Arc::new(full),
        })
    }

    /// Number of coordinates that are held.
    fn interface(&self) -> usize {
        self.interface_stiffness.nrows()
    }

    /// Number of fixed-interface modes there are.
    pub fn modes(&self) -> usize {
        self.modal_stiffness.len()
    }

    /// The rotor with its lowest fixed-interface modes, all of them where there are fewer.
    pub fn keep(&self, modes: usize) -> RotorModel {
        let modes = modes.min(self.modes());
        let interface = self.interface();
        let n = interface + modes;
        let mut stiffness = DMatrix::zeros(n, n);
        stiffness.view_mut((0, 0), (interface, interface)).copy_from(&self.interface_stiffness);
        for (i, kappa) in self.modal_stiffness.iter().take(modes).enumerate() {
            stiffness[(interface + i, interface + i)] = *kappa;
        }
        let basis = self.basis.columns(0, n).into_owned();
        // of the modes that are kept: those of all would take longer than to find them
        let mass = basis.tr_mul(&(&self.full.mass * &basis));
        let station = self.full.mesh_station;
        let at_mesh = Motion::ALL.into_iter().map(|motion| Coordinate::Station(station, motion));
        let held = (0..modes).map(Coordinate::FixedInterfaceMode);
        RotorModel {
            stiffness,
            mass: (&mass + mass.transpose()) * 0.5,
            mesh_vector: self.mesh_vector.rows(0, n).into_owned(),
            coordinates: at_mesh.chain(self.full.drive().map(|_| Coordinate::Drive)).chain(held).collect(),
            mesh_station: station,
            reduction: Some(Box::new(Reduction { full: Arc::clone(&self.full), basis })),
        }
    }
}

/// Static displacement of the interface under a unit mesh force, without turning.
fn under_mesh_force(stiffness: &DMatrix<f64>, mesh_vector: &DVector<f64>) -> Option<DVector<f64>> {
    const HELD: [usize; 5] = [0, 1, 2, 3, 5];
    let held = stiffness.select_rows(&HELD).select_columns(&HELD);
    let scale = held.diagonal().map(|entry| 1.0 / entry.sqrt());
    let scaled = DMatrix::from_fn(5, 5, |i, j| scale[i] * held[(i, j)] * scale[j]);
    let mut found = mesh_vector.select_rows(&HELD).component_mul(&scale);
    Cholesky::new(scaled)?.solve_mut(&mut found);
    let mut out = DVector::zeros(mesh_vector.len());
    for (row, &i) in HELD.iter().enumerate() {
        out[i] = found[row] * scale[row];
    }
    Some(out)
}

/// Of modes with one frequency (both planes of a shaft that is alike from all sides) any mixture is a mode, and which of them comes
/// first would be up to rounding: first comes the one that takes all of `load`, and the others none.
fn join_equal(basis: &mut DMatrix<f64>, held: usize, modal_mass: &[f64], load: &DVector<f64>) {
    const EQUAL: f64 = 1e-9;
    let mut first = 0;
    for i in 1..modal_mass.len() {
        if modal_mass[first] - modal_mass[i] > EQUAL * modal_mass[first] {
            first = i;
            continue;
        }
        let (one, other) = (basis.column(held + first).into_owned(), basis.column(held + i).into_owned());
        let (a, b) = (one.dot(load), other.dot(load));
        let length = a.hypot(b);
        if length > 0.0 && length.is_finite() {
            basis.set_column(held + first, &((&one * a + &other * b) / length));
            basis.set_column(held + i, &((&other * a - &one * b) / length));
        }
    }
}

/// A rotor's coordinates, those of the interface apart from the others.
struct Parted {
    interface: Vec<usize>,
    interior: Vec<usize>,
    /// K and M of the interior, and K from the interface to it
    inside: DMatrix<f64>,
    inside_mass: DMatrix<f64>,
    across: DMatrix<f64>,
}

impl Parted {
    fn new(full: &RotorModel) -> Option<Self> {
        let at_mesh = Motion::ALL.into_iter().map(|motion| full.at_mesh(motion));
        let interface = at_mesh.chain(full.drive().map(Some)).collect::<Option<Vec<usize>>>()?;
        let interior: Vec<usize> = (0..full.coordinates.len()).filter(|i| !interface.contains(i)).collect();
        let stiffness = full.stiffness.select_rows(&interior);
        Some(Self {
            inside: stiffness.select_columns(&interior),
            inside_mass: full.mass.select_rows(&interior).select_columns(&interior),
            across: stiffness.select_columns(&interface),
            interface,
            interior,
        })
    }

    /// Displacements of all coordinates for unit motion of each of the interface: - `K_ii`^-1 `K_ib` inside.
    fn static_shapes(&self) -> Option<DMatrix<f64>> {
        let Self { interface, interior, inside, across, .. } = self;
        let mut whole = DMatrix::zeros(interior.len() + interface.len(), interface.len());
        for (column, &i) in interface.iter().enumerate() {
            whole[(i, column)] = 1.0;
        }
        for part in uncoupled_parts(inside, inside) {
            let n = part.len();
            let scale = DVector::from_fn(n, |i, _| 1.0 / inside[(part[i], part[i])].sqrt());
            let scaled = DMatrix::from_fn(n, n, |i, j| scale[i] * inside[(part[i], part[j])] * scale[j]);
            let factor: Cholesky<f64, Dyn> = Cholesky::new(scaled)?;
            let mut shapes = DMatrix::from_fn(n, across.ncols(), |i, j| -scale[i] * across[(part[i], j)]);
            factor.solve_mut(&mut shapes);
            for (row, &inner) in part.iter().enumerate() {
                whole.set_row(interior[inner], &(shapes.row(row) * scale[row]));
            }
        }
        Some(whole)
    }
}

/// Displacements of the finite element coordinates for unit motion of x, y, z, thx, thy, thz of the mesh station and of the drive if any, all
/// others of these held and nothing moving fast: one column each.
///
/// # Errors
///
/// Values that lie too many orders of magnitude apart.
pub fn static_shapes(full: &RotorModel, side: Side) -> Result<DMatrix<f64>, ModelError> {
    Parted::new(full).and_then(|parted| parted.static_shapes()).ok_or(ModelError::IllConditioned(side))
}
