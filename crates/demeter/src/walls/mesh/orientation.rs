//! Turns triangles so that neighbours agree on which side is their front.

use super::topology::{Incidence, number_edges};

/// Turns as few triangles as needed, in every connected piece at most half of them; gives their number. Neighbours are
/// triangles at an edge that has exactly two. Where they cannot agree (a Moebius strip) some edges stay odd.
pub(super) fn orient(triangles: &mut [[u32; 3]]) -> usize {
    let (edges, count) = number_edges(triangles);
    let at_edge = Incidence::new(count, &edges);
    // None: not yet visited
    let mut turned: Vec<Option<bool>> = vec![None; triangles.len()];
    let mut all_turned = 0;
    for start in 0..triangles.len() {
        if turned[start].is_some() {
            continue;
        }
        turned[start] = Some(false);
        let mut piece = vec![start];
        let mut next = 0;
        while let Some(&at) = piece.get(next) {
            next += 1;
            for (side, &edge) in edges[at].iter().enumerate() {
                let &[first, second] = at_edge.of(edge) else { continue };
                let other = if first as usize == at { second } else { first } as usize;
                if other == at || turned[other].is_some() {
                    continue;
                }
                let other_side = edges[other].iter().position(|&e| e == edge).unwrap_or(0);
                let agree = is_forward(&triangles[at], side) != is_forward(&triangles[other], other_side);
                turned[other] = turned[at].map(|t| t == agree);
                piece.push(other);
            }
        }
        let count = piece.iter().filter(|&&t| turned[t] == Some(true)).count();
        let minority = 2 * count <= piece.len();
        for &t in &piece {
            if turned[t] == Some(minority) {
                triangles[t].swap(1, 2);
                all_turned += 1;
            }
        }
    }
    all_turned
}

/// Whether a side runs from the lower vertex to the higher.
pub(super) fn is_forward(triangle: &[u32; 3], side: usize) -> bool {
    triangle[side] < triangle[(side + 1) % 3]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_the_minority_and_leaves_what_is_right() {
        // a fan of four triangles about vertex 0
        let right = vec![[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]];
        let mut fan = right.clone();
        assert_eq!(orient(&mut fan), 0);
        assert_eq!(fan, right);
        fan[0].swap(1, 2);
        assert_eq!(orient(&mut fan), 1);
        assert_eq!(fan, right);
        fan[1..].iter_mut().for_each(|triangle| triangle.swap(0, 1));
        assert_eq!(orient(&mut fan), 1);
        let reversed: Vec<[u32; 3]> = right.iter().map(|&[a, b, c]| [a, c, b]).collect();
        let same = |a: &[u32; 3], b: &[u32; 3]| (0..3).any(|k| [b[k], b[(k + 1) % 3], b[(k + 2) % 3]] == *a);
        assert!(fan.iter().zip(&reversed).all(|(a, b)| same(a, b)), "{fan:?}");
    }
}
