//! The schema says all that the file format has, and the structs hold what it says.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use std::fs;

use bevelscope::design::library::SHIPPED;
use bevelscope::design::schema::{Field, ROOT, Table};
use bevelscope::design::{BeamTheory, BearingModel, DampingModel, FrequencySpacing, Hold, MAX_STATIONS, read};

fn fields() -> Vec<(&'static Table, &'static Field)> {
    ROOT.walk().into_iter().flat_map(|table| table.fields.iter().map(move |field| (table, field))).collect()
}

// Counted by hand in the description of the format.
#[test]
fn tables_and_fields_are_counted() {
    let counts: Vec<(&str, usize)> = ROOT.walk().iter().map(|table| (table.name, table.fields.len())).collect();
    let expected = [
        ("design", 12),
        ("analysis", 7),
        ("material", 3),
        ("operating", 2),
        ("mesh", 6),
        ("rotor", 7),
        ("mesh side", 2),
        ("mesh geometry", 17),
        ("segment", 5),
        ("body", 5),
        ("bearing", 4),
        ("drive", 3),
        ("diagonal bearing", 5),
        ("matrix bearing", 1),
        ("rigid bearing", 1),
        ("ball bearing", 14),
        ("roller bearing", 10),
        ("displacement", 5),
        ("preload", 3),
    ];
    assert_eq!(counts, expected);
}

// The keys of the format, one line a table.
#[test]
fn every_key_of_the_format_is_there() {
    for (table, keys) in [
        ("design", "format name description tags parent note analysis material mesh operating pinion gear"),
        (
            "analysis",
            "frequency_min_hz frequency_max_hz frequency_lines frequency_spacing structural_damping damping_model beam_theory",
        ),
        ("material", "youngs_modulus_gpa poissons_ratio density_kg_per_m3"),
        ("mesh", "stiffness_n_per_m damping transmission_error_um pinion gear geometry"),
        ("mesh side", "point_mm line_of_action"),
        ("rotor", "teeth mesh_position_mm housing_axial_stiffness_n_per_m segment body bearing drive"),
        ("segment", "length_mm outer_diameter_mm inner_diameter_mm material elements"),
        ("body", "name position_mm mass_kg diametral_inertia_kg_m2 polar_inertia_kg_m2"),
        ("bearing", "name position_mm axial_series_stiffness_n_per_m model"),
        ("diagonal bearing", "kx_n_per_m ky_n_per_m kz_n_per_m krx_n_m_per_rad krz_n_m_per_rad"),
        ("matrix bearing", "stiffness"),
        ("rigid bearing", "hold"),
        (
            "ball bearing",
            "elements contact_angle_deg clearance_mm contact_stiffness_n_per_m_1_5 groove_distance_mm pitch_radius_mm ball_diameter_mm \
             pitch_diameter_mm inner_groove_factor outer_groove_factor displacement preload mean_load mounting_preload_um",
        ),
        (
            "roller bearing",
            "elements contact_angle_deg clearance_mm pitch_radius_mm contact_stiffness_n_per_m_10_9 roller_length_mm displacement preload \
             mean_load mounting_preload_um",
        ),
        ("displacement", "x_um y_um z_um rx_mrad rz_mrad"),
        ("preload", "x_n y_n z_n"),
        ("operating", "pinion_torque_n_m pinion_speed_rpm"),
        (
            "mesh geometry",
            "kind pressure_angle_deg hand pinion_turns pinion_azimuth_deg gear_azimuth_deg pinion_pitch_angle_deg gear_pitch_angle_deg \
             pinion_mean_cone_distance_mm gear_mean_cone_distance_mm pinion_spiral_angle_deg gear_spiral_angle_deg pinion_apex_mm \
             gear_apex_mm pinion_pitch_diameter_mm gear_pitch_diameter_mm helix_angle_deg",
        ),
        ("drive", "position_mm torsional_stiffness_n_m_per_rad inertia_kg_m2"),
    ] {
        let table = ROOT.walk().into_iter().find(|t| t.name == table).unwrap();
        let mut expected: Vec<&str> = keys.split(' ').collect();
        let mut keys: Vec<&str> = table.fields.iter().map(|field| field.key).collect();
        expected.sort_unstable();
        keys.sort_unstable();
        assert_eq!(keys, expected, "{}", table.name);
    }
}

#[test]
fn every_field_has_its_unit_in_its_key_and_a_line_about_it() {
    for (table, field) in fields() {
        let unit = field.quantity().map_or("", |quantity| quantity.suffix());
        assert!(field.key.ends_with(unit), "{}.{}", table.name, field.key);
        assert!(field.doc.ends_with('.') && field.doc.len() >= "Mass.".len(), "{}.{}", table.name, field.key);
        let is_twice = table.fields.iter().filter(|other| other.key == field.key).count() > 1;
        assert!(!is_twice, "{}.{}", table.name, field.key);
        assert_eq!(field.name.is_empty(), field.key == "format", "{}", field.key);
    }
}

#[test]
fn the_words_are_those_of_the_format() {
    assert_eq!(FrequencySpacing::WORDS, ["linear", "log"]);
    assert_eq!(DampingModel::WORDS, ["hysteretic", "viscous"]);
    assert_eq!(BeamTheory::WORDS, ["euler-bernoulli", "timoshenko"]);
    assert_eq!(Hold::WORDS, ["x", "y", "z"]);
    let models: Vec<&str> = BearingModel::VARIANTS.iter().map(|variant| variant.word).collect();
    assert_eq!(models, ["diagonal", "matrix", "rigid", "ball", "roller"]);
    assert_eq!(BeamTheory::EulerBernoulli.word(), "euler-bernoulli");
    assert_eq!(MAX_STATIONS, 400);
}

fn small() -> String {
    fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/valid/small.toml")).unwrap()
}

// The defaults of the format.
#[test]
#[expect(clippy::float_cmp, reason = "the conversions are exact")]
fn what_is_not_written_has_the_default_of_the_format() {
    let design = read(&small()).design.unwrap();
    let analysis = &design.analysis;
    assert_eq!((analysis.frequency_min, analysis.frequency_max, analysis.frequency_lines), (10.0, 5000.0, 1000));
    assert_eq!(analysis.structural_damping, 0.03);
    assert_eq!(analysis.frequency_spacing, FrequencySpacing::Linear);
    assert_eq!(analysis.damping_model, DampingModel::Hysteretic);
    assert_eq!(analysis.beam_theory, BeamTheory::Timoshenko);
    let steel = design.materials["steel"];
    assert_eq!((steel.youngs_modulus, steel.poissons_ratio, steel.density), (206e9, 0.3, 7850.0));
    let segment = &design.gear.segments[0];
    assert_eq!((segment.inner_diameter, segment.elements, segment.material.as_str()), (0.0, 1, "steel"));
    assert_eq!((design.tags.len(), design.description, design.parent, design.note), (0, None, None, None));
    assert_eq!((design.pinion.teeth, design.pinion.housing_axial_stiffness), (None, None));
    let names: Vec<&str> = design.gear.bearings.iter().map(|bearing| bearing.name.as_str()).collect();
    assert_eq!(names, ["B1", "B2"]);
    assert_eq!(design.pinion.bodies[0].name, "body 1");
    let BearingModel::Diagonal(springs) = design.gear.bearings[0].model else { panic!("diagonal is the default") };
    assert_eq!((springs.kx, springs.ky, springs.kz, springs.krx, springs.krz), (0.0, 2e8, 0.0, 0.0, 0.0));
    assert_eq!(design.gear.bearings[0].axial_series_stiffness, None);
}

// The values of the file, in SI units.
#[test]
#[expect(clippy::float_cmp, reason = "the conversions are exact")]
fn values_come_out_in_si_units() {
    let design = read(SHIPPED[0].text).design.unwrap();
    assert_eq!((design.mesh.stiffness, design.mesh.transmission_error), (6.4e8, 5e-6));
    assert_eq!(design.mesh.pinion.point, [0.0, 0.0, 27.4595 / 1e3]);
    assert_eq!(design.pinion.mesh_position, 0.018);
    assert_eq!((design.pinion.segments[0].length, design.pinion.segments[0].outer_diameter), (0.036, 0.044));
    assert_eq!(design.pinion.bearings[1].axial_series_stiffness, Some(9e8));
    assert!((design.pinion.length() - 0.17).abs() < 1e-15);
    for side in [design.mesh.pinion, design.mesh.gear] {
        let length: f64 = side.line_of_action.iter().map(|component| component * component).sum();
        assert!((length - 1.0).abs() < 1e-15);
    }
}

#[test]
fn steel_is_changed_key_by_key() {
    let text = small().replace("[mesh]", "[material.steel]\ndensity_kg_per_m3 = 7800\n[mesh]");
    let steel = read(&text).design.unwrap().materials["steel"];
    assert!((steel.youngs_modulus - 206e9).abs() < 1.0 && (steel.density - 7800.0).abs() < 1e-9);
}

#[test]
fn a_matrix_is_made_exactly_symmetric() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/fixtures/valid/matrix.toml");
    let design = read(&fs::read_to_string(file).unwrap()).design.unwrap();
    let BearingModel::Matrix(matrix) = design.pinion.bearings[0].model else { panic!("a matrix") };
    for (i, j) in (0..6).flat_map(|i| (0..6).map(move |j| (i, j))) {
        assert_eq!(matrix[i][j].to_bits(), matrix[j][i].to_bits());
    }
    // the mean of 1e7 and 1.00005e7
    assert!((matrix[0][1] - 10_000_250.0).abs() < 1e-6);
}

/// `UPDATE=1 cargo test --test design_schema` writes the page anew.
#[test]
fn the_reference_page_is_that_of_the_schema() {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/docs/design-file.md");
    let page = bevelscope::design::reference::page();
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(path, &page).unwrap();
    }
    assert!(std::fs::read_to_string(path).unwrap() == page, "docs/design-file.md is not what the schema says");
}
