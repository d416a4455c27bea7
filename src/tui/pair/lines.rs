//! The numbers of the pair, a line each.

use super::Shown;
use crate::design::{Hand, Side, Turns};
use crate::gear::Force;
use crate::number::significant;
use crate::pair::ShaftFigures;
use crate::units::Quantity;

/// A line beside the picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Line {
    /// What it is, the value of the pinion, that of the gear, their unit
    Both(&'static str, [String; 2], &'static str),
    /// One for the pair
    Single(String),
    /// What something means
    Note(String),
}

/// All lines, the forces first.
pub fn lines(shown: &Shown) -> Vec<Line> {
    let figures = &shown.figures;
    let sides = Side::BOTH.map(|side| figures.shaft(side));
    let both = |value: &dyn Fn(&ShaftFigures) -> String| sides.map(value);
    let force = |component: fn(&Force) -> f64| {
        both(&|shaft| shaft.force.as_ref().map_or("-".into(), |force| signed(component(force), 5)))
    };
    let mut lines = vec![
        Line::Both("axial force", force(|force| force.axial), "N"),
        Line::Both("radial force", force(|force| force.radial), "N"),
        Line::Both("tangential", force(|force| force.tangential), "N"),
        Line::Note(
            if figures.has_cones() { "axial +: away from the apex" } else { "axial +: along the shaft's +y" }.into(),
        ),
        Line::Note("radial +: towards its own axis".into()),
        Line::Note("tangential +: turns it about its +y".into()),
    ];
    lines.push(match (figures.normal_force, figures.torque) {
        (None, _) => Line::Single("no force: the line meets the axis".into()),
        (Some(force), Some(torque)) => {
            Line::Single(format!("normal {} N at {} N m", significant(force, 6), significant(torque, 5)))
        }
        (Some(force), None) => {
            Line::Single(format!("no torque written: forces at 1 N m, normal {} N", significant(force, 5)))
        }
    });
    if figures.torque.is_some_and(|torque| torque < 0.0) {
        lines.push(Line::Note("the sign of the torque does not count: pinion_turns chooses the flank".into()));
    }
    lines.push(Line::Both("torque arm", both(&|shaft| signed(shaft.torque_arm * 1e3, 5)), "mm"));
    lines.push(match &figures.arms {
        Some(arms) => {
            let [pinion, gear] = arms.teeth;
            let ratio = significant(arms.ratio, 4);
            Line::Single(format!("arms 1:{ratio}, teeth {pinion}:{gear}, {}", arms.deviation()))
        }
        None => Line::Single("arms against teeth: no teeth written".into()),
    });
    if let Some(pair) = &figures.pair {
        let [angle, offset] = [pair.shaft_angle.to_degrees(), pair.offset * 1e3];
        let offset = if pair.is_offset() { significant(offset, 5) } else { "0".into() };
        lines.push(Line::Single(format!("shaft angle {} deg", significant(angle, 5))));
        let name = if figures.has_cones() { "offset" } else { "centre distance" };
        lines.push(Line::Single(format!("{name} {offset} mm")));
    }
    for (at, name) in ["mesh point x", "           y", "           z"].into_iter().enumerate() {
        lines.push(Line::Both(name, both(&|shaft| fixed(shaft.vectors.point[at] * 1e3, 3)), "mm"));
    }
    for (at, name) in ["line x", "     y", "     z"].into_iter().enumerate() {
        lines.push(Line::Both(name, both(&|shaft| fixed(shaft.vectors.line_of_action[at], 5)), ""));
    }
    lines.push(Line::Note(
        "point: from the mesh station; line of action: the force on the gear; each in its shaft's frame".into(),
    ));
    lines.push(match figures.mesh_frequency {
        Some(hz) => Line::Single(format!("mesh frequency {} Hz", significant(hz, 5))),
        None => Line::Single("mesh frequency: no speed or no teeth".into()),
    });
    let stiffness = significant(shown.design.mesh.stiffness, 4);
    lines.push(Line::Single(format!("mesh stiffness {stiffness} {}", Quantity::Stiffness.unit())));
    if let Some(geometry) = &shown.design.mesh.geometry {
        let hand = match geometry.hand {
            Some(Hand::Right) => "right-hand",
            Some(Hand::Left) => "left-hand",
            None => "straight",
        };
        let turns = match geometry.pinion_turns {
            Turns::Positive => "+",
            Turns::Negative => "-",
        };
        lines.push(Line::Single(format!("{hand} pinion, turns {turns} about y")));
        let angle = significant(geometry.pressure_angle.to_degrees(), 5);
        lines.push(Line::Single(format!("pressure angle {angle} deg as written")));
        lines.push(Line::Note("that of this flank: write the other flank's after flipping if it differs".into()));
    }
    lines
}

fn signed(value: f64, digits: usize) -> String {
    // what is rounding beside sizes of a gear is the zero it stands for
    if value.abs() < 1e-9 {
        return "0".into();
    }
    let sign = if value > 0.0 { "+" } else { "" };
    format!("{sign}{}", significant(value, digits))
}

/// With a sign and so many decimals.
fn fixed(value: f64, decimals: usize) -> String {
    let text = if value.abs() < 1e5 { format!("{value:+.decimals$}") } else { signed(value, 5) };
    if text.contains(|digit| ('1'..='9').contains(&digit)) { text } else { "0".into() }
}

/// The lines with tabs between, for a spreadsheet, and the sentence about the thrust.
pub fn text(shown: &Shown) -> String {
    let line = |line: Line| match line {
        Line::Both(name, [pinion, gear], unit) => format!("{}\t{pinion}\t{gear}\t{unit}", name.trim()),
        Line::Single(text) | Line::Note(text) => text,
    };
    let head = "\tpinion\tgear\tunit".to_owned();
    let lines = std::iter::once(head).chain(lines(shown).into_iter().map(line)).chain([shown.figures.thrust()]);
    lines.collect::<Vec<_>>().join("\n")
}
