//! Geared turbine-generator: Friswell, Penny, Garvey and Lees, *Dynamics of Rotating Machinery* (2010), after Rao, Shiau and Chang (1998); the
//! shipped design of that name.
//!
//! At rest, natural frequencies as the documentation of ROSS prints them (`two_shaft_rotor_example`, `run_modal(speed=0)`), whole rad/s: 74, 77,
//! 112, 113. At 1500 rpm the book's are 11.641, 12.284, 17.268, 18.458, 23.956, 37.681, 49.889, 50.861, 56.248, 57.752, 59.188, 63.113 and
//! 74.203 Hz; gyroscopic moments, which a model at rest does not have, hardly move the modes of torsion and those of the turbine alone.

use bevelscope::design::{library, read};
use bevelscope::model::{Model, ModelKind, Rotors};
use bevelscope::response::Modes;

#[test]
fn frequencies_at_rest_and_those_that_speed_leaves_alone() {
    let shipped = library::SHIPPED.iter().find(|shipped| shipped.file_name == "turbine-generator.toml").unwrap();
    let design = read(shipped.text).design.unwrap();
    let model = Model::new(ModelKind::Fe, &design, &Rotors::new(&design).unwrap()).unwrap();
    let modes = Modes::new(&model, 30).unwrap();
    // the axial supports are added to the source's data
    let across = modes.0.iter().filter(|mode| mode.frequency_hz > 1.0 && mode.pinion.axial + mode.gear.axial < 0.5);
    let found: Vec<f64> = across.map(|mode| mode.frequency_hz).collect();
    for (hz, printed) in found.iter().zip([74.0, 77.0, 112.0, 113.0]) {
        assert!((hz * std::f64::consts::TAU - printed).abs() < 0.5, "{hz} Hz is not {printed} rad/s");
    }
    for printed in [23.956, 37.681, 50.861, 63.113, 74.203] {
        let nearest = found.iter().map(|hz| (hz / printed - 1.0).abs()).fold(f64::INFINITY, f64::min);
        assert!(nearest < 1e-3, "{printed} Hz: off by {nearest:e}: {found:?}");
    }
}
