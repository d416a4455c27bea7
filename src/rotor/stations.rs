//! Where the nodes of a shaft stand, and what lies between and upon them.

use super::{RotorError, Section};
use crate::design::{Design, MAX_STATIONS, RotorDesign, SAME_STATION};

/// The nodes of one shaft, in order, and the uniform pieces between neighbours.
#[derive(Debug, Clone, PartialEq)]
pub struct Stations {
    /// m from the shaft's start, ascending
    pub positions: Vec<f64>,
    /// Section between station i and i + 1; one fewer than positions
    pub sections: Vec<Section>,
    /// Station of the mesh: the lumped point
    pub mesh: usize,
    /// Station where the drive's spring acts; nothing where there is no drive
    pub drive: Option<usize>,
    /// Station of each body, in the design's order
    pub bodies: Vec<usize>,
    /// Station of each bearing, in the design's order
    pub bearings: Vec<usize>,
}

impl Stations {
    /// Stations of [`RotorDesign::station_positions`], with the sections between them.
    ///
    /// # Errors
    ///
    /// No shaft, more than [`MAX_STATIONS`], a position off the shaft, or a material that the design does not have.
    pub fn new(design: &Design, rotor: &RotorDesign) -> Result<Self, RotorError> {
        let all =
            rotor.station_positions().filter(|all| all.len() <= MAX_STATIONS).ok_or(RotorError::TooManyStations)?;
        if all.len() < 2 {
            return Err(RotorError::TooShort);
        }
        let mut ends = Vec::with_capacity(rotor.segments.len());
        let mut length = 0.0;
        for segment in &rotor.segments {
            length += segment.length;
            let material = design.materials.get(&segment.material);
            let material = material.ok_or_else(|| RotorError::UnknownMaterial(segment.material.clone()))?;
            ends.push((length, Section::new(segment, material, design.analysis.beam_theory)));
        }
        let bodies = rotor.bodies.iter().map(|body| body.position);
        let bearings = rotor.bearings.iter().map(|bearing| bearing.position);
        let mut others =
            bodies.chain(bearings).chain([rotor.mesh_position]).chain(rotor.drive.map(|drive| drive.position));
        let on_shaft = -SAME_STATION..=length + SAME_STATION;
        if let Some(position) = others.find(|position| !on_shaft.contains(position)) {
            return Err(RotorError::OffShaft { position_mm: position * 1e3, length_mm: length * 1e3 });
        }
        let section_at = |middle: f64| {
            let index = ends.partition_point(|(end, _)| *end <= middle);
            ends[index.min(ends.len() - 1)].1
        };
        let sections = all.windows(2).map(|pair| section_at(f64::midpoint(pair[0], pair[1]))).collect();
        let station = |position: f64| {
            let at = position.clamp(0.0, length);
            let after = all.partition_point(|p| *p < at).min(all.len() - 1);
            let before = after.saturating_sub(1);
            if (at - all[before]).abs() < (all[after] - at).abs() { before } else { after }
        };
        Ok(Self {
            mesh: station(rotor.mesh_position),
            drive: rotor.drive.map(|drive| station(drive.position)),
            bodies: rotor.bodies.iter().map(|body| station(body.position)).collect(),
            bearings: rotor.bearings.iter().map(|bearing| station(bearing.position)).collect(),
            sections,
            positions: all,
        })
    }

    /// Number of stations.
    pub fn count(&self) -> usize {
        self.positions.len()
    }

    /// Length of the piece after station `i`, m.
    pub fn piece_length(&self, i: usize) -> f64 {
        self.positions[i + 1] - self.positions[i]
    }

    /// The same shaft without the stations where nothing changes and nothing sits.
    ///
    /// Static shapes and transfer matrices are exact over a uniform piece of any length, so that there finer elements
    /// only add rounding errors.
    #[must_use]
    pub fn coarsened(&self) -> Self {
        let last = self.count() - 1;
        let occupied = |i: usize| {
            i == self.mesh || Some(i) == self.drive || self.bodies.contains(&i) || self.bearings.contains(&i)
        };
        let kept: Vec<usize> = (0..=last)
            .filter(|&i| i == 0 || i == last || self.sections[i - 1] != self.sections[i] || occupied(i))
            .collect();
        let renumber = |i: usize| kept.partition_point(|&k| k < i);
        Self {
            positions: kept.iter().map(|&i| self.positions[i]).collect(),
            sections: kept[..kept.len() - 1].iter().map(|&i| self.sections[i]).collect(),
            mesh: renumber(self.mesh),
            drive: self.drive.map(renumber),
            bodies: self.bodies.iter().map(|&i| renumber(i)).collect(),
            bearings: self.bearings.iter().map(|&i| renumber(i)).collect(),
        }
    }

    /// The coarsest shaft of the same stiffness between mesh and bearings: without masses and without the drive.
    #[must_use]
    pub fn of_springs(&self) -> Self {
        let sections = self.sections.iter().map(Section::without_mass).collect();
        Self { sections, drive: None, bodies: Vec::new(), ..self.clone() }.coarsened()
    }

    /// Torsional compliance of the shaft between the mesh and the drive, rad/(N m); 0 without a drive.
    pub fn torsional_compliance(&self) -> f64 {
        let drive = self.drive.unwrap_or(self.mesh);
        let (from, to) = (self.mesh.min(drive), self.mesh.max(drive));
        (from..to).map(|i| self.piece_length(i) / self.sections[i].torsional_stiffness).sum()
    }
}
