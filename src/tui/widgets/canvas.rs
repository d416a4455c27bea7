//! A picture of dots, drawn with the characters of a [`Marker`].

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};

use crate::tui::marker::Marker;

/// What a curve is drawn with. A cell has one colour only: the pen that came last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    pub style: Style,
    /// Stands for the dots where the marker is letters.
    pub letter: char,
}

#[derive(Debug, Clone)]
pub struct Canvas {
    width: usize,
    height: usize,
    marker: Marker,
    /// Bit 2 y + x is the dot in column x, row y of a cell.
    cells: Vec<(u8, Option<Pen>)>,
}

impl Canvas {
    /// An empty picture of `width` by `height` cells.
    pub fn new(width: u16, height: u16, marker: Marker) -> Self {
        let (width, height) = (usize::from(width), usize::from(height));
        Self { width, height, marker, cells: vec![(0, None); width * height] }
    }

    /// Dots across.
    pub fn dots_wide(&self) -> usize {
        self.width * self.marker.dots().0
    }

    /// Dots down.
    pub fn dots_high(&self) -> usize {
        self.height * self.marker.dots().1
    }

    /// Sets a dot, counted from the top left; what lies outside is left out.
    pub fn set(&mut self, x: usize, y: usize, pen: Pen) {
        if x >= self.dots_wide() || y >= self.dots_high() {
            return;
        }
        let (across, down) = self.marker.dots();
        if let Some(cell) = self.cells.get_mut(y / down * self.width + x / across) {
            *cell = (cell.0 | 1 << (2 * (y % down) + x % across), Some(pen));
        }
    }

    /// Sets the dots of column `x` from `top` to `bottom`, both included.
    pub fn set_column(&mut self, x: usize, top: usize, bottom: usize, pen: Pen) {
        for y in top..=bottom.min(self.dots_high().saturating_sub(1)) {
            self.set(x, y, pen);
        }
    }

    /// Draws the cells that have dots; the others keep what is there, and all keep their background.
    pub fn render(&self, area: Rect, buffer: &mut Buffer) {
        for (at, (dots, pen)) in self.cells.iter().enumerate() {
            let Some(pen) = pen else { continue };
            let (x, y) = (area.x + (at % self.width) as u16, area.y + (at / self.width) as u16);
            if let Some(cell) = buffer.cell_mut((x, y)) {
                let shown = self.marker.character(*dots).unwrap_or(pen.letter);
                // the band behind a curve may be dimmed, the curve is not
                cell.set_char(shown).set_style(Style { sub_modifier: Modifier::DIM, ..pen.style });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(marker: Marker, dots: &[(usize, usize)]) -> String {
        let mut canvas = Canvas::new(2, 1, marker);
        for &(x, y) in dots {
            canvas.set(x, y, Pen { style: Style::new(), letter: 'F' });
        }
        let mut buffer = Buffer::empty(Rect::new(0, 0, 2, 1));
        canvas.render(buffer.area, &mut buffer);
        buffer.content().iter().map(ratatui::buffer::Cell::symbol).collect()
    }

    // the dots of U+2800 to U+28FF and the quadrants of U+2596 to U+259F, as the Unicode code charts draw them
    #[test]
    fn dots_are_where_unicode_puts_them() {
        assert_eq!(drawn(Marker::Braille, &[(0, 0), (3, 3)]), "⠁⢀");
        assert_eq!(drawn(Marker::Braille, &[(0, 1), (0, 2), (0, 3), (1, 0), (1, 1), (1, 2)]), "⡾ ");
        assert_eq!(drawn(Marker::Blocks, &[(0, 0), (3, 1)]), "▘▗");
        assert_eq!(drawn(Marker::Blocks, &[(0, 1), (1, 0), (2, 0), (2, 1)]), "▞▌");
        assert_eq!(drawn(Marker::Points, &[(0, 0), (1, 1)]), "',");
        assert_eq!(drawn(Marker::Points, &[(1, 0), (1, 1)]), " |");
        assert_eq!(drawn(Marker::Dots, &[(1, 0)]), " •");
        assert_eq!(drawn(Marker::Letters, &[(1, 0)]), " F");
        assert_eq!(drawn(Marker::Braille, &[(99, 0), (0, 99)]), "  ");
    }
}
