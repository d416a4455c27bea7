//! Where the stations of a shaft stand.

use super::RotorDesign;

/// Most stations that a shaft may have.
pub const MAX_STATIONS: usize = 400;

/// Positions closer than this are one station, m.
pub const SAME_STATION: f64 = 1e-9;

impl RotorDesign {
    /// Positions of the stations, m, ascending: at every segment end and inner element end, and at every body, bearing, the
    /// mesh and the drive.
    ///
    /// `None` for far more stations than [`MAX_STATIONS`]: nothing is allocated for them.
    pub fn station_positions(&self) -> Option<Vec<f64>> {
        let ends: usize = self.segments.iter().map(|segment| segment.elements).fold(0, usize::saturating_add);
        if ends > 10 * MAX_STATIONS {
            return None;
        }
        let mut positions = vec![0.0];
        let mut start = 0.0;
        for segment in &self.segments {
            let elements = segment.elements.max(1);
            let inner = (1..elements).map(|i| start + segment.length * i as f64 / elements as f64);
            positions.extend(inner);
            start += segment.length;
            positions.push(start);
        }
        // a position at the end may miss it by the rounding of a sum of lengths
        let bodies = self.bodies.iter().map(|body| body.position);
        let bearings = self.bearings.iter().map(|bearing| bearing.position);
        let others = bodies.chain(bearings).chain([self.mesh_position]);
        let others = others.chain(self.drive.map(|drive| drive.position));
        positions.extend(others.map(|position| position.max(0.0).min(start)));
        positions.retain(|position| position.is_finite());
        positions.sort_by(f64::total_cmp);
        positions.dedup_by(|next, kept| *next - *kept <= SAME_STATION);
        Some(positions)
    }
}
