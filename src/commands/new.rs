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
/// standard output; a file that is there is never overwritten. A name without an ending gets `.toml`.
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
    #[arg(long, allow_negative_numbers = true)]
    pinion_teeth: Option<String>,
    /// Teeth of the gear
    #[arg(long, allow_negative_numbers = true)]
    gear_teeth: Option<String>,
    /// Mean torque of the pinion, N m; shafts and bearings follow from it
    #[arg(long, allow_negative_numbers = true)]
    pinion_torque_n_m: Option<String>,
    /// Speed of the pinion, rpm; marks the mesh frequency only
    #[arg(long, allow_negative_numbers = true)]
    pinion_speed_rpm: Option<String>,
    /// Bevel and hypoid: outer pitch diameter of the gear, mm
    #[arg(long, allow_negative_numbers = true)]
    gear_outer_diameter_mm: Option<String>,
    /// Spur and helical: normal module, mm
    #[arg(long, allow_negative_numbers = true)]
    normal_module_mm: Option<String>,
    /// Face width of the gear, mm
    #[arg(long, allow_negative_numbers = true)]
    face_width_mm: Option<String>,
    /// Mean spiral angle (hypoid: of the pinion) or helix angle, deg
    #[arg(long, allow_negative_numbers = true)]
    spiral_angle_deg: Option<String>,
    /// Hypoid: offset of the axes, mm
    #[arg(long, allow_negative_numbers = true)]
    offset_mm: Option<String>,
    /// Hypoid: mean cutter radius, mm
    #[arg(long, allow_negative_numbers = true)]
    cutter_radius_mm: Option<String>,
    /// Normal pressure angle of the loaded flank, deg
    #[arg(long, allow_negative_numbers = true)]
    pressure_angle_deg: Option<String>,
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
        let mut file = args.file.clone();
        if file.extension().is_none() {
            // folders show designs by it
            file.set_extension("toml");
        }
        save_new(&file, &text).map_err(|error| usage(error.to_string()))?;
        writeln!(out, "{}", printable(&file.display().to_string()))?;
    }
    Ok(Status::Success)
}

impl Args {
    /// What was asked for, as it would be typed; the kind first, which decides what else there is.
    fn answers(&self) -> Vec<(Field, String)> {
        fn word<T: ValueEnum>(value: Option<&T>) -> Option<String> {
            value?.to_possible_value().map(|value| value.get_name().to_owned())
        }
        let all = [
            (Field::Kind, word(Some(&self.kind))),
            (Field::PinionTeeth, self.pinion_teeth.clone()),
            (Field::GearTeeth, self.gear_teeth.clone()),
            (Field::PinionTorque, self.pinion_torque_n_m.clone()),
            (Field::PinionSpeed, self.pinion_speed_rpm.clone()),
            (Field::GearOuterDiameter, self.gear_outer_diameter_mm.clone()),
            (Field::NormalModule, self.normal_module_mm.clone()),
            (Field::FaceWidth, self.face_width_mm.clone()),
            (Field::SpiralAngle, self.spiral_angle_deg.clone()),
            (Field::Offset, self.offset_mm.clone()),
            (Field::CutterRadius, self.cutter_radius_mm.clone()),
            (Field::PressureAngle, self.pressure_angle_deg.clone()),
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
