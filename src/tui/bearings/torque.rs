//! The torque, in steps that stay readable.

use crate::design::grid::Sheet;
use crate::design::{Design, Edit, KeyPath, Spelled};
use crate::number::significant;
use crate::tui::editor::Editing;

/// A part of the torque that a step is at most.
pub(super) const STEP: f64 = 0.05;
pub(super) const LARGE_STEP: f64 = 0.25;

/// Torque of the pinion, N m.
pub fn torque(design: &Design) -> Option<f64> {
    design.operating.and_then(|operating| operating.pinion_torque)
}

/// A torque (N m) in figures, as short as it is.
pub fn shown_torque(torque: f64) -> String {
    let plain = torque.to_string();
    if plain.len() <= 9 { plain } else { significant(torque, 6) }
}

/// The next value above (`up`) or below, so that the values stay multiples of 1, 2 or 5 times a power of ten that are at most
/// `part` of them; steps up and down meet the same values. From 0 the first step is 1.
pub fn stepped(value: f64, up: bool, part: f64) -> f64 {
    // a value on the edge of two steps goes down with the smaller one
    const NEAR: f64 = 1e-9;
    let size = value.abs();
    if size == 0.0 {
        return if up { 1.0 } else { 0.0 };
    }
    let step = nice_below(part * size * if up { 1.0 + NEAR } else { 1.0 - NEAR });
    let count = size / step;
    let count = if up { (count * (1.0 + NEAR)).floor() + 1.0 } else { (count * (1.0 - NEAR)).ceil() - 1.0 };
    // without the digits that rounding has left
    let stepped = format!("{:.12e}", count * step).parse().unwrap_or(size);
    if f64::is_finite(stepped) && stepped > 0.0 { f64::copysign(stepped, value) } else { value }
}

/// The greatest of 1, 2 and 5 times a power of ten that is not above a value.
fn nice_below(value: f64) -> f64 {
    let power = 10_f64.powf(value.log10().floor());
    [5.0, 2.0, 1.0].into_iter().map(|times| times * power).find(|nice| *nice <= value).unwrap_or(power)
}

/// The key that the torque stands under.
fn path() -> KeyPath {
    KeyPath::root().key("operating").key("pinion_torque_n_m")
}

/// The edit that gives the pinion another torque, N m.
pub(super) fn edit(torque: f64) -> Option<Edit> {
    Spelled::parse(&format!("{torque:?}")).map(|value| Edit::Set { path: path(), value })
}

/// What was typed as a torque, as an edit.
pub(super) fn typed(editing: &Editing, text: &str) -> Result<Edit, String> {
    let grid = editing.editor.grid(&Sheet::operating());
    let cell = grid.cell(&path()).ok_or("a design has no place for a torque")?;
    Edit::from_typed(cell, text).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn steps_are_round() {
        let up = [300.0, 310.0, 320.0];
        for pair in up.windows(2) {
            assert_eq!((stepped(pair[0], true, STEP), stepped(pair[1], false, STEP)), (pair[1], pair[0]));
        }
        assert_eq!((stepped(300.0, true, LARGE_STEP), stepped(350.0, false, LARGE_STEP)), (350.0, 300.0));
        assert_eq!((stepped(100.0, true, STEP), stepped(100.0, false, STEP)), (105.0, 98.0));
        assert_eq!((stepped(0.0, true, STEP), stepped(0.0, false, STEP)), (1.0, 0.0));
        // what was typed goes to the next round value
        assert_eq!((stepped(303.7, true, STEP), stepped(303.7, false, STEP)), (310.0, 300.0));
        assert_eq!((stepped(-300.0, true, STEP), stepped(-300.0, false, STEP)), (-310.0, -290.0));
    }

    proptest! {
        #[test]
        fn a_step_is_small_and_is_taken_back(exponent in -6.0..9.0_f64, part in prop::sample::select(vec![STEP, LARGE_STEP])) {
            let value = 10_f64.powf(exponent);
            let on = stepped(value, true, part);
            prop_assert!(on > value && on <= value * (1.0 + part) * (1.0 + 1e-6), "{value} {on}");
            let next = stepped(on, true, part);
            prop_assert_eq!(stepped(next, false, part), on);
            prop_assert!(stepped(value, false, part) < value);
        }
    }
}
