//! bevelscope
pub mod agreement;
pub mod comparison;
pub mod design;
pub mod tui;
