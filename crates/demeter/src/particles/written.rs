//! Grains as they are written, where one process has them all and where several share them.

use super::{Grains, HigherDerivatives, Load, Row};
use crate::comm::parts::{InParts, Listed, Part};
use glam::DQuat;
use serde::{Serialize, Serializer};

/// The lists of [`Grains`].
#[derive(Serialize)]
#[serde(rename = "Grains")]
struct Written<'a, 'b> {
    id: Listed<'a, 'b, u32>,
    material: Listed<'a, 'b, u16>,
    position: Listed<'a, 'b, Row>,
    velocity: Listed<'a, 'b, Row>,
    angular_velocity: Listed<'a, 'b, Row>,
    orientation: Option<Listed<'a, 'b, DQuat>>,
    load: Listed<'a, 'b, Load>,
    higher: Listed<'a, 'b, HigherDerivatives>,
}

impl InParts for Grains {
    fn in_parts<'a>(&'a self, part: &'a Part<'_>) -> impl Serialize + 'a {
        Written {
            id: part.of_grains(&self.id),
            material: part.of_grains(&self.material),
            position: part.of_grains(self.position.rows()),
            velocity: part.of_grains(self.velocity.rows()),
            angular_velocity: part.of_grains(self.angular_velocity.rows()),
            orientation: self.orientation.as_deref().map(|all| part.of_grains(all)),
            load: part.of_grains(self.load.rows()),
            higher: part.of_grains(&self.higher),
        }
    }
}

impl Serialize for Grains {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.in_parts(&Part::WHOLE).serialize(serializer)
    }
}
