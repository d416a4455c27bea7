//! The loads of a bearing's elements as a polar picture, and in numbers.
//!
//! ```text
//!        \  |  /        The ring as seen from +y: z up, x to the left, so that the azimuth, counted from +z
//!     .   o 0 o   .     towards +x, runs against the clock. A bar stands outwards on each element that carries
//!   .      z       .    a load, as long as the load; the line from the middle is the radial load on the
//!   .    x +-      .    inner ring.
//!     .         .
//! ```

use std::f64::consts::TAU;

use ratatui::buffer::Buffer;
use ratatui::layout::Rect;
use ratatui::style::Style;

use super::canvas::{Canvas, Pen};
use super::panel::put;
use crate::bearing::{Contact, State};
use crate::number::grouped;
use crate::tui::theme::Theme;

/// The ring's part of the greatest radius; the rest is for the bars.
const RING: f64 = 0.55;
/// Columns of an element in the list.
const ENTRY: u16 = 23;
/// Rows of the picture that the list leaves.
const PICTURE: u16 = 13;

/// Draws the picture, and the list where there is room for both.
pub fn render(state: &State, selected: usize, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let count = state.contacts.len();
    let beside = area.width.saturating_sub(2 * area.height).min(2 * ENTRY) / ENTRY * ENTRY;
    let below = if beside > 0 { 0 } else { area.height.saturating_sub(PICTURE) };
    let columns = usize::from((area.width / ENTRY).max(1));
    let below = if below >= 4 { below.min(count.div_ceil(columns) as u16 + 1) } else { 0 };
    let picture = Rect { width: area.width - beside, height: area.height - below, ..area };
    render_picture(state, selected, theme, picture, buffer);
    if beside > 0 {
        let place = Rect { x: picture.right(), width: beside, ..area };
        render_list(&state.contacts, selected, theme, place, buffer);
    } else if below > 0 {
        let place = Rect { y: picture.bottom(), height: below, ..area };
        render_list(&state.contacts, selected, theme, place, buffer);
    }
}

/// One element in words, the longest first.
pub fn readout(at: usize, contact: &Contact) -> [String; 3] {
    let (load, angle) = (grouped(contact.load), contact.angle.to_degrees());
    let place = format!("{at}: {:.1} deg", contact.position.to_degrees());
    if contact.load == 0.0 {
        let short = format!("{place}, no load");
        return [format!("element {short}"), short.clone(), short];
    }
    let short = format!("{place}, {load} N");
    [format!("element {short}, contact angle {angle:.1} deg"), format!("{short}, contact {angle:.1} deg"), short]
}

/// A picture in which one unit is a column, and a row is two of them.
struct Picture {
    canvas: Canvas,
    dots: (usize, usize),
    area: Rect,
    centre: [f64; 2],
    radius: f64,
}

impl Picture {
    fn new(theme: &Theme, area: Rect) -> Self {
        let (width, height) = (f64::from(area.width), 2.0 * f64::from(area.height));
        let radius = (width.min(height) / 2.0 - 0.5).max(0.0);
        let canvas = Canvas::new(area.width, area.height, theme.marker);
        Self { canvas, dots: theme.marker.dots(), area, centre: [width / 2.0, height / 2.0], radius }
    }

    /// At an azimuth from up towards the left, and a part of the radius.
    fn place(&self, azimuth: f64, part: f64) -> [f64; 2] {
        let (sin, cos) = azimuth.sin_cos();
        [self.centre[0] - part * self.radius * sin, self.centre[1] - part * self.radius * cos]
    }

    fn dot(&mut self, [x, y]: [f64; 2], pen: Pen) {
        if x >= 0.0 && y >= 0.0 {
            self.canvas.set((x * self.dots.0 as f64) as usize, (y / 2.0 * self.dots.1 as f64) as usize, pen);
        }
    }

    fn line(&mut self, azimuth: f64, from: f64, to: f64, pen: Pen) {
        let steps = ((to - from).abs() * self.radius * 4.0).ceil().clamp(1.0, 4096.0) as usize;
        for step in 0..=steps {
            let part = from + (to - from) * step as f64 / steps as f64;
            self.dot(self.place(azimuth, part), pen);
        }
    }

    fn letter(&self, [x, y]: [f64; 2], letter: char, style: Style, buffer: &mut Buffer) {
        let (column, row) = (x.max(0.0) as u16, (y / 2.0).max(0.0) as u16);
        if column < self.area.width && row < self.area.height {
            put(buffer, self.area.x + column, self.area.y + row, letter, style);
        }
    }
}

fn render_picture(state: &State, selected: usize, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    if area.width < 8 || area.height < 4 {
        return;
    }
    let mut picture = Picture::new(theme, area);
    let greatest = state.greatest_load();
    let part = |load: f64| if greatest > 0.0 { (load / greatest).clamp(0.0, 1.0) } else { 0.0 };
    if theme.marker.dots() != (1, 1) {
        let points = (TAU * RING * picture.radius * 2.0) as usize;
        let pen = Pen { style: theme.faint, letter: '.' };
        for at in 0..points {
            picture.dot(picture.place(TAU * at as f64 / points as f64, RING), pen);
        }
    }
    // radial load: X is z, Y is x in the bearing's own frame
    let radial = [state.load[1], state.load[0]];
    if radial[0].hypot(radial[1]) > 1e-9 * greatest {
        picture.line(radial[0].atan2(radial[1]), 0.0, 0.75 * RING, Pen { style: theme.title, letter: '*' });
    }
    let bar = Pen { style: theme.enhanced, letter: '#' };
    for contact in state.contacts.iter().filter(|contact| contact.load > 0.0) {
        picture.line(contact.position, RING, RING + (1.0 - RING) * part(contact.load), bar);
    }
    picture.canvas.render(area, buffer);
    for (at, contact) in state.contacts.iter().enumerate().rev() {
        let place = picture.place(contact.position, RING);
        let (letter, style) = match (at, contact.load > 0.0) {
            (0, _) => ('0', theme.title),
            (_, true) => ('o', theme.fe),
            (_, false) => ('.', theme.faint),
        };
        picture.letter(place, letter, style, buffer);
    }
    if let Some(contact) = state.contacts.get(selected) {
        let letter = theme.glyphs.marked.chars().next().unwrap_or('@');
        picture.letter(picture.place(contact.position, RING), letter, theme.selected, buffer);
    }
    let [x, y] = picture.centre;
    picture.letter([x, y], '+', theme.faint, buffer);
    picture.letter([x, y - 2.0], 'z', theme.faint, buffer);
    picture.letter([x - 2.0, y], 'x', theme.faint, buffer);
}

/// All elements in columns, from the page on that the selected one is on.
fn render_list(contacts: &[Contact], selected: usize, theme: &Theme, area: Rect, buffer: &mut Buffer) {
    let wide = usize::from(ENTRY.min(area.width));
    let columns = usize::from(area.width / ENTRY).max(1);
    let rows = usize::from(area.height).saturating_sub(1);
    if rows == 0 || contacts.is_empty() {
        return;
    }
    let page = rows * columns;
    let first = selected.min(contacts.len() - 1) / page * page;
    for column in 0..columns {
        let x = area.x + ENTRY * column as u16;
        let from = first + column * rows;
        if from < contacts.len() {
            buffer.set_stringn(x, area.y, format!("{:>3}{:>7}{:>8}{:>5}", "", "deg", "N", "deg"), wide, theme.faint);
        }
        for (at, y) in (from..contacts.len().min(from + rows)).zip(area.y + 1..area.bottom()) {
            let contact = &contacts[at];
            let angle = if contact.load > 0.0 { format!("{:.1}", contact.angle.to_degrees()) } else { "-".into() };
            let (position, load) = (contact.position.to_degrees(), grouped(contact.load));
            let style = if at == selected { theme.selected } else { Style::new() };
            buffer.set_stringn(x, y, format!("{at:>3}{position:>7.1}{load:>8}{angle:>5}"), wide, style);
        }
    }
}
