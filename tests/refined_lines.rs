//! Lines added near resonances, held against brute force.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod support;

use bevelscope::agreement::peaks;
use bevelscope::design::{Design, library, read};
use bevelscope::model::{Model, ModelKind, Rotors};
use bevelscope::response::{Solved, refined_lines};
use proptest::prelude::*;
use support::random::{config, designs};

/// Every peak (and antiresonance) of 3 dB prominence on a fine grid has a refined line within 0.1 % in frequency and in height.
fn check(design: &Design, kind: ModelKind, grid: usize) -> Result<usize, TestCaseError> {
    let rotors = Rotors::new(design).unwrap();
    let model = Model::new(kind, design, &rotors).unwrap();
    let (low, high) = (design.analysis.frequency_min, design.analysis.frequency_max);
    let solved = Solved::new(model).unwrap();
    let refined = refined_lines(&solved, &solved.compliance(), solved.frequencies(), [low, high]);
    prop_assert!(refined.is_sorted() && refined.iter().all(|f| *f > low && *f < high));
    prop_assert!(refined.len() <= 7 * 2 * solved.model.coordinates(), "{} lines", refined.len());
    let fine: Vec<f64> = (0..grid).map(|i| low * (high / low).powf(i as f64 / (grid - 1) as f64)).collect();
    let force = solved.spectrum(&fine).unwrap().mesh_force;
    let at_refined = solved.spectrum(&refined).unwrap().mesh_force;
    let turned: Vec<_> = force.iter().map(|f| 1.0 / f).collect();
    let mut found = 0;
    for (what, spectrum, upside_down) in [("peak", &force, false), ("antiresonance", &turned, true)] {
        for peak in peaks(&fine, spectrum) {
            // where damping is so low that even the fine grid misses the top, the refined line is higher
            let i = fine.partition_point(|f| *f < peak.frequency_hz);
            let beside = |j: usize| (spectrum[j].norm() / spectrum[i].norm() - 1.0).abs();
            let resolved = beside(i - 1).max(beside(i + 1)) < 1e-3;
            let near = refined.iter().zip(&at_refined).any(|(f, force)| {
                let level = 20.0 * force.norm().log10() * if upside_down { -1.0 } else { 1.0 };
                let height = 10_f64.powf((level - peak.level_db) / 20.0) - 1.0;
                (f / peak.frequency_hz - 1.0).abs() < 1e-3 && height > -1e-3 && (height < 1e-3 || !resolved)
            });
            prop_assert!(near, "{kind:?}: {what} at {} Hz, {} dB", peak.frequency_hz, peak.level_db);
            found += 1;
        }
    }
    Ok(found)
}

#[test]
fn peaks_of_shipped_designs_are_those_of_a_million_lines() {
    for shipped in library::SHIPPED {
        let design = read(shipped.text).design.unwrap();
        for kind in ModelKind::ALL {
            let found = check(&design, kind, 1_000_000).unwrap();
            println!("{} {}: {found}", shipped.file_name, kind.name());
            assert!(found > 4);
        }
    }
}

proptest! {
    #![proptest_config(config(40))]

    #[test]
    fn no_peak_of_a_random_design_is_missed(design in designs()) {
        for kind in [ModelKind::Fe, ModelKind::Enhanced] {
            check(&design, kind, 100_000)?;
        }
    }
}
