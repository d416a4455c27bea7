//! Whatever a design says, what comes out is a number or an error with a name.

use bevelscope::comparison::{SolveError, compare};
use bevelscope::design::Design;
use bevelscope::model::{Model, ModelKind, Rotors};
use bevelscope::response::{Modes, direct_spectrum, frequency_lines};
use bevelscope::rotor::Bending;

/// Solves everything there is of a design; a figure that is no number is a failure, an error must have a name.
#[track_caller]
pub fn assert_no_nonsense(what: &str, design: &Design) -> Result<(), String> {
    let named = |error: &SolveError| {
        let message = error.to_string();
        // a sentence a shaft
        for sentence in message.split("; gear shaft: ") {
            assert!((20..200).contains(&sentence.len()) && !sentence.contains("NaN"), "{what}: {message}");
        }
        message
    };
    let comparison = match compare(design) {
        Ok(comparison) => comparison,
        Err(error) => return Err(named(&error)),
    };
    for spectrum in [&comparison.fe, &comparison.enhanced, &comparison.basic] {
        for value in spectrum.mesh_force.iter().chain(&spectrum.transmission_error) {
            assert!(value.is_finite(), "{what}: {value}");
        }
    }
    for agreement in [&comparison.enhanced_agreement, &comparison.basic_agreement] {
        let figures =
            [agreement.rms_db, agreement.max_db, agreement.max_at_hz, agreement.frac, agreement.agreement_limit_hz];
        assert!(figures.iter().all(|figure| figure.is_finite()), "{what}: {figures:?}");
        assert!(agreement.frac <= 1.0 + 1e-9, "{what}: {}", agreement.frac);
    }
    let rotors = Rotors::new(design).unwrap();
    for rotor in [&rotors.pinion, &rotors.gear] {
        let figures = |b: &Bending| [b.frequency, b.mass, b.inertia, b.energy_residual];
        for bending in [&rotor.bending_x, &rotor.bending_z] {
            assert!(figures(bending).iter().all(|figure| figure.is_finite()), "{what}: {bending:?}");
            assert!(bending.mass > 0.0 && bending.inertia > 0.0 && bending.frequency > 0.0, "{what}: {bending:?}");
        }
        let totals = [rotor.totals.mass, rotor.totals.polar_inertia, rotor.totals.diametral_inertia];
        assert!(totals.iter().all(|figure| figure.is_finite() && *figure > 0.0), "{what}: {totals:?}");
    }
    for kind in ModelKind::ALL {
        let model = Model::new(kind, design, &rotors).unwrap();
        if let Ok(modes) = Modes::new(&model, 20) {
            for mode in modes.0 {
                let shares = [mode.pinion, mode.gear].map(|s| s.lateral + s.axial + s.tilt + s.torsion);
                assert!(mode.frequency_hz.is_finite(), "{what} {kind:?}: {}", mode.frequency_hz);
                assert!((shares[0] + shares[1] - 1.0).abs() < 1e-6, "{what} {kind:?}: {shares:?}");
            }
        }
        if let Ok(direct) = direct_spectrum(&model, &frequency_lines(&design.analysis)) {
            assert!(direct.mesh_force.iter().all(|value| value.is_finite()), "{what} {kind:?}");
        }
    }
    Ok(())
}
