//! What is shown, as CSV.

use std::fmt::Write as _;
use std::path::PathBuf;
use std::sync::Arc;

use super::{ModelCurves, Quantity, SpectraView, Subject};
use crate::text::printable;

/// A file to be written.
#[derive(Debug, Clone)]
pub struct Export {
    pub path: PathBuf,
    subject: Arc<Subject>,
    models: Vec<Arc<ModelCurves>>,
    quantity: Quantity,
    /// Hz
    window: (f64, f64),
}

/// A request is what it writes to.
impl PartialEq for Export {
    fn eq(&self, other: &Self) -> bool {
        self.path == other.path
            && self.quantity == other.quantity
            && self.window.0.to_bits() == other.window.0.to_bits()
    }
}

impl Eq for Export {}

impl SpectraView {
    /// The curves in sight; nothing where there are none.
    pub(super) fn export(&self, path: PathBuf) -> Option<Export> {
        let (subject, axis) = (self.known.subject.clone()?, self.axis()?);
        let models: Vec<_> = self.shown_kinds().filter_map(|kind| self.known.model(kind).cloned()).collect();
        let has_curve = |model: &Arc<ModelCurves>| model.curve(self.quantity).is_some();
        let models: Vec<_> = models.into_iter().filter(has_curve).collect();
        (!models.is_empty()).then_some(Export {
            path,
            subject,
            models,
            quantity: self.quantity,
            window: (axis.min, axis.max),
        })
    }
}

impl Export {
    /// RFC 4180 below one line that begins with `#`: program, its version, the design and its hash. The lines of the analysis that are in sight, in full
    /// precision.
    pub fn text(&self) -> String {
        let Subject { design, hash, frequency_hz, .. } = &*self.subject;
        let version = env!("CARGO_PKG_VERSION");
        let hash = hash.as_deref().unwrap_or("unknown");
        let name = printable(&design.name).replace(['\r', '\n'], " ");
        let mut out = format!("# bevelscope {version}, design {name}, hash {hash}\r\nfrequency_hz");
        let column = self.quantity.column(design);
        let has_phase = self.quantity.has_phase();
        for model in &self.models {
            let head = format!("{}_{column}", model.kind.name());
            let heads = if has_phase { vec![format!("{head}_re"), format!("{head}_im")] } else { vec![head] };
            for head in heads {
                out.push(',');
                out += &quoted(&head);
            }
        }
        out += "\r\n";
        for (at, hz) in frequency_hz.iter().enumerate() {
            if !(self.window.0..=self.window.1).contains(hz) {
                continue;
            }
            let _ = write!(out, "{hz:?}");
            for curve in self.models.iter().filter_map(|model| model.curve(self.quantity)) {
                let value = curve.lines[at];
                let _ = if has_phase {
                    write!(out, ",{:?},{:?}", value.re, value.im)
                } else {
                    write!(out, ",{:?}", value.re)
                };
            }
            out += "\r\n";
        }
        out
    }
}

/// In quotes where a comma or a quote would break the field.
fn quoted(text: &str) -> String {
    if text.contains([',', '"']) { format!("\"{}\"", text.replace('"', "\"\"")) } else { text.to_owned() }
}
