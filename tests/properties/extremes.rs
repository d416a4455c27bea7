//! Numbers anywhere in the range of a double.

use crate::support::random::{config, designs};
use bevelscope::design::{BearingModel, Design};
use proptest::prelude::*;

proptest! {
    #![proptest_config(config(150))]

    /// Several numbers at once anywhere in the range of a double.
    #[test]
    fn extreme_numbers_give_figures_or_errors(
        design in designs(),
        changes in proptest::collection::vec((any::<prop::sample::Index>(), -308_i32..308), 1..4),
    ) {
        let mut design = design;
        design.analysis.frequency_lines = 3;
        for (which, exponent) in changes {
            let mut numbers = numbers(&mut design);
            let which = which.index(numbers.len());
            *numbers[which] = 10_f64.powi(exponent);
        }
        // an error with a name is as good
        let _ = crate::support::nonsense::assert_no_nonsense("extreme", &design);
    }
}

/// Every number of a design that may be any positive value.
fn numbers(design: &mut Design) -> Vec<&mut f64> {
    let Design { analysis, materials, mesh, pinion, gear, .. } = design;
    let mut out = vec![
        &mut analysis.structural_damping,
        &mut mesh.stiffness,
        &mut mesh.damping,
        &mut mesh.transmission_error,
        &mut mesh.pinion.point[0],
        &mut mesh.gear.point[2],
    ];
    for material in materials.values_mut() {
        out.extend([&mut material.youngs_modulus, &mut material.density]);
    }
    for rotor in [pinion, gear] {
        out.extend(
            rotor.drive.as_mut().into_iter().flat_map(|drive| [&mut drive.torsional_stiffness, &mut drive.inertia]),
        );
        out.extend(&mut rotor.housing_axial_stiffness);
        for body in &mut rotor.bodies {
            out.extend([&mut body.mass, &mut body.diametral_inertia, &mut body.polar_inertia]);
        }
        for segment in &mut rotor.segments {
            // a scale of the section: the bore stays inside
            if segment.inner_diameter == 0.0 {
                out.push(&mut segment.outer_diameter);
            }
        }
        for bearing in &mut rotor.bearings {
            out.extend(&mut bearing.axial_series_stiffness);
            match &mut bearing.model {
                BearingModel::Diagonal(k) => out.extend([&mut k.kx, &mut k.ky, &mut k.kz, &mut k.krx, &mut k.krz]),
                // one entry alone would not leave a matrix positive definite
                BearingModel::Matrix(_) | BearingModel::Rigid(_) | BearingModel::Ball(_) | BearingModel::Roller(_) => {}
            }
        }
    }
    out
}
