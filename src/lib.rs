//! bevelscope
pub mod agreement;
pub mod commands;
pub mod comparison;
pub mod design;
pub mod model;
pub mod report;
pub mod response;
pub mod rotor;
pub mod text;
pub mod tui;
pub mod units;
