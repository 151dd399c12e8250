//! Bounding-volume hierarchy: which triangles of a mesh, or which of many walls, are near a point.

use glam::DVec3;

/// Most items in a leaf.
const LEAF: usize = 4;
/// Deepest level: halving 2^32 triangles ends far above it.
const DEEPEST: usize = 64;

/// Binary tree of boxes around items, which are told by their numbers: built by halving along the longest side of the centroids. It depends
/// on nothing but the order of the items.
#[derive(Clone, Debug)]
pub(super) struct Hierarchy {
    /// Nodes in depth-first order: the left child of a node follows it.
    nodes: Vec<Node>,
    /// Items, grouped by leaf.
    order: Vec<u32>,
}

#[derive(Clone, Debug)]
struct Node {
    lower: DVec3,
    upper: DVec3,
    /// Leaf: first entry of `order`. Inner node: the right child.
    start: u32,
    /// Leaf: number of items. Inner node: 0.
    count: u32,
}

impl Node {
    /// Squared distance of a point from the box.
    #[inline]
    fn distance_squared(&self, point: DVec3) -> f64 {
        (self.lower - point)
            .max(point - self.upper)
            .max(DVec3::ZERO)
            .length_squared()
    }
}

impl Hierarchy {
    /// A tree of items, one for each centroid; `bounds` tells the box around an item.
    pub(super) fn new(centroids: &[DVec3], bounds: impl Fn(u32) -> (DVec3, DVec3)) -> Self {
        let mut tree = Hierarchy {
            nodes: Vec::new(),
            order: (0..centroids.len() as u32).collect(),
        };
        let mut order = std::mem::take(&mut tree.order);
        tree.build(&mut order, 0, centroids, &bounds);
        tree.order = order;
        tree
    }

    fn build(
        &mut self,
        order: &mut [u32],
        offset: usize,
        centroids: &[DVec3],
        bounds: &impl Fn(u32) -> (DVec3, DVec3),
    ) {
        let (mut lower, mut upper) = (DVec3::MAX, DVec3::MIN);
        let (mut least, mut most) = (DVec3::MAX, DVec3::MIN);
        for &id in order.iter() {
            let (low, high) = bounds(id);
            (lower, upper) = (lower.min(low), upper.max(high));
            let centroid = centroids[id as usize];
            (least, most) = (least.min(centroid), most.max(centroid));
        }
        let node = self.nodes.len();
        self.nodes.push(Node {
            lower,
            upper,
            start: offset as u32,
            count: order.len() as u32,
        });
        if order.len() <= LEAF {
            return;
        }
        let axis = longest_axis(most - least);
        let middle = order.len() / 2;
        order.select_nth_unstable_by(middle, |&a, &b| {
            centroids[a as usize][axis]
                .total_cmp(&centroids[b as usize][axis])
                .then(a.cmp(&b))
        });
        let (left, right) = order.split_at_mut(middle);
        left.sort_unstable();
        right.sort_unstable();
        self.build(left, offset, centroids, bounds);
        self.nodes[node].start = self.nodes.len() as u32;
        self.nodes[node].count = 0;
        self.build(right, offset + middle, centroids, bounds);
    }

    pub(super) fn bounds(&self) -> (DVec3, DVec3) {
        (self.nodes[0].lower, self.nodes[0].upper)
    }

    /// Calls `visit` with every item whose box is within `reach` of a point, until it returns `true`; tells whether
    /// it did.
    #[inline]
    pub(super) fn any_near(&self, point: DVec3, reach: f64, visit: impl FnMut(u32) -> bool) -> bool {
        // Room for the rounding of the distances that follow.
        let limit = reach * reach * (1.0 + 1e-9);
        self.any_in(|node| node.distance_squared(point) <= limit, visit)
    }

    /// Calls `visit` with every item of a leaf whose box meets the box given.
    pub(super) fn visit_box(&self, lower: DVec3, upper: DVec3, mut visit: impl FnMut(u32)) {
        let meets = |node: &Node| node.lower.cmple(upper).all() && node.upper.cmpge(lower).all();
        self.any_in(meets, |item| {
            visit(item);
            false
        });
    }

    /// Calls `visit` with every item of the leaves that are asked for, until it returns `true`; tells whether it did.
    #[inline(always)]
    fn any_in(&self, is_asked_for: impl Fn(&Node) -> bool, mut visit: impl FnMut(u32) -> bool) -> bool {
        let mut waiting = [0u32; DEEPEST];
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let index = waiting[depth];
            let node = &self.nodes[index as usize];
            if !is_asked_for(node) {
                continue;
            }
            if node.count == 0 {
                waiting[depth] = node.start;
                waiting[depth + 1] = index + 1;
                depth += 2;
                continue;
            }
            let leaf = node.start as usize..(node.start + node.count) as usize;
            if self.order[leaf].iter().any(|&item| visit(item)) {
                return true;
            }
        }
        false
    }

    /// The least of the distances that `distance` tells of the items, no more than `limit`; it is asked only of items that may be closer
    /// than all before, and told how close these are.
    pub(super) fn least_distance(&self, point: DVec3, limit: f64, mut distance: impl FnMut(u32, f64) -> f64) -> f64 {
        let mut least = limit;
        let mut waiting = [(0.0, 0u32); DEEPEST];
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            let (squared, index) = waiting[depth];
            if squared > least * least {
                continue;
            }
            let node = &self.nodes[index as usize];
            if node.count == 0 {
                let children = [index + 1, node.start];
                let [near, far] = children.map(|child| (self.nodes[child as usize].distance_squared(point), child));
                let (near, far) = if far.0 < near.0 { (far, near) } else { (near, far) };
                (waiting[depth], waiting[depth + 1]) = (far, near);
                depth += 2;
                continue;
            }
            let leaf = node.start as usize..(node.start + node.count) as usize;
            for &item in &self.order[leaf] {
                least = least.min(distance(item, least));
            }
        }
        least
    }
}

fn longest_axis(size: DVec3) -> usize {
    if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use demeter_physics::geometry::contact_sphere_triangle::Triangle;

    #[test]
    fn finds_the_same_triangles_as_looking_at_all() {
        let mut triangles = Vec::new();
        for i in 0..200u32 {
            let t = f64::from(i);
            let at = DVec3::new(libm::sin(t * 1.7), libm::cos(t * 2.3), libm::sin(t * 0.9)) * 3.0;
            triangles
                .push(Triangle::new([at, at + DVec3::new(0.4, 0.1, 0.0), at + DVec3::new(0.0, 0.3, 0.2)]).unwrap());
        }
        let bounds = |id: u32| triangles[id as usize].bounds();
        let centroids: Vec<DVec3> = triangles.iter().map(|t| t.corners()[0]).collect();
        let tree = Hierarchy::new(&centroids, bounds);
        for i in 0..100 {
            let t = f64::from(i);
            let point = DVec3::new(libm::cos(t), libm::sin(t * 3.1), libm::cos(t * 0.7)) * 3.5;
            let reach = 0.1 + 0.02 * t;
            let mut found = Vec::new();
            tree.any_near(point, reach, |id| {
                found.push(id);
                false
            });
            found.sort_unstable();
            let expected: Vec<u32> = (0..200u32)
                .filter(|&id| {
                    let (lower, upper) = bounds(id);
                    point.distance(point.clamp(lower, upper)) <= reach
                })
                .collect();
            for id in &expected {
                assert!(found.contains(id));
            }
            let order: Vec<u32> = tree.order.iter().copied().filter(|id| found.contains(id)).collect();
            assert_eq!(order.len(), found.len(), "each triangle once");
        }
    }
}
