//! Published and closed-form results, each with its source on top.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "../support/mod.rs"]
mod support;

mod agreement;
mod gear_pair;
mod independent;
mod overhung_beam;
mod pinned_beam;
mod refusals;
mod torsional_train;
mod turbine_generator;
mod two_disc_rotor;
