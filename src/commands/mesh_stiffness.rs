//! `bevelscope mesh-stiffness`: a mean value where no contact analysis is at hand.

use std::io::Write;

use super::{CommandError, Format, Status};
use crate::pair::{Estimate, METHOD};
use crate::report::json;

#[derive(Debug, clap::Args)]
pub struct Args {
    /// Effective face width, mm: of bevel and hypoid gears about 0.85 of the face width
    #[arg(long, allow_negative_numbers = true, value_parser = parse_width)]
    face_width_mm: f64,
    /// Mean spiral or helix angle, deg; 0 for straight teeth
    #[arg(long, default_value = "0", allow_negative_numbers = true, value_parser = parse_angle)]
    spiral_angle_deg: f64,
    /// Form of the output
    #[arg(long, default_value = "table")]
    format: Format,
}

fn parse_width(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| "wanted a length in mm, greater than 0, such as 21.59".into())
}

fn parse_angle(text: &str) -> Result<f64, String> {
    text.trim().parse().map_err(|_| "wanted an angle in deg, from 0 to less than 90, such as 35".into())
}

#[derive(serde::Serialize)]
struct Output {
    stiffness_n_per_m: f64,
    method: &'static str,
}

pub fn run(args: &Args, out: &mut impl Write) -> Result<Status, CommandError> {
    let estimate = Estimate::new(args.face_width_mm / 1e3, args.spiral_angle_deg.to_radians())
        .map_err(|error| CommandError::Usage(error.to_string()))?;
    match args.format {
        Format::Json => json::write(out, &Output { stiffness_n_per_m: estimate.stiffness, method: METHOD })?,
        Format::Table => writeln!(out, "stiffness_n_per_m = {}    # {METHOD}", estimate.written())?,
    }
    Ok(Status::Success)
}
