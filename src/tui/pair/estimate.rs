//! The face width, while it is typed, and the stiffness that it gives.

use crate::design::MeshGeometry;
use crate::number::significant;
use crate::pair::{Estimate, spiral_angle};
use crate::tui::app::App;
use crate::tui::keymap::Mode;
use crate::tui::message::Effect;
use crate::tui::text_field::TextField;
use crate::units::{Quantity, parse};

/// What is typed.
#[derive(Debug)]
pub struct EstimateForm {
    /// Effective face width
    pub width: TextField,
    /// Mean spiral or helix angle
    pub angle: TextField,
    pub on_angle: bool,
}

impl EstimateForm {
    fn new(geometry: Option<&MeshGeometry>) -> Self {
        let angle = geometry.and_then(spiral_angle).filter(|angle| angle.is_finite());
        let angle = angle.map_or(String::new(), |angle| format!("{} deg", significant(angle.to_degrees(), 6)));
        Self { width: TextField::default(), angle: TextField::new(angle), on_angle: false }
    }

    /// Goes to the other value, whose text is selected.
    pub(super) fn switch(&mut self) {
        self.line().deselect();
        self.on_angle = !self.on_angle;
        self.line().select();
    }

    /// The value that is typed into.
    fn line(&mut self) -> &mut TextField {
        if self.on_angle { &mut self.angle } else { &mut self.width }
    }

    /// The estimate, or what is still wanted for it.
    ///
    /// # Errors
    ///
    /// In words, with what is accepted.
    pub fn estimate(&self) -> Result<Estimate, String> {
        let number = |field: &TextField, quantity: Quantity, what: &str| {
            let typed = parse(field.text(), quantity).map_err(|error| format!("{what}: {error}"))?;
            Ok::<f64, String>(quantity.to_si(typed.value))
        };
        let width = number(&self.width, Quantity::Length, "face width")?;
        let angle = number(&self.angle, Quantity::Angle, "angle")?;
        Estimate::new(width, angle).map_err(|error| error.to_string())
    }
}

impl App {
    pub(super) fn open_estimate(&mut self) {
        let Some(editing) = self.editors.open() else { return };
        let geometry = editing.last_design.as_ref().and_then(|design| design.mesh.geometry);
        if let Some(view) = &mut self.pair {
            view.estimate = Some(EstimateForm::new(geometry.as_ref()));
            self.open(Mode::FaceWidth);
        }
    }

    pub(in crate::tui) fn edit_face_width(&mut self, edit: impl FnOnce(&mut TextField)) {
        if let Some(form) = self.pair.as_mut().and_then(|view| view.estimate.as_mut()) {
            edit(form.line());
        }
    }

    /// Takes the estimate over, as an edit; what is still wanted is said, and nothing changes.
    pub(super) fn accept_estimate(&mut self) -> Vec<Effect> {
        let form = self.pair.as_ref().and_then(|view| view.estimate.as_ref());
        let Some(result) = form.map(EstimateForm::estimate) else { return Vec::new() };
        match result {
            Ok(estimate) => {
                self.close_pair_form();
                let design = self.editors.open().and_then(|editing| editing.last_design.as_ref());
                let before = design.map_or(f64::NAN, |design| design.mesh.stiffness);
                let done = |_: &str| format!("mesh stiffness {before:e} -> {} N/m (estimate)", estimate.written());
                estimate.edit().map_or(Vec::new(), |edit| self.edit_pair_saying(&edit, done))
            }
            Err(error) => {
                self.complain(error);
                Vec::new()
            }
        }
    }
}
