//! Whole screens.

pub mod editor;
pub mod explorer;
