//! A picture of dots: braille, or letters where there is only ASCII.
//!
//! ```text
//! one cell:   1 4      ASCII:  one dot a cell,
//!             2 5              shown as the letter
//!             3 6              of the pen
//!             7 8
//! ```

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::{Modifier, Style};

/// What a curve is drawn with. A cell has one colour only: the pen that came last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pen {
    pub style: Style,
    /// Stands for the dots where there is only ASCII.
    pub letter: char,
}

#[derive(Debug, Clone)]
pub struct Canvas {
    width: usize,
    height: usize,
    ascii: bool,
    cells: Vec<(u8, Option<Pen>)>,
}

/// Bit of the dot in column `x`, row `y` of a braille character.
const DOTS: [[u8; 4]; 2] = [[0x01, 0x02, 0x04, 0x40], [0x08, 0x10, 0x20, 0x80]];

impl Canvas {
    /// An empty picture of `width` by `height` cells.
    pub fn new(width: u16, height: u16, ascii: bool) -> Self {
        let (width, height) = (usize::from(width), usize::from(height));
        Self { width, height, ascii, cells: vec![(0, None); width * height] }
    }

    /// Dots in one cell, across and down.
    pub fn dots_per_cell(ascii: bool) -> (usize, usize) {
        if ascii { (1, 1) } else { (2, 4) }
    }

    /// Dots across.
    pub fn dots_wide(&self) -> usize {
        self.width * Self::dots_per_cell(self.ascii).0
    }

    /// Dots down.
    pub fn dots_high(&self) -> usize {
        self.height * Self::dots_per_cell(self.ascii).1
    }

    /// Sets a dot, counted from the top left; what lies outside is left out.
    pub fn set(&mut self, x: usize, y: usize, pen: Pen) {
        if x >= self.dots_wide() || y >= self.dots_high() {
            return;
        }
        let (across, down) = Self::dots_per_cell(self.ascii);
        if let Some(cell) = self.cells.get_mut(y / down * self.width + x / across) {
            *cell = (cell.0 | DOTS[x % across][y % down], Some(pen));
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
                let shown =
                    if self.ascii { pen.letter } else { char::from_u32(0x2800 + u32::from(*dots)).unwrap_or(' ') };
                // the band behind a curve may be dimmed, the curve is not
                cell.set_char(shown).set_style(Style { sub_modifier: Modifier::DIM, ..pen.style });
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drawn(ascii: bool, dots: &[(usize, usize)]) -> String {
        let mut canvas = Canvas::new(2, 1, ascii);
        for &(x, y) in dots {
            canvas.set(x, y, Pen { style: Style::new(), letter: 'F' });
        }
        let mut buffer = Buffer::empty(Rect::new(0, 0, 2, 1));
        canvas.render(buffer.area, &mut buffer);
        buffer.content().iter().map(ratatui::buffer::Cell::symbol).collect()
    }

    #[test]
    fn dots_are_where_unicode_puts_them() {
        assert_eq!(drawn(false, &[(0, 0), (3, 3)]), "⠁⢀");
        assert_eq!(drawn(false, &[(0, 1), (0, 2), (0, 3), (1, 0), (1, 1), (1, 2)]), "⡾ ");
        assert_eq!(drawn(true, &[(1, 0)]), " F");
        assert_eq!(drawn(false, &[(99, 0), (0, 99)]), "  ");
    }
}
