//! First bending mode of a rotor in one plane by the Initial Parameter Method (Hua et al. 2012, eqs. 36-55).
//!
//! Unknowns are the deflection and slope at the shaft's start and, instead of adding a spring's k z to the shear force, every
//! spring force and moment: z + (k_tr/k_tt) phi - R/k_tt = 0. A spring however stiff then loses no digits, and a rigid bearing is the
//! limit. Both ends are free: Mb = Q = 0.

use nalgebra::{DMatrix, DVector};

use super::count::natural_frequencies_below;
use super::plane::Plane;
use super::root::brent;
use super::transfer::Piece;

/// A natural mode of a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PlaneMode {
    /// rad/s
    pub omega: f64,
    /// Deflection at the mesh station, any unit
    pub deflection: f64,
    /// Slope at the mesh station, per m
    pub slope: f64,
    /// T of (56): integral of rho A z^2 (and rho I phi^2 under Timoshenko) over the whole shaft plus the bodies' m z^2 + J phi^2, in
    /// kg times the square of the deflection's unit
    pub inertia_integral: f64,
}

/// The lowest mode above zero; `guess` is any estimate of its frequency in rad/s.
///
/// `None` where numbers overflow.
pub fn first_mode(plane: &Plane, guess: f64) -> Option<PlaneMode> {
    let omega = first_frequency(plane, guess)?;
    let chain = Chain::new(plane);
    let unknowns = null_vector(chain.equations(omega))?;
    let inertia_integral = chain.inertia_integral(omega, &unknowns)? * plane.unit_stiffness;
    let state = *chain.states(omega, &unknowns).get(plane.mesh)?;
    Some(PlaneMode { omega, deflection: state[0], slope: state[1] / plane.unit_length, inertia_integral })
}

/// Brackets the lowest natural frequency by counting, so that no close pair is skipped, and polishes it on the determinant.
fn first_frequency(plane: &Plane, guess: f64) -> Option<f64> {
    const NARROW: f64 = 1e-13;
    // there the search ends, and up to there no piece needs cutting into more than a handful of parts
    let bound = plane.pieces.iter().map(Piece::clamped_bound).fold(f64::INFINITY, f64::min).sqrt();
    let guess = guess.min(bound);
    if !(guess.is_finite() && guess > 0.0) {
        return None;
    }
    let below = |omega| natural_frequencies_below(plane, omega);
    let (mut low, mut high) = (0.97 * guess, 1.03 * guess);
    while below(high)? == 0 {
        if high > 1.02 * bound {
            return None;
        }
        low = high;
        high = (1.5 * high).min(1.03 * bound);
    }
    while below(low)? > 0 {
        high = low;
        low /= 1.5;
        if low < f64::MIN_POSITIVE {
            return None;
        }
    }
    let halve = |low: &mut f64, high: &mut f64| -> Option<()> {
        let middle = f64::midpoint(*low, *high);
        if below(middle)? == 0 {
            *low = middle;
        } else {
            *high = middle;
        }
        Some(())
    };
    while below(high)? > 1 && high - low > NARROW * high {
        halve(&mut low, &mut high)?;
    }
    let chain = Chain::new(plane);
    let reference = chain.equations(high).lu().determinant().abs();
    let scale = if reference > 0.0 { reference } else { 1.0 };
    if let Some(root) = brent(|omega| chain.equations(omega).lu().determinant() / scale, low, high) {
        return Some(root);
    }
    // a double root has no change of sign: go on counting
    while high - low > NARROW * high {
        halve(&mut low, &mut high)?;
    }
    Some(f64::midpoint(low, high))
}

/// The shaft as a chain of transfer matrices with the unknowns numbered.
struct Chain<'a> {
    plane: &'a Plane,
    unknowns: usize,
}

/// State (z, phi, Mb, Q).
type State = [f64; 4];

impl<'a> Chain<'a> {
    fn new(plane: &'a Plane) -> Self {
        let springs: usize = plane.nodes.iter().map(|node| Springs::of(node).unknowns()).sum();
        Self { plane, unknowns: 2 + springs }
    }

    /// Square matrix of the conditions (support equations, then Mb = Q = 0 at the end) on the unknowns.
    fn equations(&self, omega: f64) -> DMatrix<f64> {
        let n = self.unknowns;
        let mut equations = DMatrix::zeros(n, n);
        // one column a unknown: the state it alone would cause
        let mut states = vec![[0.0; 4]; n];
        states[0][0] = 1.0;
        states[1][1] = 1.0;
        let mut next = 2;
        for (i, node) in self.plane.nodes.iter().enumerate() {
            let springs = Springs::of(node);
            if let Some(force) = springs.force {
                for (column, state) in states[..next].iter().enumerate() {
                    equations[(next - 2, column)] = force.on_deflection * state[0] + force.on_slope * state[1];
                }
                equations[(next - 2, next)] = -force.on_force;
                states[next] = [0.0, 0.0, force.moment_arm, -1.0];
                next += 1;
            }
            if let Some((on_slope, on_moment)) = springs.moment {
                for (column, state) in states[..next].iter().enumerate() {
                    equations[(next - 2, column)] = on_slope * state[1];
                }
                equations[(next - 2, next)] = -on_moment;
                states[next] = [0.0, 0.0, 1.0, 0.0];
                next += 1;
            }
            let inertia = omega * omega;
            for state in &mut states[..next] {
                state[3] += inertia * node.mass * state[0];
                state[2] -= inertia * node.inertia * state[1];
            }
            if let Some(piece) = self.plane.pieces.get(i) {
                let transfer = piece.transfer(inertia, piece.length);
                for state in &mut states[..next] {
                    *state = (transfer * nalgebra::Vector4::from(*state)).into();
                }
            }
        }
        for (column, state) in states.iter().enumerate() {
            equations[(n - 2, column)] = state[2];
            equations[(n - 1, column)] = state[3];
        }
        equations
    }

    /// State at every node, before what sits there acts.
    fn states(&self, omega: f64, unknowns: &DVector<f64>) -> Vec<State> {
        let mut state: State = [unknowns[0], unknowns[1], 0.0, 0.0];
        let mut next = 2;
        let mut out = Vec::with_capacity(self.plane.nodes.len());
        for (i, piece) in self.plane.pieces.iter().enumerate() {
            out.push(state);
            state = self.behind_node(i, state, omega, unknowns, &mut next);
            state = (piece.transfer(omega * omega, piece.length) * nalgebra::Vector4::from(state)).into();
        }
        out.push(state);
        out
    }

    /// State to the right of a node: springs and body have acted.
    fn behind_node(&self, i: usize, mut state: State, omega: f64, unknowns: &DVector<f64>, next: &mut usize) -> State {
        let node = &self.plane.nodes[i];
        let springs = Springs::of(node);
        if let Some(force) = springs.force {
            state[2] += force.moment_arm * unknowns[*next];
            state[3] -= unknowns[*next];
            *next += 1;
        }
        if springs.moment.is_some() {
            state[2] += unknowns[*next];
            *next += 1;
        }
        state[3] += omega * omega * node.mass * state[0];
        state[2] -= omega * omega * node.inertia * state[1];
        state
    }

    /// T of (56) in the plane's units: over the whole shaft, bodies included.
    fn inertia_integral(&self, omega: f64, unknowns: &DVector<f64>) -> Option<f64> {
        let omega_squared = omega * omega;
        let states = self.states(omega, unknowns);
        let mut next = 2;
        let mut total = 0.0;
        for (i, node) in self.plane.nodes.iter().enumerate() {
            let [z, phi, ..] = states[i];
            total += node.mass * z * z + node.inertia * phi * phi;
            let start = self.behind_node(i, states[i], omega, unknowns, &mut next);
            let Some(piece) = self.plane.pieces.get(i) else { break };
            // Gauss on parts shorter than a clamped half wave: exact to rounding
            let parts = piece.parts_without_own_modes(omega_squared);
            let part_length = piece.length / parts as f64;
            for part in 0..parts {
                for (abscissa, weight) in GAUSS {
                    let at = (part as f64 + 0.5 + 0.5 * abscissa) * part_length;
                    let state = piece.transfer(omega_squared, at) * nalgebra::Vector4::from(start);
                    let density = piece.mass * state[0] * state[0] + piece.rotary_inertia * state[1] * state[1];
                    total += 0.5 * part_length * weight * density;
                }
            }
        }
        total.is_finite().then_some(total)
    }
}

/// Abscissae and weights of ten-point Gauss-Legendre quadrature on (-1, 1).
const GAUSS: [(f64, f64); 10] = [
    (-0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
    (-0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (-0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (-0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
    (-0.148_874_338_981_631_22, 0.295_524_224_714_752_87),
    (0.148_874_338_981_631_22, 0.295_524_224_714_752_87),
    (0.433_395_394_129_247_2, 0.269_266_719_309_996_35),
    (0.679_409_568_299_024_4, 0.219_086_362_515_982_04),
    (0.865_063_366_688_984_5, 0.149_451_349_150_580_6),
    (0.973_906_528_517_171_7, 0.066_671_344_308_688_14),
];

/// Supports of a node as equations for their force R and moment.
struct Springs {
    force: Option<SpringForce>,
    /// `on_slope` phi - `on_moment` m = 0; m is added to Mb
    moment: Option<(f64, f64)>,
}

/// `on_deflection` z + `on_slope` phi - `on_force` R = 0; R is taken from Q and `moment_arm` R added to Mb.
#[derive(Clone, Copy)]
struct SpringForce {
    on_deflection: f64,
    on_slope: f64,
    on_force: f64,
    moment_arm: f64,
}

impl Springs {
    fn of(node: &super::plane::Node) -> Self {
        let (force, rotational) = if node.held {
            (Some(SpringForce { on_deflection: 1.0, on_slope: 0.0, on_force: 0.0, moment_arm: 0.0 }), node.rr)
        } else if node.tt > 0.0 {
            let arm = node.tr / node.tt;
            // written for the softer of spring and shaft, so that neither limit divides by zero
            let row = node.tt.min(1.0);
            let force =
                SpringForce { on_deflection: row, on_slope: row * arm, on_force: row / node.tt, moment_arm: arm };
            (Some(force), node.rr - node.tr * arm)
        } else {
            (None, node.rr)
        };
        // what is left of rr after the coupling may be no more than rounding
        let rotational = if rotational > 1e-13 * node.rr { rotational } else { 0.0 };
        let moment = (rotational > 0.0).then(|| (rotational.min(1.0), rotational.min(1.0) / rotational));
        Self { force, moment }
    }

    fn unknowns(&self) -> usize {
        usize::from(self.force.is_some()) + usize::from(self.moment.is_some())
    }
}

/// Right singular vector of the smallest singular value, rows scaled alike.
fn null_vector(mut equations: DMatrix<f64>) -> Option<DVector<f64>> {
    for mut row in equations.row_iter_mut() {
        let size = row.amax();
        if size > 0.0 {
            row /= size;
        }
    }
    if !equations.iter().all(|entry| entry.is_finite()) {
        return None;
    }
    let svd = equations.svd(false, true);
    let smallest = svd.singular_values.imin();
    Some(svd.v_t?.row(smallest).transpose())
}
