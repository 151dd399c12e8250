//! Contacts whose stiffness is a given number, where the contacts of a grain feel each other.

use super::time_step::{Partner, WallPartner, each_contact, in_words, pair_size, smaller_radius};
use crate::materials::Materials;
use crate::particles::Grains;
use demeter_physics::contact::PairSize;
use demeter_physics::contact::multi_contact::{ContactPair, MultiContact, MultiContactVisitor, clearance};
use demeter_physics::contact::normal::{Normal, NormalVisitor};

/// A contact that has no coupled force however small the overlap.
pub(crate) struct TooStiff {
    /// Which bodies, in words.
    pub bodies: String,
    /// Its stiffness [N/m].
    pub stiffness: f64,
    /// The largest stiffness that has a coupled force [N/m].
    pub allowed: f64,
}

/// The contact that is farthest beyond what a grain bears between two like it on opposite sides: of a constant stiffness `K`, where
/// each force `F` displaces the other contact by `A F`, the equation `F = K (overlap + A F)` has a solution for `K A < 1` alone.
pub(crate) fn too_stiff(grains: &Grains, walls: &[WallPartner], materials: &Materials, share: f64) -> Option<TooStiff> {
    let mut worst: Option<TooStiff> = None;
    each_contact(grains, walls, materials, |(a, b), one, other| {
        let law = materials.law(materials.pair(a, b));
        let spring = Spring {
            size: pair_size(one, other),
            overlap: share * smaller_radius(one, other),
        };
        let Some(stiffness) = law.normal.visit(spring) else {
            return;
        };
        let opposite = |of: usize, radius: f64| law.multi_contact[of].visit(Opposite { radius });
        let most = match other {
            Partner::Grain(other) => opposite(0, one.radius).max(opposite(1, other.radius)),
            Partner::Wall { .. } => opposite(0, one.radius),
        };
        let is_worst = |worst: &TooStiff| stiffness * most > worst.stiffness / worst.allowed;
        if stiffness * most >= 1.0 && worst.as_ref().is_none_or(is_worst) {
            worst = Some(TooStiff {
                bodies: in_words(materials, (a, b), other),
                stiffness,
                allowed: 1.0 / most,
            });
        }
    });
    worst
}

/// The stiffness of a law that has one at all overlaps up to this [m].
struct Spring {
    size: PairSize,
    overlap: f64,
}

impl NormalVisitor for Spring {
    type Output = Option<f64>;

    fn visit<L: Normal>(self, law: &L) -> Option<f64> {
        let stiffness = |part: f64| law.stiffness(self.size, part * self.overlap, &vec![0.0; L::HISTORY.len()]);
        let (little, much) = (stiffness(0.01), stiffness(1.0));
        (little > 0.0 && (much / little - 1.0).abs() < 1e-9).then_some(little)
    }
}

/// What a force displaces on the other side of a grain of this radius [m], per force [m/N].
struct Opposite {
    radius: f64,
}

impl MultiContactVisitor for Opposite {
    type Output = f64;

    fn visit<L: MultiContact>(self, law: &L) -> f64 {
        let clear = clearance(self.radius, None);
        law.influence(&ContactPair {
            cosine: -1.0,
            source_lever: self.radius,
            target_lever: self.radius,
            least_distance_squared: clear * clear,
            radius: self.radius,
        })
    }
}
