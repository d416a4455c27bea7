//! All elements of a bearing together: displacement to loads, stiffness and energy.

use std::f64::consts::TAU;

use nalgebra::{ComplexField, SMatrix};

use super::{Bearing, Kind, Matrix, Vector, ball, roller};

/// Rows: radial and axial displacement at one element, and tilt in its plane, over q.
pub(super) type Kinematics = SMatrix<f64, 3, 5>;

/// One element under a displacement of the rings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Where the element stands: rad from X towards Y
    pub position: f64,
    /// N; 0 where it is not in contact
    pub load: f64,
    /// Approach of the raceways, m; not positive where a ball is not in contact (of a roller, at its middle)
    pub deflection: f64,
    /// rad
    pub angle: f64,
}

/// A bearing at one displacement of its rings.
#[derive(Debug, Clone, PartialEq)]
pub struct State {
    /// q
    pub displacement: Vector,
    /// f(q)
    pub load: Vector,
    /// K = df/dq: symmetric, positive semidefinite
    pub stiffness: Matrix,
    /// All elements, by position
    pub contacts: Vec<Contact>,
    pub warnings: Vec<Warning>,
}

/// What is unusual about a state. That some elements carry no load is not: under a radial load half of them seldom do.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Warning {
    #[error("all of the load is carried by {loaded} of {elements} rolling elements")]
    FewLoaded { loaded: usize, elements: usize },
    #[error(
        "{0} {bear} on the opposite shoulder, which a bearing with one shoulder does not have",
        bear = if *.0 == 1 { "ball bears" } else { "balls bear" }
    )]
    OppositeShoulder(usize),
    #[error(
        "balls approach by {deflection_mm:.4} mm, more than 2 % of their diameter: beyond the range of the formulas"
    )]
    Deep { deflection_mm: f64 },
}

impl State {
    /// Elements that carry a load.
    pub fn loaded(&self) -> usize {
        self.contacts.iter().filter(|contact| contact.load > 0.0).count()
    }

    /// What is worth knowing and not unusual: how many elements carry no load, where there are any.
    pub fn note(&self) -> Option<String> {
        let (elements, loaded) = (self.contacts.len(), self.loaded());
        (loaded < elements).then(|| format!("{} of {elements} rolling elements carry no load", elements - loaded))
    }

    /// The greatest load of an element, N.
    pub fn greatest_load(&self) -> f64 {
        self.contacts.iter().map(|contact| contact.load).fold(0.0, f64::max)
    }

    /// Least and greatest contact angle of the loaded elements, rad; nothing where none is loaded.
    pub fn angle_range(&self) -> Option<[f64; 2]> {
        let loaded = self.contacts.iter().filter(|contact| contact.load > 0.0).map(|contact| contact.angle);
        loaded.fold(None, |range, angle| {
            let [low, high]: [f64; 2] = range.unwrap_or([angle; 2]);
            Some([low.min(angle), high.max(angle)])
        })
    }
}

impl Bearing {
    /// Element j stands at 2 pi j / Z from X towards Y.
    fn position(&self, j: usize) -> f64 {
        TAU * j as f64 / self.0.elements as f64
    }

    pub(super) fn kinematics(&self, j: usize) -> Kinematics {
        let (s, c) = self.position(j).sin_cos();
        let r = self.0.radius;
        Kinematics::new(c, s, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, r * s, -r * c, 0.0, 0.0, 0.0, -s, c)
    }

    /// Displacements at element j; the clearance is taken off the radial one.
    fn at_element(&self, j: usize, q: &Vector) -> [f64; 3] {
        let at = self.kinematics(j) * q;
        [at[0] - self.0.clearance, at[1], at[2]]
    }

    /// Loads on the inner ring at displacement q. For complex q the derivative comes out exactly (complex step).
    pub fn load<T: ComplexField<RealField = f64> + Copy>(&self, q: &[T; 5]) -> [T; 5] {
        let mut load = [T::zero(); 5];
        for j in 0..self.0.elements {
            let b = self.kinematics(j);
            let mut at = [T::zero(); 3];
            for (row, value) in at.iter_mut().enumerate() {
                *value = (0..5).fold(T::zero(), |sum, i| sum + q[i] * T::from_real(b[(row, i)]));
            }
            at[0] -= T::from_real(self.0.clearance);
            let force = match self.0.kind {
                Kind::Ball { groove_distance } => {
                    let [radial, axial] = ball::force(self, groove_distance, [at[0], at[1]]);
                    [radial, axial, T::zero()]
                }
                Kind::Roller { length } => roller::force(self, length, at),
            };
            for (i, total) in load.iter_mut().enumerate() {
                *total += (0..3).fold(T::zero(), |sum, row| sum + force[row] * T::from_real(b[(row, i)]));
            }
        }
        load
    }

    /// Elastic energy U of all contacts, N m; f = dU/dq.
    pub fn energy(&self, q: &Vector) -> f64 {
        let energy = |j: usize| {
            let [radial, axial, tilt] = self.at_element(j, q);
            match self.0.kind {
                Kind::Ball { groove_distance } => ball::energy(self, groove_distance, [radial, axial]),
                Kind::Roller { length } => roller::energy(self, length, [radial, axial, tilt]),
            }
        };
        (0..self.0.elements).map(energy).sum()
    }

    /// K = df/dq.
    pub fn stiffness(&self, q: &Vector) -> Matrix {
        let mut sum = Matrix::zeros();
        for j in 0..self.0.elements {
            let [radial, axial, tilt] = self.at_element(j, q);
            let local = match self.0.kind {
                Kind::Ball { groove_distance } => ball::stiffness(self, groove_distance, [radial, axial]),
                Kind::Roller { length } => roller::stiffness(self, length, [radial, axial, tilt]),
            };
            let b = self.kinematics(j);
            sum += b.transpose() * local * b;
        }
        // the product leaves the two halves apart by rounding
        (sum + sum.transpose()) / 2.0
    }

    /// Everything about one displacement.
    pub fn state(&self, q: &Vector) -> State {
        let contacts: Vec<Contact> = (0..self.0.elements).map(|j| self.contact(j, q)).collect();
        let warnings = self.warnings(&contacts);
        let load = Vector::from(self.load(&(*q).into()));
        State { displacement: *q, load, stiffness: self.stiffness(q), contacts, warnings }
    }

    fn contact(&self, j: usize, q: &Vector) -> Contact {
        let [radial, axial, tilt] = self.at_element(j, q);
        let position = self.position(j);
        match self.0.kind {
            Kind::Ball { groove_distance } => {
                let (deflection, load, angle) = ball::contact(self, groove_distance, [radial, axial]);
                Contact { position, load, deflection, angle }
            }
            Kind::Roller { length } => {
                let (deflection, load) = roller::contact(self, length, [radial, axial, tilt]);
                Contact { position, load, deflection, angle: self.0.contact_angle }
            }
        }
    }

    fn warnings(&self, contacts: &[Contact]) -> Vec<Warning> {
        // two lines of contact hold the shaft in one direction only
        const FEW: usize = 2;
        // angular contact bearings begin at 12 deg or more; what is less steep is a deep groove bearing, which has both shoulders and owes
        // its angle to clearance
        const ONE_SHOULDER_DEG: f64 = 12.0 - 1e-9;
        let mut warnings = Vec::new();
        let loaded = contacts.iter().filter(|contact| contact.load > 0.0).count();
        if (1..=FEW).contains(&loaded) {
            warnings.push(Warning::FewLoaded { loaded, elements: self.0.elements });
        }
        let Kind::Ball { groove_distance } = self.0.kind else { return warnings };
        let opposite = |contact: &&Contact| contact.load > 0.0 && contact.angle * self.0.contact_angle < 0.0;
        let opposite = contacts.iter().filter(opposite).count();
        let has_one_shoulder = self.0.contact_angle.to_degrees().abs() >= ONE_SHOULDER_DEG;
        if opposite > 0 && has_one_shoulder {
            warnings.push(Warning::OppositeShoulder(opposite));
        }
        // A0 = (f_i + f_o - 1) D, usually 0.04 D: half of A0 is 0.02 D
        let deepest = contacts.iter().map(|contact| contact.deflection).fold(0.0, f64::max);
        if deepest > groove_distance / 2.0 {
            warnings.push(Warning::Deep { deflection_mm: deepest * 1e3 });
        }
        warnings
    }
}
