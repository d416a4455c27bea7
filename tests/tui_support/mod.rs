//! Made-up designs and spectra for the tests of the explorer: plausible to look at, and the same on every machine.
#![allow(dead_code, reason = "each test uses its own part")]
#![allow(clippy::unwrap_used, clippy::format_push_string, reason = "helpers of tests")]

mod every_key;
mod shelf;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Duration;

use bevelscope::agreement::Agreement;
use bevelscope::comparison::{Comparison, Observer, SolveError, Spectrum};
use bevelscope::design::Side;
use bevelscope::design::{
    Analysis, BeamTheory, Bearing, BearingModel, Body, DampingModel, Design, DiagonalBearing, Drive, FrequencySpacing,
    Hold, Mesh, MeshVectors, RotorDesign, Segment,
};
use bevelscope::model::{Rotors, RotorsError};
use bevelscope::rotor::{Motion, RotorError};
use bevelscope::tui::app::App;
use bevelscope::tui::caps::{Background, Capabilities, ColourDepth};
use bevelscope::tui::compare;
use bevelscope::tui::message::{Effect, Message};
use bevelscope::tui::modes;
use bevelscope::tui::solving::{EditedJob, Job};
use bevelscope::tui::spectra::{self, Part, SpectraJob};
use bevelscope::tui::{Backend, BrokenDesign, LoadedDesign, view};
use bevelscope::tui::{file_jobs, solving};
use num_complex::Complex64;
use ratatui::Terminal;
use ratatui::backend::TestBackend;
use ratatui::buffer::{Buffer, Cell};
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use ratatui::style::{Color, Modifier};
use unicode_width::UnicodeWidthStr;

#[allow(unused_imports, reason = "each test uses its own part")]
pub use every_key::dead_keys;
#[allow(unused_imports, reason = "each test uses its own part")]
pub use shelf::Shelf;

/// The designs of [`MadeUp`], in the order of the library.
pub const STEMS: [&str; 6] =
    ["overhung-elastic", "overhung-rigid", "straddle-elastic", "typo-in-bearing", "unsolvable", "warned"];

/// A library without files: what a design is follows from its path.
#[derive(Debug, Default)]
pub struct MadeUp;

impl Backend for MadeUp {
    fn load(&self, path: &Path) -> Result<LoadedDesign, BrokenDesign> {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy();
        if stem.starts_with("typo") {
            return Err(BrokenDesign { one_line: "line 14: unknown key".into(), full_text: broken_text() });
        }
        let mut loaded = LoadedDesign::from(design(&stem));
        if stem == "warned" {
            loaded.warnings.push("the polar inertia of \"head\" is over twice the diametral one".into());
            loaded.warnings.push("torque arms contradict the tooth numbers by 3 %".into());
        }
        Ok(loaded)
    }

    fn compare(&self, design: &Design, _: &mut Observer<'_>) -> Result<Comparison, SolveError> {
        if design.name.starts_with("unsolvable") {
            return Err(not_solved(RotorError::Unsupported(vec![Motion::ThX])));
        }
        Ok(comparison(design))
    }
}

/// Why the gear shaft of a design cannot be solved.
pub fn not_solved(error: RotorError) -> SolveError {
    SolveError::Rotors(RotorsError(vec![(Side::Gear, error)]))
}

/// The paths of a made-up library.
pub fn paths(stems: &[&str]) -> Vec<PathBuf> {
    stems.iter().map(|stem| PathBuf::from(format!("/designs/{stem}.toml"))).collect()
}

fn broken_text() -> String {
    "designs/typo-in-bearing.toml:14:1: pinion.bearing[0].kq_n_per_m: unknown key\n\n\
     \x20  13 | model = \"diagonal\"\n\
     \x20  14 | kq_n_per_m = 6e8\n\
     \x20     | ^^^^^^^^^^\n\n\
     A bearing with model \"diagonal\" has the keys name, position_mm, axial_series_stiffness_n_per_m, kx_n_per_m, \
     ky_n_per_m, kz_n_per_m, krx_n_m_per_rad and krz_n_m_per_rad.\n\nDid you mean kx_n_per_m?"
        .into()
}

/// A design of plausible size.
pub fn design(stem: &str) -> Design {
    let rigid = stem.contains("rigid");
    Design {
        name: match stem {
            "overhung-elastic" => "Overhung pinion and gear, elastic bearings".into(),
            "overhung-rigid" => "Overhung pinion and gear, rigid bearings".into(),
            other => format!("{other} (made up)"),
        },
        description: None,
        tags: Vec::new(),
        parent: None,
        note: None,
        operating: None,
        analysis: Analysis {
            frequency_min: 10.0,
            frequency_max: 5000.0,
            frequency_lines: 1000,
            frequency_spacing: if stem.contains("log") { FrequencySpacing::Log } else { FrequencySpacing::Linear },
            structural_damping: 0.03,
            damping_model: DampingModel::Hysteretic,
            beam_theory: BeamTheory::Timoshenko,
        },
        materials: BTreeMap::new(),
        mesh: Mesh {
            stiffness: 1.5e8,
            damping: 0.06,
            transmission_error: 1e-6,
            pinion: MeshVectors { point: [0.0256, 0.0, 0.0], line_of_action: [-0.197, 0.608, 0.770] },
            gear: MeshVectors { point: [-0.0998, 0.0, 0.0], line_of_action: [-0.608, -0.197, 0.770] },
            geometry: None,
        },
        pinion: RotorDesign {
            teeth: Some(10),
            mesh_position: 0.020,
            housing_axial_stiffness: None,
            segments: vec![segment(0.130, 0.042, 0.0), segment(0.050, 0.030, 0.0)],
            bodies: vec![body("head", 0.020, 1.6, 7.0e-4, 9.0e-4)],
            bearings: vec![bearing("B1", 0.060, rigid), bearing("B2", 0.130, rigid)],
            drive: Some(Drive { position: 0.180, torsional_stiffness: 1.2e4, inertia: 0.02 }),
        },
        gear: RotorDesign {
            teeth: Some(39),
            mesh_position: 0.040,
            housing_axial_stiffness: None,
            segments: vec![segment(0.060, 0.060, 0.0), segment(0.140, 0.090, 0.060)],
            bodies: vec![body("ring", 0.045, 9.0, 0.030, 0.058)],
            bearings: vec![bearing("B1", 0.085, rigid), bearing("B2", 0.170, rigid)],
            drive: Some(Drive { position: 0.200, torsional_stiffness: 3.0e4, inertia: 0.1 }),
        },
    }
}

fn segment(length: f64, outer_diameter: f64, inner_diameter: f64) -> Segment {
    Segment { length, outer_diameter, inner_diameter, material: "steel".into(), elements: 4 }
}

fn body(name: &str, position: f64, mass: f64, diametral_inertia: f64, polar_inertia: f64) -> Body {
    Body { name: name.into(), position, mass, diametral_inertia, polar_inertia }
}

fn bearing(name: &str, position: f64, rigid: bool) -> Bearing {
    let model = if rigid {
        BearingModel::Rigid(Hold { x: true, y: true, z: true })
    } else {
        BearingModel::Diagonal(DiagonalBearing { kx: 6e8, ky: 2e8, kz: 6e8, krx: 2e5, krz: 2e5 })
    };
    Bearing { name: name.into(), position, axial_series_stiffness: None, model }
}

/// Resonances of the finite element model: frequency in Hz, weight. The lumped models have the first ones.
const RESONANCES: [(f64, f64); 7] =
    [(96.0, 30.0), (520.0, 90.0), (1180.0, 260.0), (2090.0, 420.0), (2750.0, 260.0), (3420.0, 520.0), (4480.0, 300.0)];

/// Spectra with a few resonances each.
pub fn comparison(design: &Design) -> Comparison {
    let analysis = &design.analysis;
    let last = (analysis.frequency_lines - 1) as f64;
    let frequency_hz: Vec<f64> = (0..analysis.frequency_lines)
        .map(|line| line as f64 / last)
        .map(|part| match analysis.frequency_spacing {
            FrequencySpacing::Linear => {
                analysis.frequency_min + (analysis.frequency_max - analysis.frequency_min) * part
            }
            FrequencySpacing::Log => {
                analysis.frequency_min * (analysis.frequency_max / analysis.frequency_min).powf(part)
            }
        })
        .collect();
    let spectrum = |shift: f64, modes: usize, coordinates: usize| {
        let force = |frequency: f64| {
            let loss = Complex64::new(1.0, 0.04);
            // what the missing resonances would add when the mesh is loaded slowly
            let rest: f64 = RESONANCES[modes..].iter().map(|(_, weight)| weight).sum();
            RESONANCES[..modes].iter().enumerate().fold(
                Complex64::new(rest - 900.0, 0.0),
                |sum, (at, (centre, weight))| {
                    let centre = centre * (1.0 + shift * at as f64 * at as f64);
                    sum + weight * centre * centre / (centre * centre * loss - frequency * frequency)
                },
            )
        };
        let mesh_force: Vec<Complex64> = frequency_hz.iter().map(|&frequency| force(frequency)).collect();
        Spectrum { transmission_error: mesh_force.iter().map(|force| force / 1.5e8).collect(), mesh_force, coordinates }
    };
    let (fe, enhanced, basic) = (spectrum(0.0, 7, 92), spectrum(0.0005, 5, 14), spectrum(0.02, 3, 14));
    Comparison {
        frequency_hz,
        fe,
        enhanced,
        basic,
        enhanced_agreement: agreement(
            3.72,
            12.7,
            3412.0,
            0.56,
            if design.name.contains("rigid") { 3364.0 } else { 2997.0 },
        ),
        basic_agreement: agreement(10.13, 31.0, 4980.0, 0.12, 236.0),
        caveats: Vec::new(),
    }
}

fn agreement(rms_db: f64, max_db: f64, max_at_hz: f64, frac: f64, agreement_limit_hz: f64) -> Agreement {
    Agreement { rms_db, max_db, max_at_hz, frac, agreement_limit_hz, peaks: Vec::new() }
}

/// The explorer on a made-up terminal. Work in the background is done at once, unless it is held.
pub struct Screen {
    pub app: App,
    pub terminal: Terminal<TestBackend>,
    backend: Box<dyn Backend>,
    /// Effects are collected and not carried out.
    pub held: bool,
    pub effects: Vec<Effect>,
    /// Of the edit before
    rotors: Option<Rotors>,
}

/// What the tests ask of the made-up terminal.
pub const UNICODE: Capabilities =
    Capabilities { colour: ColourDepth::Sixteen, background: Background::Unknown, ascii: false };
pub const ASCII: Capabilities = Capabilities { ascii: true, ..UNICODE };

impl Screen {
    /// The made-up library, all of it read and solved.
    pub fn new(width: u16, height: u16, capabilities: Capabilities) -> Self {
        Self::with(&STEMS, width, height, capabilities, MadeUp)
    }

    pub fn with(
        stems: &[&str],
        width: u16,
        height: u16,
        capabilities: Capabilities,
        backend: impl Backend + 'static,
    ) -> Self {
        Self::start(Self::before_start(stems, width, height, capabilities, backend))
    }

    /// A library of files, all of it read and solved.
    pub fn over(paths: Vec<PathBuf>, width: u16, height: u16, backend: impl Backend + 'static) -> Self {
        Self::start(Self::unstarted(paths, width, height, UNICODE, backend))
    }

    fn start(mut screen: Self) -> Self {
        let effects = screen.app.start();
        screen.carry_out(effects);
        screen.draw();
        screen
    }

    /// The first frame: nothing is read yet.
    pub fn before_start(
        stems: &[&str],
        width: u16,
        height: u16,
        capabilities: Capabilities,
        backend: impl Backend + 'static,
    ) -> Self {
        Self::unstarted(paths(stems), width, height, capabilities, backend)
    }

    fn unstarted(
        paths: Vec<PathBuf>,
        width: u16,
        height: u16,
        capabilities: Capabilities,
        backend: impl Backend + 'static,
    ) -> Self {
        let app = App::new(paths, "~/designs".into(), capabilities);
        let terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
        let mut screen =
            Self { app, terminal, backend: Box::new(backend), held: false, effects: Vec::new(), rotors: None };
        screen.draw();
        screen
    }

    pub fn draw(&mut self) {
        self.terminal.draw(|frame| view::draw(&mut self.app, frame)).unwrap();
    }

    pub fn resize(&mut self, width: u16, height: u16) {
        self.terminal.backend_mut().resize(width, height);
        self.send(Message::Resized);
    }

    pub fn send(&mut self, message: Message) {
        let effects = self.app.update(message);
        self.carry_out(effects);
        self.draw();
        let effects = self.app.after_frame();
        self.carry_out(effects);
    }

    fn carry_out(&mut self, effects: Vec<Effect>) {
        for effect in effects {
            let jobs = match &effect {
                Effect::Solve(job) => vec![job.clone()],
                Effect::Fill(jobs) => jobs.clone(),
                _ => Vec::new(),
            };
            let edited = if let Effect::SolveEdited(job) = &effect { Some(job.clone()) } else { None };
            if let Effect::Keep(change) = &effect {
                self.backend.keep(change).unwrap();
            }
            let spectra = if let Effect::Spectra(job) = &effect { Some(job.clone()) } else { None };
            let file = if let Effect::File(job) = &effect { Some(job.clone()) } else { None };
            let message = if self.held { None } else { self.message(&effect) };
            self.effects.push(effect);
            if let Some(message) = message {
                let effects = self.app.update(message);
                self.carry_out(effects);
            }
            if !self.held {
                for job in &jobs {
                    self.perform(job);
                }
                if let Some(job) = &edited {
                    self.perform_edited(job);
                }
                if let Some(job) = spectra {
                    self.perform_spectra(*job);
                }
            }
            if let Some(message) = file.and_then(|job| file_jobs::perform_file(job, &*self.backend)) {
                let effects = self.app.update(message);
                self.carry_out(effects);
            }
        }
    }

    /// What comes back for an effect that is no job.
    fn message(&self, effect: &Effect) -> Option<Message> {
        match effect {
            Effect::ChangeFile(request) => Some(solving::change_file(request.clone(), &*self.backend)),
            Effect::Compare(job) => {
                let result = Box::new(compare::perform(job, &*self.backend, &|| true)?);
                Some(Message::Compared { ticket: job.ticket, result })
            }
            Effect::Modes(job) => modes::perform(job, &*self.backend, &|| true),
            Effect::List => self.backend.list().map(Message::Listed),
            _ => None,
        }
    }

    /// Does one job and takes in its results.
    pub fn perform(&mut self, job: &Job) {
        let mut messages = Vec::new();
        solving::perform(job, &*self.backend, &mut |message| messages.push(message));
        for mut message in messages {
            if let Message::Solved { result: Ok(solved), .. } = &mut message {
                // the only thing that differs from run to run
                solved.summary.elapsed = Duration::from_micros(640);
            }
            let effects = self.app.update(message);
            self.carry_out(effects);
        }
    }

    /// Solves an edited design and takes in the result.
    pub fn perform_edited(&mut self, job: &EditedJob) {
        let mut messages = Vec::new();
        solving::perform_edited(job, &*self.backend, &mut self.rotors, &|| true, &mut |message| messages.push(message));
        for message in messages {
            let effects = self.app.update(message);
            self.carry_out(effects);
        }
    }

    /// Solves what the wide screen shows and takes in all parts.
    pub fn perform_spectra(&mut self, job: SpectraJob) {
        let mut messages = Vec::new();
        spectra::perform(job, &*self.backend, &|| true, &mut |message| messages.push(message));
        for message in messages {
            // how long it takes differs from run to run
            if !matches!(&message, Message::Spectra { part, .. } if matches!(**part, Part::Progress(_))) {
                let effects = self.app.update(message);
                self.carry_out(effects);
            }
        }
    }

    /// Presses keys: single letters, or names in angle brackets, e.g. `jj<Tab>/rigid<Enter>`.
    pub fn keys(&mut self, script: &str) -> &mut Self {
        let mut rest = script;
        while let Some(first) = rest.chars().next() {
            let named = rest.strip_prefix('<').and_then(|name| name.split_once('>'));
            let event = if let Some((name, after)) = named {
                rest = after;
                named_key(name)
            } else {
                rest = &rest[first.len_utf8()..];
                KeyEvent::from(KeyCode::Char(first))
            };
            self.send(Message::Key(event));
        }
        self
    }

    pub fn buffer(&self) -> &Buffer {
        self.terminal.backend().buffer()
    }

    /// The lines of the screen.
    pub fn text(&self) -> String {
        (0..self.buffer().area.height).map(|at| self.line(at) + "\n").collect()
    }

    /// One line of the screen, from above.
    pub fn line(&self, at: u16) -> String {
        let width = usize::from(self.buffer().area.width);
        let row = &self.buffer().content()[usize::from(at) * width..][..width];
        // what stands behind a wide character is not drawn
        let mut hidden = 0;
        let shown = row.iter().filter(|cell| {
            let draw = hidden == 0;
            hidden = if draw { cell.symbol().width().max(1) - 1 } else { hidden - 1 };
            draw
        });
        shown.map(Cell::symbol).collect::<String>().trim_end().to_owned()
    }

    /// The lines of the screen with a letter for the style of each cell, and what the letters mean.
    pub fn styles(&self) -> String {
        let mut found: Vec<(Color, Color, Modifier)> = Vec::new();
        let mut grid = String::new();
        for row in self.buffer().content().chunks(usize::from(self.buffer().area.width).max(1)) {
            for cell in row {
                let style = (cell.fg, cell.bg, cell.modifier);
                let at = found.iter().position(|other| *other == style).unwrap_or_else(|| {
                    found.push(style);
                    found.len() - 1
                });
                grid.push(char::from(b'a' + u8::try_from(at).unwrap()));
            }
            grid.push('\n');
        }
        for (at, (front, back, modifier)) in found.iter().enumerate() {
            grid.push_str(&format!(
                "{}: {front} on {back} {modifier:?}\n",
                char::from(b'a' + u8::try_from(at).unwrap())
            ));
        }
        grid
    }

    /// The row of the library that is marked as selected.
    pub fn selected(&self) -> String {
        self.app.library.selected().map_or(String::new(), |row| row.stem.clone())
    }
}

fn named_key(name: &str) -> KeyEvent {
    let code = match name {
        "Enter" => KeyCode::Enter,
        "Esc" => KeyCode::Esc,
        "Tab" => KeyCode::Tab,
        "Backspace" => KeyCode::Backspace,
        "Up" => KeyCode::Up,
        "Down" => KeyCode::Down,
        "Left" => KeyCode::Left,
        "Right" => KeyCode::Right,
        "Home" => KeyCode::Home,
        "End" => KeyCode::End,
        "PgUp" => KeyCode::PageUp,
        "PgDn" => KeyCode::PageDown,
        "S-Tab" => KeyCode::BackTab,
        "Delete" => KeyCode::Delete,
        function if function.starts_with('F') => KeyCode::F(function[1..].parse().unwrap()),
        other => {
            let letter = other.strip_prefix("Ctrl-").and_then(|rest| rest.chars().next()).unwrap();
            return KeyEvent::new(KeyCode::Char(letter), KeyModifiers::CONTROL);
        }
    };
    KeyEvent::from(code)
}
