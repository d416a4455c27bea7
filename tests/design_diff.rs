//! Differences of two designs by key path, and totals of rotors.

#![allow(clippy::unwrap_used, clippy::panic, reason = "a test may")]

use bevelscope::design::library::SHIPPED;
use bevelscope::design::{Difference, Edit, Editor, KeyPath, Side, Spelled, Totals, Towards, diff, read};
use bevelscope::rotor::Rotor;

fn path(text: &str) -> KeyPath {
    text.parse().unwrap()
}

/// `path: a -> b unit`, one a line.
fn shown(differences: &[Difference]) -> Vec<String> {
    let side = |value: &Option<String>| value.clone().unwrap_or_else(|| "-".into());
    let line =
        |d: &Difference| format!("{}: {} -> {} {}", d.path, side(&d.a), side(&d.b), d.unit).trim_end().to_owned();
    differences.iter().map(line).collect()
}

fn edited(text: &str, edits: &[Edit]) -> String {
    let mut editor = Editor::new(text).unwrap();
    for edit in edits {
        editor.apply(edit).unwrap();
    }
    editor.text().to_owned()
}

fn set(at: &str, value: &str) -> Edit {
    Edit::Set { path: path(at), value: Spelled::parse(value).unwrap() }
}

#[test]
fn every_value_that_differs_is_listed_by_its_path() {
    let a = SHIPPED[0].text;
    let b = edited(
        a,
        &[
            set("name", "'other'"),
            set("tags", "['case-b']"),
            set("analysis.frequency_max_hz", "5e3"),
            set("material.steel.density_kg_per_m3", "7800"),
            set("mesh.pinion.point_mm[2]", "27.5"),
            set("pinion.segment[2].outer_diameter_mm", "37"),
            set("pinion.bearing[tail bearing].ky_n_per_m", "2e8"),
            Edit::SetModel { bearing: path("gear.bearing[0]"), model: "rigid".into() },
            Edit::DeleteRow { row: path("gear.body[differential]") },
            Edit::InsertRow { list: path("pinion.segment"), place: 4 },
        ],
    );
    let differences = diff(a, &b);
    let expected = [
        "name: Both overhung, elastic bearings -> other",
        "tags: case-b, spiral bevel, 14/39 -> case-b",
        "analysis.frequency_max_hz: 4000.0 -> 5e3 Hz",
        "material.steel.density_kg_per_m3: 7850.0 -> 7800 kg/m^3",
        "mesh.pinion.point_mm[2]: 27.4595 -> 27.5 mm",
        "pinion.segment[2].outer_diameter_mm: 36.0 -> 37 mm",
        "pinion.segment[4]: - -> row",
        "pinion.bearing[tail bearing].ky_n_per_m: 1.8e8 -> 2e8 N/m",
        "gear.body[differential]: row -> -",
        "gear.bearing[B1].model: diagonal -> rigid",
        "gear.bearing[B1].kx_n_per_m: 7.0e8 -> - N/m",
        "gear.bearing[B1].ky_n_per_m: 2.2e8 -> - N/m",
        "gear.bearing[B1].kz_n_per_m: 7.0e8 -> - N/m",
        "gear.bearing[B1].krx_n_m_per_rad: 2.0e5 -> - N m/rad",
        "gear.bearing[B1].krz_n_m_per_rad: 2.0e5 -> - N m/rad",
        "gear.bearing[B1].hold: - -> x, y, z",
    ];
    assert_eq!(shown(&differences), expected);
    let label = |at: &str| differences.iter().find(|d| d.path.to_string() == at).unwrap().label.clone();
    assert_eq!(label("pinion.segment[2].outer_diameter_mm"), "outer diameter of pinion segment 3");
    assert_eq!(label("pinion.bearing[tail bearing].ky_n_per_m"), "ky of pinion bearing tail bearing");
    assert_eq!(label("gear.body[differential]"), "gear body differential");
}

#[test]
fn spelling_order_of_named_rows_and_written_defaults_are_no_differences() {
    let a = SHIPPED[0].text;
    assert_eq!(diff(a, a), []);
    let b = edited(
        a,
        &[
            set("pinion.bearing[0].kx_n_per_m", "600_000_000"),
            set("pinion.segment[0].material", "'steel'"),
            set("material.steel.poissons_ratio", "0.30"),
            Edit::MoveRow { row: path("gear.body[0]"), towards: Towards::End },
            Edit::MoveRow { row: path("gear.bearing[0]"), towards: Towards::End },
            Edit::Remove { path: path("pinion.segment[1].inner_diameter_mm") },
        ],
    );
    assert_ne!(a, b);
    assert_eq!(shown(&diff(a, &b)), [""; 0]);
}

#[test]
fn a_matrix_is_listed_once_for_both_halves() {
    let a = edited(SHIPPED[0].text, &[Edit::SetModel { bearing: path("pinion.bearing[0]"), model: "matrix".into() }]);
    let b = edited(&a, &[set("pinion.bearing[0].stiffness[0][5]", "-1e6")]);
    assert_eq!(shown(&diff(&a, &b)), ["pinion.bearing[head bearing].stiffness[0][5]: 0.0 -> -1e6 N/rad"]);
    // within the tolerance, one half may stand alone
    let c = a.replacen("[0.0, 2.5e8", "[0.5, 2.5e8", 1);
    assert_ne!(a, c);
    assert_eq!(shown(&diff(&a, &c)), ["pinion.bearing[head bearing].stiffness[1][0]: 0.0 -> 0.5 N/m"]);
}

#[test]
fn rows_are_compared_with_the_rows_that_they_are() {
    let a = SHIPPED[0].text;
    // a segment more, a copy of the first, moves all others
    let b = edited(
        a,
        &[
            Edit::InsertRow { list: path("pinion.segment"), place: 0 },
            set("pinion.segment[3].outer_diameter_mm", "37"),
            Edit::DeleteRow { row: path("pinion.segment[4]") },
        ],
    );
    let found = diff(a, &b);
    let expected = [
        "pinion.segment[1]: - -> row",
        "pinion.segment[2].outer_diameter_mm: 36.0 -> 37 mm",
        "pinion.segment[3]: row -> -",
    ];
    assert_eq!(shown(&found), expected);
    assert_eq!(found.iter().map(Difference::shown).map(|[_, b]| b).collect::<Vec<_>>(), ["added", "37", "removed"]);
    assert_eq!(found[1].path_in_b.to_string(), "pinion.segment[3].outer_diameter_mm");
    assert_eq!(found[1].label_in_b, "outer diameter of pinion segment 4");
    // nothing but the name
    let b = edited(a, &[set("pinion.bearing[0].name", "'front'")]);
    let found = diff(a, &b);
    assert_eq!(shown(&found), ["pinion.bearing[head bearing].name: head bearing -> front"]);
    assert_eq!(found[0].path_in_b.to_string(), "pinion.bearing[front].name");
    let b = edited(&b, &[set("pinion.bearing[0].kx_n_per_m", "1e8")]);
    assert_eq!(shown(&diff(a, &b)), ["pinion.bearing[head bearing]: row -> -", "pinion.bearing[front]: - -> row"]);
    let a = edited(a, &[Edit::AddMaterial { name: "bronze".into() }]);
    let b = edited(&a, &[Edit::RenameMaterial { from: "bronze".into(), to: "brass".into() }]);
    assert_eq!(shown(&diff(&a, &b)), ["material.bronze: bronze -> brass"]);
}

#[test]
fn many_rows_are_compared_in_no_time_and_by_place() {
    let segment = |length: usize| format!("[[pinion.segment]]\nlength_mm = {length}.0\n");
    let text = |from: usize| (from..from + 2000).map(segment).collect::<String>();
    // all differ: 4 million combinations are not tried
    assert_eq!(diff(&text(1), &text(5001)).len(), 2000);
    // one more is found among any number
    assert_eq!(diff(&text(1), &format!("{}{}", segment(7000), text(1))).len(), 1);
}

// There and back is the same list with the sides swapped.
#[test]
fn sides_are_swapped_when_designs_are() {
    for a in SHIPPED {
        for b in SHIPPED {
            let sorted = |mut list: Vec<Difference>| {
                list.sort_by_key(|d| d.path.to_string());
                list
            };
            let there = sorted(diff(a.text, b.text));
            let back = sorted(diff(b.text, a.text));
            let swapped = |mut d: Difference| {
                d.swap();
                d
            };
            assert_eq!(sorted(there.into_iter().map(swapped).collect()), back);
            assert_eq!(back.is_empty(), a == b);
        }
    }
    assert_eq!(diff("a = ", "b = [").len(), 0);
}

// The mass of the shaft and the bodies is that of the stations; the length that of the last one.
#[test]
fn totals_are_those_of_the_rotor() {
    for shipped in SHIPPED {
        let design = read(shipped.text).design.unwrap();
        for side in Side::BOTH {
            let totals = Totals::of(&design, side);
            let rotor = Rotor::new(&design, side).unwrap();
            assert!((totals.mass() / rotor.totals.mass - 1.0).abs() < 1e-12);
            let end = rotor.stations.positions.last().unwrap();
            assert!((totals.length - end).abs() < 1e-12);
            assert!(totals.shaft_mass > 0.0 && totals.bodies_mass > 0.0);
        }
    }
}
