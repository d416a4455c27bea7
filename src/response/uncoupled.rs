//! Modes of both rotors without the mesh as one list, and shapes with the mesh as mixtures of theirs.

use nalgebra::{DMatrix, DVector};

use super::secular::Eigenvalue;
use crate::model::{Model, RotorModes};

/// Mass-normalised modes of both rotors without the mesh, ascending.
pub struct Uncoupled {
    /// rad^2/s^2
    pub lambda: Vec<f64>,
    /// phi . h; 0 where the mesh cannot feel the mode
    pub g: Vec<f64>,
    /// One column a mode
    shapes: DMatrix<f64>,
}

impl Uncoupled {
    pub fn new(model: &Model, rotors: &[RotorModes; 2]) -> Self {
        let n = model.coordinates();
        let mut columns: Vec<(f64, f64, DVector<f64>)> = Vec::with_capacity(n);
        let mut at = 0;
        for (modes, rotor) in rotors.iter().zip(model.rotors()) {
            let g = modes.participation(&rotor.mesh_vector);
            for (r, (&kappa, &theta)) in modes.stiffness.iter().zip(&modes.mass).enumerate() {
                // no mass, no frequency
                if theta <= 0.0 {
                    continue;
                }
                let scale = 1.0 / theta.sqrt();
                let mut shape = DVector::zeros(n);
                shape.rows_mut(at, rotor.coordinates.len()).axpy(scale, &modes.shapes.column(r), 0.0);
                columns.push((kappa / theta, g[r] * scale, shape));
            }
            at += rotor.coordinates.len();
        }
        columns.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut shapes = DMatrix::zeros(n, columns.len());
        for (target, column) in columns.iter().enumerate() {
            shapes.set_column(target, &column.2);
        }
        let mut out = Self {
            lambda: columns.iter().map(|column| column.0).collect(),
            g: columns.iter().map(|column| column.1).collect(),
            shapes,
        };
        out.join_equal();
        out.drop_uncoupled(model.mesh_stiffness);
        out
    }

    /// Of modes with one frequency (both planes of an isotropic shaft, both free rotations) any mixture is a mode: all of the mesh's grip goes to
    /// one of them, and the others stay as they are.
    fn join_equal(&mut self) {
        const EQUAL: f64 = 1e-13;
        /// rad^2/s^2: what rounding leaves of a frequency of a few hertz
        const FLOOR: f64 = 1e7;
        let mut gripped: Option<usize> = None;
        for i in 0..self.lambda.len() {
            if self.g[i] == 0.0 {
                continue;
            }
            let equal = |j: &usize| self.lambda[i] - self.lambda[*j] <= EQUAL * (self.lambda[i] + FLOOR);
            if let Some(j) = gripped.filter(equal) {
                let (a, b) = (self.g[i], self.g[j]);
                let length = a.hypot(b);
                let (first, second) = (self.shapes.column(i).into_owned(), self.shapes.column(j).into_owned());
                self.shapes.set_column(i, &((&first * a + &second * b) / length));
                self.shapes.set_column(j, &((&second * a - &first * b) / length));
                self.g[i] = length;
                self.g[j] = 0.0;
            }
            gripped = Some(i);
        }
    }

    /// Modes that the mesh cannot feel stay as they are.
    ///
    /// Judged by what the spring mixes into their shape, k g_i g_j / lambda_i: their frequency moves by the square of that only.
    fn drop_uncoupled(&mut self, mesh_stiffness: f64) {
        let all = self.g.iter().map(|g| g * g).sum::<f64>().sqrt();
        for (g, lambda) in self.g.iter_mut().zip(&self.lambda) {
            if mesh_stiffness * g.abs() * all <= f64::EPSILON * lambda {
                *g = 0.0;
            }
        }
    }
}

/// Rows of the shapes that only these columns have anything in: a motion of one rotor that nothing couples to its others.
struct Block {
    rows: Vec<usize>,
    columns: Vec<usize>,
    shapes: DMatrix<f64>,
}

/// Mixes shapes block by block: torsion, axial motion and both planes of bending apart cost a fraction of the whole.
pub struct Mixer<'a> {
    uncoupled: &'a Uncoupled,
    blocks: Vec<Block>,
}

impl<'a> Mixer<'a> {
    pub fn new(uncoupled: &'a Uncoupled) -> Self {
        let shapes = &uncoupled.shapes;
        let mut groups = Groups::new(shapes.nrows());
        let first_rows: Vec<Option<usize>> = (0..shapes.ncols())
            .map(|column| {
                let mut moving = (0..shapes.nrows()).filter(|&row| shapes[(row, column)] != 0.0);
                let first = moving.next()?;
                moving.for_each(|row| groups.join(first, row));
                Some(first)
            })
            .collect();
        let block = |group: usize| {
            let rows: Vec<usize> = (0..shapes.nrows()).filter(|&row| groups.of(row) == group).collect();
            let is_in = |column: &usize| first_rows[*column].is_some_and(|row| groups.of(row) == group);
            let columns: Vec<usize> = (0..shapes.ncols()).filter(is_in).collect();
            let shapes = DMatrix::from_fn(rows.len(), columns.len(), |i, j| shapes[(rows[i], columns[j])]);
            Block { rows, columns, shapes }
        };
        let blocks = (0..shapes.nrows()).filter(|&row| groups.of(row) == row).map(block).collect();
        Self { uncoupled, blocks }
    }

    /// Shapes of modes with the mesh, one a column, of any scale.
    pub fn shapes(&self, modes: &[Eigenvalue]) -> DMatrix<f64> {
        let weights = weights(self.uncoupled, modes);
        let mut out = DMatrix::zeros(self.uncoupled.shapes.nrows(), modes.len());
        for Block { rows, columns, shapes } in &self.blocks {
            let own = shapes * weights.select_rows(columns);
            for (from, &to) in rows.iter().enumerate() {
                out.set_row(to, &own.row(from));
            }
        }
        out
    }
}

/// How much of each mode without the mesh is in those with it, one a column.
fn weights(Uncoupled { lambda, g, .. }: &Uncoupled, modes: &[Eigenvalue]) -> DMatrix<f64> {
    let mut weights = DMatrix::zeros(lambda.len(), modes.len());
    for (mut column, mode) in weights.column_iter_mut().zip(modes) {
        match *mode {
            Eigenvalue::Kept(i) => column[i] = 1.0,
            Eigenvalue::Moved { origin, offset } => {
                let weight = |r: usize| if g[r] == 0.0 { 0.0 } else { g[r] / ((lambda[r] - lambda[origin]) - offset) };
                column.copy_from(&DVector::from_fn(lambda.len(), |r, _| weight(r)).normalize());
            }
        }
    }
    weights
}

/// Rows that belong together; each group is named by its first row.
struct Groups(Vec<usize>);

impl Groups {
    fn new(rows: usize) -> Self {
        Self((0..rows).collect())
    }

    fn of(&self, mut row: usize) -> usize {
        while self.0[row] != row {
            row = self.0[row];
        }
        row
    }

    fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.of(a), self.of(b));
        self.0[a.max(b)] = a.min(b);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::{library::SHIPPED, read};
    use crate::model::{ModelKind, Rotors};
    use crate::response::{both_rotor_modes, secular};

    #[test]
    fn blocks_give_the_product_of_the_whole_matrices() {
        for shipped in SHIPPED {
            let design = read(shipped.text).design.unwrap();
            let rotors = Rotors::new(&design).unwrap();
            for kind in [ModelKind::Fe, ModelKind::Basic, ModelKind::Reduced(5)] {
                let model = Model::new(kind, &design, &rotors).unwrap();
                let uncoupled = Uncoupled::new(&model, &both_rotor_modes(&model).unwrap());
                let Uncoupled { lambda, g, shapes } = &uncoupled;
                let modes = secular::eigenvalues(lambda, g, model.mesh_stiffness);
                let mixer = Mixer::new(&uncoupled);
                assert!(mixer.blocks.len() > 1, "{}: nothing is apart", shipped.file_name);
                let in_blocks = mixer.shapes(&modes);
                let whole = shapes * weights(&uncoupled, &modes);
                for (own, expected) in in_blocks.column_iter().zip(whole.column_iter()) {
                    assert!((own - expected).norm() < 1e-13 * expected.norm(), "{} {kind:?}", shipped.file_name);
                }
            }
        }
    }
}
