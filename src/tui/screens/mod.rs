//! Whole screens.

pub mod explorer;
