//! Names of the models.

use std::borrow::Cow;
use std::str::FromStr;

/// A model of a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ModelKind {
    /// Dynamic finite element model, section 2 of Hua et al. (2012)
    Fe,
    /// Lumped model with effective masses from the first bending modes, section 3.2
    Enhanced,
    /// Lumped model with the rotors' whole masses, "previous" in the paper
    Basic,
    /// Each rotor reduced to its mesh station, its drive if any and this many fixed-interface modes (Craig and Bampton 1968)
    Reduced(usize),
}

impl ModelKind {
    /// The models that are always solved side by side.
    pub const ALL: [Self; 3] = [Self::Fe, Self::Enhanced, Self::Basic];

    /// Name in files and in their columns: `fe`, `enhanced`, `basic`, `reduced_3`.
    pub fn name(self) -> Cow<'static, str> {
        match self {
            Self::Fe => "fe".into(),
            Self::Enhanced => "enhanced".into(),
            Self::Basic => "basic".into(),
            Self::Reduced(modes) => format!("reduced_{modes}").into(),
        }
    }

    /// Name in headings.
    pub fn title(self) -> Cow<'static, str> {
        match self {
            Self::Fe => "Finite element model".into(),
            Self::Enhanced => "Enhanced lumped model".into(),
            Self::Basic => "Basic lumped model".into(),
            Self::Reduced(0) => "Reduced model, static shapes alone".into(),
            Self::Reduced(1) => "Reduced model, 1 fixed-interface mode a rotor".into(),
            Self::Reduced(modes) => format!("Reduced model, {modes} fixed-interface modes a rotor").into(),
        }
    }
}

/// Text that names no model.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error(
    "there are fe, enhanced, basic and reduced:K, K the number of fixed-interface modes a rotor, such as reduced:3"
)]
pub struct UnknownModel;

/// As on the command line: `fe`, `enhanced`, `basic`, `reduced:3`; the spelling of [`ModelKind::name`] is understood too.
impl FromStr for ModelKind {
    type Err = UnknownModel;

    fn from_str(text: &str) -> Result<Self, UnknownModel> {
        if let Some(kind) = Self::ALL.into_iter().find(|kind| kind.name() == text) {
            return Ok(kind);
        }
        let count = text.strip_prefix("reduced:").or_else(|| text.strip_prefix("reduced_")).ok_or(UnknownModel)?;
        // a plain number: no sign, no blanks
        let plain = !count.is_empty() && count.bytes().all(|byte| byte.is_ascii_digit());
        count.parse().ok().filter(|_| plain).map(Self::Reduced).ok_or(UnknownModel)
    }
}

#[cfg(test)]
mod tests {
    use super::{ModelKind, UnknownModel};

    #[test]
    fn names_are_read_as_they_are_written() {
        for kind in ModelKind::ALL.into_iter().chain([ModelKind::Reduced(0), ModelKind::Reduced(12)]) {
            assert_eq!(kind.name().parse(), Ok(kind));
        }
        assert_eq!("reduced:3".parse(), Ok(ModelKind::Reduced(3)));
        for wrong in ["", "FE", "reduced", "reduced:", "reduced:-1", "reduced:+1", "reduced: 1", "reduced:1.0", "fem"] {
            assert_eq!(wrong.parse::<ModelKind>(), Err(UnknownModel), "{wrong}");
        }
        assert!("reduced:99999999999999999999999".parse::<ModelKind>().is_err());
    }
}
