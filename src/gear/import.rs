//! Averaged mesh numbers of a contact program, from a small table of comma-separated values.
//!
//! The first line names the columns, in any order; each further line is one flank. Lines that are empty or begin with `#` say nothing.

use crate::text::excerpt;

/// The columns, all of which are wanted.
pub const COLUMNS: [&str; 15] = [
    "flank",
    "stiffness_n_per_m",
    "transmission_error_um",
    "pinion_point_x_mm",
    "pinion_point_y_mm",
    "pinion_point_z_mm",
    "pinion_line_x",
    "pinion_line_y",
    "pinion_line_z",
    "gear_point_x_mm",
    "gear_point_y_mm",
    "gear_point_z_mm",
    "gear_line_x",
    "gear_line_y",
    "gear_line_z",
];

/// How far the length of a unit vector may be from 1: up to here it is as it is in a design; up to there it was rounded to two or three
/// decimals, and is scaled.
const EXACT: f64 = 1e-3;
const SCALED: f64 = 1e-2;

/// Averaged numbers of one flank, in the units of the columns.
#[derive(Debug, Clone, PartialEq)]
pub struct AveragedMesh {
    /// `drive` or `coast`
    pub flank: String,
    pub stiffness_n_per_m: f64,
    pub transmission_error_um: f64,
    /// Mesh point (mm, from the mesh station) and line of action of the pinion, then of the gear
    pub sides: [([f64; 3], [f64; 3]); 2],
    /// What was put right, in sentences
    pub notes: Vec<String>,
}

/// What is wrong with a line; texts of the file in it are harmless to show.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("line {line}: {message}")]
pub struct ImportError {
    /// From 1
    pub line: usize,
    pub message: String,
}

/// Reads all flanks.
///
/// # Errors
///
/// [`ImportError`] names the first line that is wrong, and the column.
pub fn read_csv(text: &str) -> Result<Vec<AveragedMesh>, ImportError> {
    let mut lines = text
        .trim_start_matches('\u{feff}')
        .lines()
        .enumerate()
        .map(|(i, line)| (i + 1, line.trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let (line, head) = lines.next().ok_or_else(|| error(1, "a line with the names of the columns is wanted"))?;
    let order = order(line, &fields(head))?;
    let mut flanks: Vec<AveragedMesh> = Vec::new();
    for (line, text) in lines {
        let mesh = flank(line, &fields(text), &order)?;
        if flanks.iter().any(|other| other.flank == mesh.flank) {
            return Err(error(line, &format!("the flank {} is there already", mesh.flank)));
        }
        flanks.push(mesh);
    }
    Ok(flanks)
}

fn error(line: usize, message: &str) -> ImportError {
    ImportError { line, message: message.into() }
}

fn fields(line: &str) -> Vec<&str> {
    line.split(',').map(|field| field.trim().trim_matches('"').trim()).collect()
}

/// Where each of [`COLUMNS`] stands.
fn order(line: usize, head: &[&str]) -> Result<Vec<usize>, ImportError> {
    if let Some(other) = [';', '\t'].into_iter().find(|other| head.len() == 1 && head[0].contains(*other)) {
        let name = if other == ';' { "semicolons" } else { "tabs" };
        let wanted = "commas are wanted between values, and a point before decimals";
        return Err(error(line, &format!("the columns are separated by {name}; {wanted}")));
    }
    if let Some(unknown) = head.iter().find(|name| !COLUMNS.contains(*name)) {
        return Err(error(
            line,
            &format!("unknown column `{}`; the columns are {}", excerpt(unknown, 40), COLUMNS.join(", ")),
        ));
    }
    let missing: Vec<String> =
        COLUMNS.iter().filter(|column| !head.contains(column)).map(|column| format!("`{column}`")).collect();
    match missing.as_slice() {
        [] => {}
        [column] => return Err(error(line, &format!("the column {column} is missing"))),
        columns => return Err(error(line, &format!("the columns {} are missing", columns.join(", ")))),
    }
    let place = |column: &&str| {
        let mut places = head.iter().enumerate().filter(|(_, name)| *name == column).map(|(place, _)| place);
        let first = places.next().ok_or_else(|| error(line, &format!("the column `{column}` is missing")))?;
        match places.next() {
            None => Ok(first),
            Some(_) => Err(error(line, &format!("the column `{column}` is there twice"))),
        }
    };
    COLUMNS.iter().map(place).collect()
}

fn flank(line: usize, fields: &[&str], order: &[usize]) -> Result<AveragedMesh, ImportError> {
    if fields.len() != order.len() {
        return Err(error(
            line,
            &format!(
                "{} values are wanted, one a column; there are {}{}",
                order.len(),
                fields.len(),
                if fields.len() > order.len() { ": decimals stand behind a point, not a comma" } else { "" }
            ),
        ));
    }
    let flank = fields[order[0]];
    if !["drive", "coast"].contains(&flank) {
        return Err(error(line, &format!("flank must be drive or coast; it is `{}`", excerpt(flank, 40))));
    }
    let mut values = [0.0; COLUMNS.len()];
    for (column, value) in values.iter_mut().enumerate().skip(1) {
        let written = fields[order[column]];
        let number = written.parse::<f64>().ok().filter(|number| number.is_finite());
        *value = number.ok_or_else(|| {
            error(line, &format!("{} must be a number; it is `{}`", COLUMNS[column], excerpt(written, 40)))
        })?;
    }
    for column in [1, 2] {
        if values[column] <= 0.0 {
            return Err(error(
                line,
                &format!("{} must be greater than 0; it is {:?}", COLUMNS[column], values[column]),
            ));
        }
    }
    let mut notes = Vec::new();
    for from in [6, 12] {
        let vector = &mut values[from..from + 3];
        let length = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
        let (off, name) = ((length - 1.0).abs(), COLUMNS[from].trim_end_matches("_x"));
        if off > SCALED {
            return Err(error(line, &format!("{name} must be a unit vector, to 1 %; its length is {length:.6}")));
        }
        if off > EXACT {
            for x in vector {
                *x = (*x / length * 1e6).round() / 1e6;
            }
            notes.push(format!("line {line}: {name} had the length {length:.6}; it is scaled to 1"));
        }
    }
    let three = |from: usize| [values[from], values[from + 1], values[from + 2]];
    Ok(AveragedMesh {
        flank: flank.into(),
        stiffness_n_per_m: values[1],
        transmission_error_um: values[2],
        sides: [(three(3), three(6)), (three(9), three(12))],
        notes,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(flank: &str) -> String {
        format!("{flank},6.4e8,5,0,0,27.46,0.76975,-0.62285,0.1398,0,0,76.49,-0.76975,0.1398,-0.62285")
    }

    #[test]
    fn columns_may_stand_in_any_order() {
        let head = COLUMNS.join(", ");
        let plain = read_csv(&format!("# a comment\n{head}\n\n{}\n{}\n", line("drive"), line("coast"))).unwrap();
        assert_eq!((plain.len(), plain[1].flank.as_str()), (2, "coast"));
        assert_eq!(plain[0].sides[0], ([0.0, 0.0, 27.46], [0.76975, -0.62285, 0.1398]));
        let turn = |line: &str| line.split(',').rev().collect::<Vec<_>>().join(",");
        assert_eq!(read_csv(&format!("{}\n{}", turn(&head), turn(&line("drive")))).unwrap()[0], plain[0]);
    }

    #[test]
    fn what_is_wrong_is_said_by_line() {
        let head = COLUMNS.join(",");
        for (text, expected) in [
            (String::new(), "line 1: a line with the names"),
            (head.replace("flank", "side"), "line 1: unknown column `side`"),
            (head.replace("flank,", ""), "line 1: the column `flank` is missing"),
            (format!("{head},flank"), "line 1: the column `flank` is there twice"),
            (format!("{head}\n{}\n\n{}", line("drive"), line("drive")), "line 4: the flank drive is there already"),
            (format!("{head}\n{}", line("reverse")), "line 2: flank must be drive or coast; it is `reverse`"),
            (format!("{head}\ndrive,1,2"), "line 2: 15 values are wanted, one a column; there are 3"),
            (
                format!("{head}\n{}", line("drive").replace("27.46", "much")),
                "line 2: pinion_point_z_mm must be a number",
            ),
            (
                format!("{head}\n{}", line("drive").replace("27.46", "nan")),
                "line 2: pinion_point_z_mm must be a number",
            ),
            (
                format!("{head}\n{}", line("drive").replace("6.4e8", "0")),
                "line 2: stiffness_n_per_m must be greater than 0",
            ),
            (
                format!("{head}\n{}", line("drive").replace("0.76975", "0.5")),
                "line 2: pinion_line must be a unit vector",
            ),
        ] {
            let error = read_csv(&text).unwrap_err().to_string();
            assert!(error.starts_with(expected), "{error}");
        }
    }
}
