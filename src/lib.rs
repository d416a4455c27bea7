//! Spiral bevel geared rotor designs: a dynamic finite element model and two lumped models side by side.
//!
//! The formulation is that of J. Hua, T. C. Lim, T. Peng and Y. E. Wali (2012), "Dynamic analysis of spiral bevel geared rotor
//! systems applying finite elements and enhanced lumped parameters", International Journal of Automotive Technology 13, with
//! its slips corrected. The program is a terminal explorer and a set of commands over this library.
//!
//! # One way through
//!
//! ```text
//! design file ─> Design ─> Rotor ─> Model ─> Spectrum, Modes ─> Agreement ─> screen | table | file
//! ```
//!
//! A changed bearing enters on the left and comes out on the right as a moved peak. Nothing on the right knows how it is shown,
//! nothing on the left knows that there is a screen.
//!
//! | module | what it holds | where in the paper |
//! | --- | --- | --- |
//! | [`gear`] | gear data to mesh points, lines of action, tooth forces | |
//! | [`bearing`] | ball and roller bearings: loads, stiffness, equilibrium (Lim and Singh) | 2 |
//! | [`design`] | what the user writes: one schema, reading, findings, key paths, edits, new designs, the library, journals and locks | |
//! | [`pair`] | the gear pair of a design: forces on both shafts, pictures to scale, stiffness estimate, import of mesh numbers | |
//! | [`rotor`] | one shaft: stations, beams, bearings, static stiffness at the mesh, first bending modes | 2, 3.1, 3.2.1 |
//! | [`model`] | the finite element, lumped and reduced models as one small struct {K, M, h, damping} | 2, 3.1, 3.2 |
//! | [`response`] | the exact shortcut to the mesh force, the direct solve, modes with the mesh, forces of the bearings | 2, 4 |
//! | [`agreement`] | differences in dB, the agreement limit, peaks and modes paired, bands of disagreement and their causes | 4 |
//! | [`comparison`] | all of that for a design, in one call | |
//! | [`document`] | what a screen shows, as data for files | |
//! | [`report`] | results as tables, CSV and JSON, SVG pictures and HTML pages | |
//! | [`commands`] | the command line, one file a subcommand | |
//! | [`tui`] | the terminal explorer | |
//! | [`log`], [`crash`] | what happened, for `--log`; the report of a mistake in the program | |
//! | [`units`], [`text`], [`moment`] | quantities and times at the edges; foreign text made harmless | |
//!
//! ```
//! use bevelscope::{comparison::compare, design::{library::SHIPPED, read}};
//!
//! let design = read(SHIPPED[0].text).design.expect("a shipped design is valid");
//! let comparison = compare(&design)?;
//! let agreement = &comparison.enhanced_agreement;
//! println!("trust the enhanced model up to {:.0} Hz", agreement.agreement_limit_hz);
//! # assert_eq!(agreement.agreement_limit_hz.round(), 2997.0);
//! # Ok::<(), bevelscope::comparison::SolveError>(())
//! ```
//!
//! # Invariants
//!
//! Each is held by a test.
//!
//! - Nothing outside `src/tui` names ratatui or crossterm (`tests/invariants.rs`).
//! - No file, terminal or thread in `bearing`, `gear`, `rotor`, `model`, `response` and `agreement` (`tests/invariants.rs`).
//! - Inside the program a number is SI, a frequency in Hz or rad/s as its name says; every number that leaves it has a unit in
//!   its key or header (`tests/invariants.rs`, `tests/cli.rs`).
//! - The exact shortcut and the direct solve agree on every model (`tests/properties`).
//! - The forces of bearings, mesh and drive on a shaft are what accelerates its mass (`tests/bearing_forces.rs`).
//! - Loads of a bearing are the gradient of one convex energy, its stiffness the derivative of the loads (`tests/bearing`).
//! - A mean state is found again only where something that it depends on has changed (`tests/mean_states.rs`, `tests/tui_bearings.rs`).
//! - A bearing without contact has no stiffness matrix: it is an error (`tests/bearing`, `tests/mean_states.rs`).
//! - What the teeth push on one shaft pushes back on the other (`tests/pair.rs`).
//! - The mesh does not notice a rigid motion of the whole pair (`tests/gear.rs`).
//! - A [`rotor::Rotor`] that exists is held, and its statics are known; a [`design::Design`] that was read has passed every check that needs no
//!   mechanics (`tests/design_files.rs`, `tests/properties`).
//! - A new design that is proposed has no finding and solves under its torque (`tests/new_designs.rs`).
//! - An edit changes the bytes that it is about and no others; undone, it gives the file back byte for byte
//!   (`tests/design_edit_properties.rs`).
//! - Every field of the schema can be seen and edited as a cell (`tests/design_grid.rs`).
//! - Who reads a file while it is saved sees the old one or the new one (`tests/design_saving.rs`).
//! - An accepted edit survives the program, however it ends (`tests/terminal_recovery.rs`, `tests/recovery_journal.rs`).
//! - What somebody else has saved is never overwritten unseen (`tests/tui_recovery.rs`, `tests/recovery_journal.rs`).
//! - No `unwrap` and no `panic!` outside tests (`tests/invariants.rs`, and the lints in `Cargo.toml`).
//! - No control character of a file reaches a terminal (`tests/cli.rs`, `tests/tui_robust.rs`).
//! - A frame is one synchronized update; where nothing has changed, nothing is written (`tests/tui_line.rs`,
//!   `tests/terminal_jobs.rs`). With `--ascii` no byte beyond 127 is (`tests/terminal_jobs.rs`).

pub mod agreement;
pub mod bearing;
pub mod commands;
pub mod comparison;
pub mod crash;
pub mod design;
pub mod document;
pub mod gear;
pub mod log;
pub mod model;
pub mod moment;
pub mod number;
pub mod pair;
pub mod report;
pub mod response;
pub mod rotor;
pub mod text;
pub mod tui;
pub mod units;
