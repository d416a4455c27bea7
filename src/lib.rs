//! bevelscope
pub mod agreement;
pub mod comparison;
pub mod design;
pub mod model;
pub mod response;
pub mod rotor;
pub mod text;
pub mod units;
