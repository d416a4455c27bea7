//! The parts of the screen: each draws the state it is given into its area.

pub mod canvas;
pub mod difference_strip;
pub mod figures;
pub mod footer;
pub mod header;
pub mod library;
pub mod panel;
pub mod plot;
pub mod side_view;
pub mod spectrum;
pub mod text_pane;
