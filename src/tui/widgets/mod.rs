//! The parts of the screen: each draws the state it is given into its area.

pub mod canvas;
pub mod cell_input;
pub mod choice;
pub mod difference_strip;
pub mod editor_header;
pub mod energy_bars;
pub mod figures;
pub mod findings;
pub mod footer;
pub mod header;
pub mod leave;
pub mod library;
pub mod mac_picture;
pub mod matrix;
pub mod mode_shape;
pub mod mode_table;
pub mod panel;
pub mod plot;
pub mod side_view;
pub mod spectrum;
pub mod table;
pub mod tabs;
pub mod text_line;
pub mod text_pane;
pub mod variant_form;
