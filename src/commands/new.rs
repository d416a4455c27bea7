//! `bevelscope new`: a first design from a few wishes.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::ValueEnum;

use super::{CommandError, Format, Status};
use crate::design::new::{BearingKind, Field, GROOVE_FACTOR, Proposal, TypicalBearing, Wishes};
use crate::design::save_new;
use crate::report::json;
use crate::text::printable;

/// A new design from a few wishes: a complete commented file that solves at once.
///
/// Whatever is not asked for follows from the rest by a rule that the file names beside the number. The design is written to FILE.toml, or to
/// standard output; a file that is there is never overwritten.
#[derive(Debug, clap::Args)]
pub struct Args {
    /// New design file, or - for standard output
    #[arg(value_name = "FILE.toml", default_value = "-", hide_default_value = true)]
    file: PathBuf,
    /// What the design is called; by default its kind and its teeth
    #[arg(long)]
    name: Option<String>,
    /// Kind of the pair
    #[arg(long, default_value = "spiral-bevel")]
    kind: Kind,
    /// Teeth of the pinion, the small wheel, which drives
    #[arg(long)]
    pinion_teeth: Option<u32>,
    /// Teeth of the gear
    #[arg(long)]
    gear_teeth: Option<u32>,
    /// Mean torque of the pinion, N m; shafts and bearings follow from it
    #[arg(long)]
    pinion_torque_n_m: Option<f64>,
    /// Speed of the pinion, rpm; marks the mesh frequency only
    #[arg(long)]
    pinion_speed_rpm: Option<f64>,
    /// Bevel and hypoid: outer pitch diameter of the gear, mm
    #[arg(long)]
    gear_outer_diameter_mm: Option<f64>,
    /// Spur and helical: normal module, mm
    #[arg(long)]
    normal_module_mm: Option<f64>,
    /// Face width of the gear, mm
    #[arg(long)]
    face_width_mm: Option<f64>,
    /// Mean spiral angle (hypoid: of the pinion) or helix angle, deg
    #[arg(long)]
    spiral_angle_deg: Option<f64>,
    /// Hypoid: offset of the axes, mm
    #[arg(long)]
    offset_mm: Option<f64>,
    /// Hypoid: mean cutter radius, mm
    #[arg(long)]
    cutter_radius_mm: Option<f64>,
    /// Normal pressure angle of the loaded flank, deg
    #[arg(long)]
    pressure_angle_deg: Option<f64>,
    /// Hand of the pinion's teeth
    #[arg(long)]
    hand: Option<Hand>,
    /// How the pinion is mounted
    #[arg(long)]
    pinion_mounting: Option<Mounting>,
    /// How the gear is mounted
    #[arg(long)]
    gear_mounting: Option<Mounting>,
    /// Bearing B1 of the pinion, beside or before the teeth, by its name in --list-bearings
    #[arg(long, value_name = "BEARING")]
    pinion_b1: Option<String>,
    /// Bearing B2 of the pinion, towards the drive
    #[arg(long, value_name = "BEARING")]
    pinion_b2: Option<String>,
    /// Bearing B1 of the gear, beside or before the teeth
    #[arg(long, value_name = "BEARING")]
    gear_b1: Option<String>,
    /// Bearing B2 of the gear, towards the load
    #[arg(long, value_name = "BEARING")]
    gear_b2: Option<String>,
    /// The typical bearings that can be asked for, with their sizes and where those come from
    #[arg(long)]
    list_bearings: bool,
    /// Form of the list
    #[arg(long, default_value = "table", requires = "list_bearings")]
    format: Format,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Kind {
    SpiralBevel,
    StraightBevel,
    Hypoid,
    Spur,
    Helical,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Hand {
    Right,
    Left,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Mounting {
    Overhung,
    Straddle,
}

pub fn run(args: &Args, out: &mut impl Write) -> Result<Status, CommandError> {
    if args.list_bearings {
        list(args.format, out)?;
        return Ok(Status::Success);
    }
    let usage = |message: String| CommandError::Usage(printable(&message).into_owned());
    let mut wishes = Wishes::default();
    for (field, text) in args.answers() {
        if !field.belongs_to(wishes.kind()) {
            return Err(usage(format!("{}: a {} pair has none", option(field), wishes.kind().word())));
        }
        wishes.answer(field, &text).map_err(|refusal| usage(format!("{}: {refusal}", option(field))))?;
    }
    let proposal = Proposal::new(&wishes).map_err(|refusal| usage(format!("{}: {refusal}", option(refusal.field))))?;
    let name = args.name.clone().unwrap_or_else(|| proposal.title());
    if name.trim().is_empty() || name.contains(char::is_control) {
        return Err(usage("--name: one line with at least one letter is wanted".into()));
    }
    let text = proposal.text(&name);
    if args.file == Path::new("-") {
        out.write_all(text.as_bytes())?;
    } else {
        save_new(&args.file, &text).map_err(|error| usage(error.to_string()))?;
    }
    Ok(Status::Success)
}

impl Args {
    /// What was asked for, as it would be typed; the kind first, which decides what else there is.
    fn answers(&self) -> Vec<(Field, String)> {
        fn word<T: ValueEnum>(value: Option<&T>) -> Option<String> {
            value?.to_possible_value().map(|value| value.get_name().to_owned())
        }
        let number = |value: Option<f64>| value.map(|value| format!("{value:?}"));
        let count = |value: Option<u32>| value.map(|value| value.to_string());
        let all = [
            (Field::Kind, word(Some(&self.kind))),
            (Field::PinionTeeth, count(self.pinion_teeth)),
            (Field::GearTeeth, count(self.gear_teeth)),
            (Field::PinionTorque, number(self.pinion_torque_n_m)),
            (Field::PinionSpeed, number(self.pinion_speed_rpm)),
            (Field::GearOuterDiameter, number(self.gear_outer_diameter_mm)),
            (Field::NormalModule, number(self.normal_module_mm)),
            (Field::FaceWidth, number(self.face_width_mm)),
            (Field::SpiralAngle, number(self.spiral_angle_deg)),
            (Field::Offset, number(self.offset_mm)),
            (Field::CutterRadius, number(self.cutter_radius_mm)),
            (Field::PressureAngle, number(self.pressure_angle_deg)),
            (Field::Hand, word(self.hand.as_ref())),
            (Field::PinionMounting, word(self.pinion_mounting.as_ref())),
            (Field::GearMounting, word(self.gear_mounting.as_ref())),
            (Field::PinionB1, self.pinion_b1.clone()),
            (Field::PinionB2, self.pinion_b2.clone()),
            (Field::GearB1, self.gear_b1.clone()),
            (Field::GearB2, self.gear_b2.clone()),
        ];
        all.into_iter().filter_map(|(field, text)| Some((field, text?))).collect()
    }
}

/// The option that asks for it: its name with the unit of its key.
fn option(field: Field) -> String {
    let unit = field.quantity().map_or("", |quantity| quantity.suffix()).replace('_', "-");
    format!("--{}{unit}", field.name())
}

#[derive(serde::Serialize)]
struct Listed {
    name: String,
    kind: &'static str,
    bore_mm: f64,
    outside_diameter_mm: f64,
    width_mm: f64,
    elements: u32,
    element_diameter_mm: f64,
    pitch_diameter_mm: f64,
    contact_angle_deg: f64,
    roller_length_mm: Option<f64>,
    groove_factor: Option<f64>,
    source: &'static str,
}

impl Listed {
    fn new(bearing: &TypicalBearing) -> Self {
        let rounded = |value: f64| (value * 1e4).round() / 1e4;
        let mm = |length: f64| rounded(length * 1e3);
        Self {
            name: bearing.name(),
            kind: bearing.kind.word(),
            bore_mm: mm(bearing.bore),
            outside_diameter_mm: mm(bearing.outside_diameter),
            width_mm: mm(bearing.width),
            elements: bearing.elements(),
            element_diameter_mm: mm(bearing.element_diameter()),
            pitch_diameter_mm: mm(bearing.pitch_diameter()),
            contact_angle_deg: rounded(bearing.contact_angle.to_degrees()),
            roller_length_mm: bearing.roller_length().map(mm),
            groove_factor: bearing.roller_length().is_none().then_some(GROOVE_FACTOR),
            source: bearing.kind.source(),
        }
    }
}

fn list(format: Format, out: &mut impl Write) -> Result<(), CommandError> {
    let listed: Vec<Listed> = TypicalBearing::all().map(|bearing| Listed::new(&bearing)).collect();
    if format == Format::Json {
        return Ok(json::write(out, &listed)?);
    }
    writeln!(out, "typical bearings, of no maker; lengths in mm, contact angles in deg")?;
    for kind in BearingKind::ALL {
        let source = kind.source();
        writeln!(
            out,
            "\n{:<20}{:>5}{:>8}{:>7}{:>9}{:>6}{:>6}{:>10}{:>6}",
            kind.plain(),
            "bore",
            "outside",
            "width",
            "elements",
            "thick",
            "long",
            "pitch dia",
            "deg"
        )?;
        for one in listed.iter().filter(|one| one.kind == kind.word()) {
            let long = one.roller_length_mm.map_or("-".into(), |length| format!("{length:.1}"));
            writeln!(
                out,
                "{:<20}{:>5.0}{:>8.0}{:>7.2}{:>9}{:>6.1}{long:>6}{:>10.1}{:>6.0}",
                one.name,
                one.bore_mm,
                one.outside_diameter_mm,
                one.width_mm,
                one.elements,
                one.element_diameter_mm,
                one.pitch_diameter_mm,
                one.contact_angle_deg
            )?;
        }
        for line in crate::text::wrap(source, 78) {
            writeln!(out, "  {line}")?;
        }
    }
    Ok(())
}
