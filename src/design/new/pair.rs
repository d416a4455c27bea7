//! The gear pair of a new design: teeth, sizes, angles.

use super::field::Field;
use super::wishes::{Refusal, Wishes};
use crate::design::{Hand, PairKind};
use crate::gear::{self, Cone, HypoidBlank, LightLoad, Pitch, Teeth, mean_mesh_stiffness};

/// A pair whose cones or cylinders are known; SI units and rad, pinion first.
#[derive(Debug, Clone, PartialEq)]
pub struct Pair {
    pub kind: PairKind,
    pub teeth: [u32; 2],
    pub pinion_torque: f64,
    /// rad/s
    pub pinion_speed: f64,
    /// Of bevel and hypoid pairs
    pub gear_outer_diameter: Option<f64>,
    /// Of spur and helical pairs
    pub normal_module: Option<f64>,
    pub face_width: f64,
    /// Mean spiral or helix angles; 0 where the teeth are straight
    pub spiral_angles: [f64; 2],
    /// Offset and mean cutter radius of a hypoid pair
    pub hypoid: Option<(f64, f64)>,
    pub pressure_angle: f64,
    pub hand: Hand,
    pub pitch: Pitch,
    /// Mean pitch diameters
    pub mean_diameters: [f64; 2],
    /// Tangential force at the mean diameters over the effective face width, N/m
    pub specific_load: f64,
    /// N/m along the tooth normal
    pub mesh_stiffness: f64,
}

/// Torsional stress for which shafts are sized where nothing else is asked for, Pa: a designer's choice.
pub(super) const SHAFT_STRESS: f64 = 30e6;

/// Diameter of a solid shaft under a torque (N m) at that stress, m.
pub(super) fn shaft_diameter(torque: f64, stress: f64) -> f64 {
    (16.0 * torque / (std::f64::consts::PI * stress)).cbrt()
}

/// Nominal torsional stress of a solid shaft, Pa: 16 T/(pi d^3).
pub(super) fn torsional_stress(torque: f64, diameter: f64) -> f64 {
    16.0 * torque / (std::f64::consts::PI * diameter.powi(3))
}

/// Share of a wheel's mean diameter that its shaft may have: the mean root circle, 1.25 modules below the pitch circle (ISO 53), and
/// never more than 0.8.
fn share_for_shaft(teeth: u32, spiral_angle: f64) -> f64 {
    (1.0 - 2.5 * spiral_angle.cos() / f64::from(teeth)).min(0.8)
}

/// Sizes of the gear where none are asked for: outer diameter over the cube root of its torque, m/(N m)^(1/3), as of sample 1 of ISO 23509.
const SIZE: f64 = 18.8e-3;

/// Normal modules of ISO 54, series 1, mm.
const MODULES: [f64; 17] = [0.5, 0.6, 0.8, 1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0];

impl Pair {
    pub(super) fn new(wishes: &Wishes) -> Result<Self, Refusal> {
        let kind = wishes.kind();
        let teeth = teeth(wishes)?;
        let basics = Basics { wishes, kind, teeth, ratio: f64::from(teeth[1]) / f64::from(teeth[0]) };
        match kind {
            PairKind::Spur | PairKind::Helical => basics.parallel(),
            PairKind::SpiralBevel | PairKind::StraightBevel => basics.bevel(),
            PairKind::Hypoid => basics.hypoid(),
        }
    }

    /// Teeth of the gear over those of the pinion.
    pub fn ratio(&self) -> f64 {
        f64::from(self.teeth[1]) / f64::from(self.teeth[0])
    }

    /// Torque of a shaft, N m: the pinion's, or the gear's.
    pub fn torque(&self, shaft: usize) -> f64 {
        if shaft == 0 { self.pinion_torque } else { self.pinion_torque * self.ratio() }
    }

    /// Greatest diameter of the shaft under the teeth, m.
    pub fn room_for_shaft(&self, shaft: usize) -> f64 {
        self.mean_diameters[shaft] * share_for_shaft(self.teeth[shaft], self.spiral_angles[shaft])
    }

    /// What makes a pair larger.
    pub(super) fn size_field(&self) -> Field {
        if self.kind.is_parallel() { Field::NormalModule } else { Field::GearOuterDiameter }
    }

    /// Which way the driving pinion turns, its thrust being away from the apex: positively or not.
    pub(super) fn turns_positively(&self) -> bool {
        !(self.kind.has_hand() && self.hand == Hand::Left)
    }

    /// How the axes lie.
    pub(super) fn geometry(&self) -> gear::Pair {
        let sign = |is_positive: bool| if is_positive { 1.0 } else { -1.0 };
        let teeth = Teeth {
            pressure_angle: self.pressure_angle,
            hand: sign(self.hand == Hand::Right),
            turns: sign(self.turns_positively()),
        };
        gear::Pair::new(&teeth, &self.pitch)
    }

    /// Pitch angle, rad, and distance of the mean point from the pitch apex along the axis, m; nothing for cylinders.
    pub fn cone(&self, shaft: usize) -> Option<(f64, f64)> {
        match &self.pitch {
            Pitch::Bevel { cones } => Some((cones[shaft].pitch_angle, cones[shaft].cone_distance))
                .map(|(angle, distance)| (angle, distance * angle.cos())),
            Pitch::Parallel { .. } => None,
        }
    }

    /// How much of a shaft the teeth take up, m.
    pub fn axial_width(&self, shaft: usize) -> f64 {
        self.face_width * self.cone(shaft).map_or(1.0, |(angle, _)| angle.cos())
    }
}

fn teeth(wishes: &Wishes) -> Result<[u32; 2], Refusal> {
    const LARGEST_RATIO: u32 = 10;
    let given = |field| wishes.number(field).map(|number| number as u32);
    let usual = match wishes.kind() {
        PairKind::SpiralBevel | PairKind::StraightBevel => [14, 39],
        PairKind::Hypoid => [13, 42],
        PairKind::Spur | PairKind::Helical => [23, 67],
    };
    let scaled = |teeth: u32, of: u32, to: u32| (f64::from(teeth) * f64::from(to) / f64::from(of)).round() as u32;
    let [pinion, gear] = match (given(Field::PinionTeeth), given(Field::GearTeeth)) {
        (Some(pinion), Some(gear)) => [pinion, gear],
        (Some(pinion), None) => {
            let gear = scaled(pinion, usual[0], usual[1]);
            [pinion, if gear.is_multiple_of(pinion) { gear + 1 } else { gear }]
        }
        (None, Some(gear)) => [scaled(gear, usual[1], usual[0]).clamp(5, 100), gear],
        (None, None) => usual,
    };
    let wrong = |message: String| Err(Refusal::new(Field::GearTeeth, message));
    if gear < pinion {
        return wrong(format!("must be at least the pinion's {pinion} teeth: the pinion is the smaller wheel"));
    }
    if gear > LARGEST_RATIO * pinion {
        return wrong(format!("at most {}: {LARGEST_RATIO} times the pinion's {pinion} teeth", LARGEST_RATIO * pinion));
    }
    if wishes.kind() == PairKind::Hypoid && gear < 2 * pinion {
        return wrong(format!("at least {} for a hypoid pair: twice the pinion's {pinion} teeth", 2 * pinion));
    }
    Ok([pinion, gear])
}

struct Basics<'a> {
    wishes: &'a Wishes,
    kind: PairKind,
    teeth: [u32; 2],
    ratio: f64,
}

/// Up to the next whole millimetre.
fn up_to_millimetre(length: f64) -> f64 {
    (length * 1e3 - 1e-6).ceil() / 1e3
}

fn millimetres(length: f64) -> String {
    format!("{:.1} mm", length * 1e3)
}

impl Basics<'_> {
    fn torque(&self) -> f64 {
        let usual = match self.kind {
            PairKind::Hypoid => 250.0,
            PairKind::SpiralBevel | PairKind::StraightBevel => 300.0,
            PairKind::Spur | PairKind::Helical => 80.0,
        };
        self.wishes.number(Field::PinionTorque).unwrap_or(usual)
    }

    /// Smallest mean diameter of the pinion for which a shaft is found.
    fn smallest_pinion(&self) -> f64 {
        (shaft_diameter(self.torque(), SHAFT_STRESS) / share_for_shaft(self.teeth[0], 0.0)).max(0.026)
    }

    fn angle(&self, field: Field, usual: f64, [low, high]: [f64; 2], of: &str) -> Result<f64, Refusal> {
        let angle = self.wishes.number(field).unwrap_or(usual.to_radians());
        // a limit that was typed may be a rounding off
        if (low - 1e-9..=high + 1e-9).contains(&angle.to_degrees()) {
            return Ok(angle);
        }
        Err(Refusal::new(field, format!("must be from {low} to {high} deg for a {of} pair")))
    }

    fn outer_diameter(&self) -> f64 {
        self.wishes.number(Field::GearOuterDiameter).unwrap_or_else(|| {
            let by_torque = SIZE * (self.torque() * self.ratio).cbrt();
            // the mean diameter is about 0.85 of the outer one
            up_to_millimetre(by_torque.max(self.smallest_pinion() * self.ratio / 0.85))
        })
    }

    fn face_width(&self, usual: f64, [low, high]: [f64; 2], limits: &str) -> Result<f64, Refusal> {
        let width = self.wishes.number(Field::FaceWidth).unwrap_or_else(|| (usual * 1e3).round().max(2.0) / 1e3);
        if (low * (1.0 - 1e-9)..=high * (1.0 + 1e-9)).contains(&width) {
            return Ok(width);
        }
        let [low, high] = [low, high].map(millimetres);
        Err(Refusal::new(Field::FaceWidth, format!("must be from {low} to {high}: {limits}")))
    }

    fn bevel(&self) -> Result<Pair, Refusal> {
        let spiral_angle = match self.kind {
            PairKind::StraightBevel => 0.0,
            _ => self.angle(Field::SpiralAngle, 35.0, [5.0, 50.0], "spiral bevel")?,
        };
        let outer = self.outer_diameter();
        let gear_angle = self.ratio.atan();
        let outer_distance = outer / 2.0 / gear_angle.sin();
        let module = outer / f64::from(self.teeth[1]);
        let width = self.face_width(
            (0.3 * outer_distance).min(10.0 * module),
            [0.05 * outer_distance, 0.4 * outer_distance],
            "0.05 to 0.4 of the outer cone distance",
        )?;
        let cone_distance = outer_distance - width / 2.0;
        let cone = |pitch_angle| Cone { pitch_angle, cone_distance, spiral_angle };
        let cones = [cone(std::f64::consts::FRAC_PI_2 - gear_angle), cone(gear_angle)];
        self.finish(Pitch::Bevel { cones }, width, Some(outer), None)
    }

    fn hypoid(&self) -> Result<Pair, Refusal> {
        let outer = self.outer_diameter();
        let width = self.face_width(0.155 * outer, [0.04 * outer, 0.2 * outer], "0.04 to 0.2 of the outer diameter")?;
        let offset = self.wishes.number(Field::Offset).unwrap_or_else(|| (outer * 100.0).round().max(1.0) / 1e3);
        if !(0.01 * outer..=0.25 * outer).contains(&offset) {
            let limits = [0.01, 0.25].map(|share| millimetres(share * outer));
            let message =
                format!("must be from {} to {}: 1 to 25 % of the gear's outer diameter", limits[0], limits[1]);
            return Err(Refusal::new(Field::Offset, message));
        }
        let usual = (25.0 + 5.0 * self.ratio.sqrt() + 90.0 * offset / outer).min(55.0);
        let pinion_spiral_angle = self.angle(Field::SpiralAngle, usual, [30.0, 60.0], "hypoid")?;
        let blank = HypoidBlank {
            ratio: self.ratio,
            offset,
            gear_outer_diameter: outer,
            face_width: width,
            pinion_spiral_angle,
        };
        let given = self.wishes.number(Field::CutterRadius);
        let found = blank.pitch(given);
        let Some(found) = found.filter(|found| found.cones[0].pitch_angle > 0.03) else {
            let (field, message) = match given.and(blank.pitch(None)) {
                Some(usual) => {
                    let usual = millimetres(usual.cutter_radius);
                    let message =
                        format!("no pitch cones with a gear of at least 45 deg fit this cutter; {usual} would do");
                    (Field::CutterRadius, message)
                }
                None => (Field::Offset, "no pitch cones fit: a smaller offset or a larger spiral angle".into()),
            };
            return Err(Refusal::new(field, message));
        };
        if found.cones[1].spiral_angle < f64::to_radians(10.0) {
            let least = (found.offset_angle.to_degrees() + 10.0).ceil();
            let message =
                format!("leaves the gear less than 10 deg at this offset: at least {least} deg, or less offset");
            return Err(Refusal::new(Field::SpiralAngle, message));
        }
        self.finish(Pitch::Bevel { cones: found.cones }, width, Some(outer), Some((offset, found.cutter_radius)))
    }

    fn parallel(&self) -> Result<Pair, Refusal> {
        let helix_angle = match self.kind {
            PairKind::Helical => self.angle(Field::SpiralAngle, 20.0, [3.0, 45.0], "helical")?,
            _ => 0.0,
        };
        let [pinion, gear] = self.teeth.map(f64::from);
        let module = self.wishes.number(Field::NormalModule).unwrap_or_else(|| {
            let by_torque = SIZE * (self.torque() * self.ratio).cbrt() / gear;
            let wanted = by_torque.max(self.smallest_pinion() / pinion) * helix_angle.cos();
            let listed = MODULES.into_iter().map(|module| module / 1e3).find(|module| *module >= wanted);
            listed.unwrap_or_else(|| up_to_millimetre(wanted))
        });
        let width = self.face_width(10.0 * module, [3.0 * module, 25.0 * module], "3 to 25 times the normal module")?;
        let radii = [pinion, gear].map(|teeth| teeth * module / helix_angle.cos() / 2.0);
        let pitch = Pitch::Parallel { radii, helix_angle };
        Ok(Pair { normal_module: Some(module), ..self.finish(pitch, width, None, None)? })
    }

    fn finish(
        &self,
        pitch: Pitch,
        face_width: f64,
        gear_outer_diameter: Option<f64>,
        hypoid: Option<(f64, f64)>,
    ) -> Result<Pair, Refusal> {
        let (spiral_angles, mean_diameters) = match &pitch {
            Pitch::Bevel { cones } => (
                cones.map(|cone| cone.spiral_angle),
                cones.map(|cone| 2.0 * cone.cone_distance * cone.pitch_angle.sin()),
            ),
            Pitch::Parallel { radii, helix_angle } => ([*helix_angle; 2], radii.map(|radius| 2.0 * radius)),
        };
        let mean_angle = f64::midpoint(spiral_angles[0], spiral_angles[1]);
        let effective_width = effective_face_width(self.kind, face_width);
        let specific_load = 2.0 * self.torque() / mean_diameters[0] / effective_width;
        let light_load = if self.kind.is_parallel() { LightLoad::Cylindrical } else { LightLoad::Bevel };
        let full_stiffness = mean_mesh_stiffness(effective_width, mean_angle)
            .map_err(|error| Refusal::new(Field::FaceWidth, error.to_string()))?;
        Ok(Pair {
            kind: self.kind,
            teeth: self.teeth,
            pinion_torque: self.torque(),
            pinion_speed: self.wishes.number(Field::PinionSpeed).unwrap_or(1200.0 * std::f64::consts::PI / 30.0),
            gear_outer_diameter,
            normal_module: None,
            face_width,
            spiral_angles,
            hypoid,
            pressure_angle: self.angle(Field::PressureAngle, 20.0, [12.0, 32.0], self.kind.word())?,
            hand: if self.wishes.word(Field::Hand) == Some(Hand::Left.word()) { Hand::Left } else { Hand::Right },
            pitch,
            mean_diameters,
            specific_load,
            mesh_stiffness: full_stiffness * light_load.factor(specific_load),
        })
    }
}

/// ISO 10300-1 counts 0.85 of a bevel gear's face; of a cylindrical gear all of it carries.
pub(super) fn effective_face_width(kind: PairKind, face_width: f64) -> f64 {
    if kind.is_parallel() { face_width } else { 0.85 * face_width }
}
