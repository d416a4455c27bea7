//! Where and why models disagree, on designs whose cause is known.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod support;

use bevelscope::agreement::{
    Causes, DisagreementBand, ModalComparison, Part, Parts, difference_db, disagreement_bands, peaks,
};
use bevelscope::comparison::{solve, solve_with_bearings};
use bevelscope::design::{BeamTheory, Design, Side, library, read};
use bevelscope::model::{Model, ModelKind, Rotors, pinion_speed_rpm};
use bevelscope::response::{Modes, frequency_lines};
use num_complex::Complex64;
use proptest::prelude::*;
use support::random::{config, designs};
use support::{FRISWELL_STEEL, design, disc, ordinary, rotor, spring, steel_shaft};

fn causes(kind: ModelKind, design: &Design, tolerance: f64) -> Vec<Causes> {
    let rotors = Rotors::new(design).unwrap();
    let lines = frequency_lines(&design.analysis);
    let force = |kind| solve(kind, design, &rotors, &lines).unwrap().mesh_force;
    let modes = ModalComparison::new(kind, design, &rotors).unwrap();
    let bands = disagreement_bands(&lines, &force(kind), &force(ModelKind::Fe), tolerance);
    bands.into_iter().map(|band| Causes::new(&modes, &rotors, band)).collect()
}

proptest! {
    #![proptest_config(config(40))]

    /// Every line beyond the tolerance lies in one band, every other in none; the worst is the worst.
    #[test]
    fn bands_hold_exactly_the_lines_beyond_the_tolerance(levels in prop::collection::vec(-9.0_f64..9.0, 1..40), tolerance in 0.5_f64..6.0) {
        let lines: Vec<f64> = (0..levels.len()).map(|i| 10.0 + i as f64).collect();
        let force: Vec<Complex64> = levels.iter().map(|db| Complex64::from(10_f64.powf(db / 20.0))).collect();
        let fe = vec![Complex64::from(1.0); levels.len()];
        let bands = disagreement_bands(&lines, &force, &fe, tolerance);
        let differences = difference_db(&force, &fe);
        for (f, d) in lines.iter().zip(&differences) {
            let inside = bands.iter().filter(|b| (b.from_hz..=b.to_hz).contains(f)).count();
            prop_assert_eq!(inside, usize::from(d.abs() > tolerance));
        }
        for pair in bands.windows(2) {
            prop_assert!(pair[1].from_hz - pair[0].to_hz > 1.5);
        }
        for band in bands {
            let own = lines.iter().zip(&differences).filter(|(f, _)| (band.from_hz..=band.to_hz).contains(f));
            let worst = own.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).unwrap();
            prop_assert_eq!((*worst.0, *worst.1), (band.worst_at_hz, band.worst_db));
        }
    }

    /// k_m (h . phi)^2 / lambda is a share of the strain energy, the motions make up all of the kinetic energy, and every mode has a name.
    #[test]
    fn strain_shares_and_names(design in designs()) {
        let rotors = Rotors::new(&design).unwrap();
        for kind in [ModelKind::Fe, ModelKind::Enhanced, ModelKind::Basic, ModelKind::Reduced(2)] {
            let model = Model::new(kind, &design, &rotors).unwrap();
            for mode in Modes::new(&model, 30).unwrap().0 {
                let lambda = (std::f64::consts::TAU * mode.frequency_hz).powi(2);
                let top = model.pinion.coordinates.len();
                let parts = [mode.shape.rows(0, top).into_owned(), mode.shape.rows(top, mode.shape.len() - top).into_owned()];
                let strain: f64 = model.rotors().iter().zip(&parts).map(|(r, x)| x.dot(&(&r.stiffness * x))).sum();
                if mode.frequency_hz > 10.0 {
                    // the rest of the strain is in shafts, bearings and drives
                    let rest = strain / lambda;
                    prop_assert!((mode.mesh_strain_share + rest - 1.0).abs() < 1e-5, "{} {rest}", mode.mesh_strain_share);
                }
                let all: f64 = mode.motions.iter().flatten().sum();
                prop_assert!((all - 1.0).abs() < 1e-9);
                prop_assert!(!mode.name().is_empty());
                let most = [mode.pinion, mode.gear].into_iter().flat_map(|s| [s.lateral, s.axial, s.tilt, s.torsion]);
                prop_assert_eq!(mode.dominant().share, most.fold(0.0, f64::max));
            }
        }
    }

    /// Without damping the modes' parts over lambda - w^2, times k_m e, are the transmission error and the forces of the bearings.
    #[test]
    fn the_parts_of_all_modes_are_the_whole(mut design in designs(), place in 0.05_f64..0.95) {
        design.analysis.structural_damping = 0.0;
        design.mesh.damping = 0.0;
        let rotors = Rotors::new(&design).unwrap();
        for kind in [ModelKind::Enhanced, ModelKind::Reduced(2)] {
            let modes = ModalComparison::new(kind, &design, &rotors).unwrap();
            // in the middle between two modes that are apart
            let all: Vec<f64> = modes.fe.0.iter().chain(&modes.lumped.0).map(|mode| mode.frequency_hz).collect();
            let nearest = |hz: f64| all.iter().map(|mode| (mode / hz - 1.0).abs()).fold(f64::INFINITY, f64::min);
            let from = 20.0 + 2000.0 * place;
            let hz = (0..400).map(|i| from * (1.0 + 0.002 * f64::from(i))).max_by(|a, b| nearest(*a).total_cmp(&nearest(*b))).unwrap();
            let omega = std::f64::consts::TAU * hz;
            let drive = design.mesh.stiffness * design.mesh.transmission_error;
            let sum = |modes: &Modes, parts: &[Vec<Part>], component: usize| -> (f64, f64) {
                let term = |(mode, parts): (&bevelscope::response::Mode, &Vec<Part>)| {
                    drive * parts[component].at(omega, Complex64::from(1.0)).re
                        / ((std::f64::consts::TAU * mode.frequency_hz).powi(2) - omega * omega)
                };
                let terms: Vec<f64> = modes.0.iter().zip(parts).map(term).collect();
                (terms.iter().sum(), terms.iter().map(|term| term.abs()).sum())
            };
            let near = |(sum, size): (f64, f64), wanted: Complex64| (sum - wanted.re).abs() <= 1e-5 * size + 1e-12;
            let parts = Parts::of_mesh(&modes);
            for (kind, of, parts) in [(ModelKind::Fe, &modes.fe, &parts.fe), (kind, &modes.lumped, &parts.lumped)] {
                let error = solve(kind, &design, &rotors, &[hz]).unwrap().transmission_error[0];
                prop_assert!(near(sum(of, parts, 0), error), "{kind:?} {hz} {:?} {error}", sum(of, parts, 0));
            }
            for side in Side::BOTH {
                for bearing in 0..design.rotor(side).bearings.len() {
                    let parts = Parts::of_bearing(&modes, &design, &rotors, (side, bearing), &[0, 1, 2]).unwrap();
                    for (kind, of, parts) in [(ModelKind::Fe, &modes.fe, &parts.fe), (kind, &modes.lumped, &parts.lumped)] {
                        let solved = solve_with_bearings(kind, &design, &rotors, &[hz]).unwrap();
                        let mut own = solved.bearings.iter().filter(|other| other.side == side);
                        let force = own.nth(bearing).unwrap().force[0];
                        for (component, wanted) in force.iter().take(3).enumerate() {
                            let sum = sum(of, parts, component);
                            prop_assert!(near(sum, *wanted), "{kind:?} {side:?} {bearing} {component} {sum:?} {wanted}");
                        }
                    }
                }
            }
        }
    }

    /// A model that is finite elements in other words has no band; whatever is said of others has one to five sentences.
    #[test]
    fn something_is_said_of_every_band(design in designs()) {
        prop_assert!(causes(ModelKind::Reduced(usize::MAX), &design, 0.01).is_empty());
        for kind in [ModelKind::Enhanced, ModelKind::Basic, ModelKind::Reduced(1)] {
            for causes in causes(kind, &design, 3.0) {
                let sentences = causes.sentences();
                prop_assert!((1..=5).contains(&sentences.len()), "{sentences:?}");
                prop_assert!(sentences.iter().all(|s| s.ends_with('.') && !s.contains("NaN") && !s.contains("inf ")), "{sentences:?}");
            }
        }
    }
}

/// A pinion held alike on both sides of its mesh: its first bending mode does not tilt there (theory of eqs. 56, 57).
#[test]
fn symmetric_straddle_mounting_falls_back_on_the_static_inertia() {
    let stiff = [4e8, 2e8, 4e8, 0.0, 0.0];
    let mut pinion = rotor(
        vec![steel_shaft(0.1, 0.03, 4), steel_shaft(0.1, 0.03, 4)],
        vec![disc(0.1, 1.0, 1e-3, 8e-4)],
        vec![spring(0.0, stiff), spring(0.2, stiff)],
    );
    pinion.mesh_position = 0.1;
    let whole = design(BeamTheory::Timoshenko, FRISWELL_STEEL, pinion, ordinary().gear);
    let all = causes(ModelKind::Enhanced, &whole, 0.5);
    let figures = |causes: &Causes| causes.planes.clone();
    assert!(
        all.iter().flat_map(figures).all(|p| p.inertia_fallback == (p.rotor.side == Side::Pinion) && !p.mass_fallback)
    );
    let said: Vec<String> = all.iter().flat_map(Causes::sentences).collect();
    assert!(
        said.iter().any(|s| s.starts_with("The inertia of the pinion in the") && s.contains("is the static one")),
        "{said:#?}"
    );
    assert!(!said.iter().any(|s| s.contains("of the gear") && s.contains("static one")), "{said:#?}");
    // the basic model never falls back
    assert!(causes(ModelKind::Basic, &whole, 3.0).iter().flat_map(figures).all(|p| !p.inertia_fallback));
}

/// Torsion of the shaft between mesh and gear wheel is in no lumped model, whose shaft turns as one.
#[test]
fn a_mode_that_lumped_models_lack_is_named() {
    let design = read(library::SHIPPED[0].text).design.unwrap();
    let missing: Vec<Causes> = causes(ModelKind::Enhanced, &design, 3.0)
        .into_iter()
        .filter(|causes| causes.responsible.is_some_and(|r| r.fe.is_some() && r.lumped.is_none()))
        .collect();
    assert!(!missing.is_empty());
    for causes in missing {
        let (name, hz, _) = causes.mode.clone().unwrap();
        assert!(causes.unpaired.iter().any(|mode| mode.frequency_hz == hz && mode.name == name));
        assert!(causes.shift.is_none());
        assert!(causes.sentences()[1].ends_with("is missing in the enhanced model."), "{:?}", causes.sentences());
    }
}

/// The share of the motion that names the mode is said once.
#[test]
fn a_motion_is_named_once() {
    let design = read(library::SHIPPED[0].text).design.unwrap();
    let said: Vec<String> = causes(ModelKind::Enhanced, &design, 3.0).iter().flat_map(Causes::sentences).collect();
    let said = said.join(" ");
    assert!(said.contains("(gear torsion 81 %)") && said.contains("(pinion axial 80 %)"), "{said}");
    assert!(said.contains("(pinion lateral 42 % with gear tilt)"), "{said}");
}

/// Whether a mode without partner is worth a word is judged by its part in what is looked at: in a bearing's force on one shaft, which a mode
/// may hardly have that the mesh drives strongly.
#[test]
fn others_in_a_band_are_judged_by_what_is_looked_at() {
    let design = ordinary();
    let rotors = Rotors::new(&design).unwrap();
    let modes = ModalComparison::new(ModelKind::Basic, &design, &rotors).unwrap();
    let band = DisagreementBand { from_hz: 1.0, to_hz: 1e5, worst_db: 6.0, worst_at_hz: 1000.0 };
    let parts = Parts::of_bearing(&modes, &design, &rotors, (Side::Pinion, 0), &[0, 1, 2]).unwrap();
    let causes = Causes::in_parts(&modes, &parts, &rotors, band);
    let size = |i: usize| {
        let omega = std::f64::consts::TAU * modes.fe.0[i].frequency_hz;
        let factor = modes.fe_model.structural_factor(omega);
        parts.fe[i].iter().map(|part| part.at(omega, factor).norm_sqr()).sum::<f64>().sqrt()
    };
    let largest = (0..modes.fe.0.len()).map(size).fold(0.0, f64::max);
    assert!(!causes.unpaired.is_empty());
    for mode in &causes.unpaired {
        assert!((mode.participation - size(mode.fe) / largest).abs() < 1e-12, "{mode:?}");
    }
    let of_mesh = Causes::new(&modes, &rotors, band);
    let largest = modes.fe.0.iter().map(|mode| mode.participation).fold(0.0, f64::max);
    for mode in &of_mesh.unpaired {
        assert!((mode.participation - modes.fe.0[mode.fe].participation / largest).abs() < 1e-12, "{mode:?}");
    }
}

/// Modes are all there, one of them lies 3 % higher.
#[test]
fn a_shifted_pair_is_named() {
    let design = ordinary();
    let rotors = Rotors::new(&design).unwrap();
    let mut modes = ModalComparison::new(ModelKind::Reduced(usize::MAX), &design, &rotors).unwrap();
    // stands in for the lumped model: every mode as in finite elements, one of them 3 % higher
    modes.lumped = modes.fe.clone();
    modes.lumped_model = modes.fe_model.clone();
    modes.pairs =
        (0..modes.fe.0.len()).map(|i| bevelscope::agreement::ModePair { lumped: i, fe: i, mac: 1.0 }).collect();
    let strongest =
        (1..12).max_by(|&a, &b| modes.fe.0[a].participation.total_cmp(&modes.fe.0[b].participation)).unwrap();
    modes.lumped.0[strongest].frequency_hz *= 1.03;
    let at = modes.fe.0[strongest].frequency_hz;
    let band = DisagreementBand { from_hz: at, to_hz: at, worst_db: 6.0, worst_at_hz: at };
    let causes = Causes::new(&modes, &rotors, band);
    let responsible = causes.responsible.unwrap();
    assert_eq!((responsible.fe, responsible.lumped), (Some(strongest), Some(strongest)));
    assert!((responsible.share - 1.0).abs() < 1e-12, "pairs that agree cancel: {}", responsible.share);
    assert!((causes.shift.unwrap().percent - 3.0).abs() < 1e-9);
    assert!(causes.unpaired.is_empty());
    assert!(causes.sentences()[1].contains("+3.0 %"), "{:?}", causes.sentences());
    // the same mode without partner wins over all equal pairs
    modes.pairs.retain(|pair| pair.fe != strongest);
    modes.lumped.0.truncate(strongest);
    modes.pairs.retain(|pair| pair.lumped < strongest);
    let alone = Causes::new(&modes, &rotors, band).responsible.unwrap();
    assert_eq!((alone.fe, alone.lumped), (Some(strongest), None));
}

/// Modes that no lumped mode pairs with are said to be missing, whatever is said of the responsible one.
#[test]
fn missing_modes_are_said_to_be_missing() {
    let mut design = read(library::SHIPPED[0].text).design.unwrap();
    design.analysis.frequency_max = 20_000.0;
    let all = causes(ModelKind::Enhanced, &design, 0.3);
    let there = |causes: &Causes| {
        let responsible = causes.responsible.and_then(|responsible| responsible.fe);
        causes.shift.is_some()
            && causes.unpaired.iter().any(|mode| Some(mode.fe) != responsible && mode.participation > 0.05)
    };
    let beside_one_that_is_there: Vec<_> = all.iter().filter(|causes| there(causes)).collect();
    assert!(!beside_one_that_is_there.is_empty());
    for causes in beside_one_that_is_there {
        let said = causes.sentences();
        let missing = said.iter().find(|sentence| sentence.starts_with("Also missing in the enhanced model"));
        let missing = missing.unwrap_or_else(|| panic!("{said:#?}"));
        for mode in causes.unpaired.iter().filter(|mode| mode.participation > 0.05) {
            assert!(missing.contains(&mode.name), "{missing}");
        }
    }
}

/// At the mesh all axial modes of a shaft look alike, so that the MAC of several is 1: the one at the same frequency is the partner.
#[test]
fn of_modes_that_look_alike_the_nearest_is_the_partner() {
    let shipped = library::SHIPPED.iter().find(|shipped| shipped.file_name == "turbine-generator.toml").unwrap();
    let design = read(shipped.text).design.unwrap();
    let rotors = Rotors::new(&design).unwrap();
    let modes = ModalComparison::new(ModelKind::Enhanced, &design, &rotors).unwrap();
    let hz = |modes: &Modes, i: usize| modes.0[i].frequency_hz;
    let axial: Vec<_> =
        modes.pairs.iter().filter(|pair| modes.lumped.0[pair.lumped].name().contains("axial")).collect();
    assert!(axial.len() >= 2);
    for pair in axial {
        let shift = hz(&modes.lumped, pair.lumped) / hz(&modes.fe, pair.fe) - 1.0;
        assert!(shift.abs() < 0.02, "{pair:?}, {} and {} Hz", hz(&modes.lumped, pair.lumped), hz(&modes.fe, pair.fe));
    }
}

/// A reduced model with many modes is not said to lack those that it has.
#[test]
fn high_modes_of_reduced_models_have_partners() {
    let mut design = read(library::SHIPPED[0].text).design.unwrap();
    design.analysis.frequency_max = 40_000.0;
    let rotors = Rotors::new(&design).unwrap();
    let modes = ModalComparison::new(ModelKind::Reduced(12), &design, &rotors).unwrap();
    let all = causes(ModelKind::Reduced(12), &design, 0.02);
    assert!(all.len() > 5);
    for missing in all.iter().flat_map(|causes| &causes.unpaired) {
        let alike = |mode: &&bevelscope::response::Mode| {
            (mode.frequency_hz / missing.frequency_hz - 1.0).abs() < 0.01 && mode.name() == missing.name
        };
        let found = modes.lumped.0.iter().find(alike);
        assert!(found.is_none(), "{} Hz, {}", missing.frequency_hz, missing.name);
    }
}

#[test]
fn speed_of_a_mesh_order() {
    let mut design = ordinary();
    assert_eq!(pinion_speed_rpm(&design, 500.0), None);
    design.pinion.teeth = Some(10);
    // f = N n / 60
    assert_eq!(pinion_speed_rpm(&design, 500.0), Some(3000.0));
}

/// Every peak of a spectrum is a mode: the weak ones too, which a threshold over the strongest of all modes would leave without a name.
#[test]
fn every_peak_has_its_mode() {
    for shipped in library::SHIPPED {
        let design = read(shipped.text).design.unwrap();
        let rotors = Rotors::new(&design).unwrap();
        let lines = frequency_lines(&design.analysis);
        let modes = ModalComparison::new(ModelKind::Enhanced, &design, &rotors).unwrap();
        let parts = Parts::of_mesh(&modes);
        for (kind, of) in [(ModelKind::Fe, &modes.fe), (ModelKind::Enhanced, &modes.lumped)] {
            let force = solve(kind, &design, &rotors, &lines).unwrap().mesh_force;
            let mut named = Vec::new();
            for peak in peaks(&lines, &force) {
                let mode = modes.behind_peak(&parts, kind != ModelKind::Fe, peak.frequency_hz, &lines);
                let mode = mode.unwrap_or_else(|| panic!("{}: {kind:?} {peak:?}", shipped.file_name));
                assert!(of.0.contains(mode));
                // no mode makes two peaks
                assert!(!named.contains(&mode.frequency_hz.to_bits()), "{}: {kind:?} {peak:?}", shipped.file_name);
                named.push(mode.frequency_hz.to_bits());
            }
            assert!(named.len() > 1);
        }
        assert!(modes.behind_peak(&parts, false, 1e7, &[]).is_none());
    }
}
