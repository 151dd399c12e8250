// From where to where the cylinder of a contact goes.

/** Contacts as they are written: which grains they join, where. */
export interface ContactPlaces {
    idI: Uint32Array;
    /** 0 where it is a wall. */
    idJ: Uint32Array;
    /** Contact points, 3m numbers [m]. */
    point: Float32Array;
}

/**
 * Six numbers per contact: from the centre of the first grain to the centre of the second, to the contact point at a wall.
 * Across the side of a periodic box it goes from the centre of the grain that is near the contact point straight through this
 * point. Of grains that are not drawn nothing is known but the contact point.
 */
export function contactEnds(contacts: ContactPlaces, grains: { position: Float32Array; radius: Float32Array; id: Uint32Array }): Float32Array {
    const index = new Map<number, number>();
    grains.id.forEach((id, k) => index.set(id, k));
    const ends = new Float32Array(6 * contacts.idI.length);
    const near = (id: number, point: Float32Array): Float32Array | null => {
        const k = index.get(id);
        if (id === 0 || k === undefined) {
            return null;
        }
        const centre = grains.position.subarray(3 * k, 3 * k + 3);
        return distance(centre, point) < 1.5 * grains.radius[k]! ? centre : null;
    };
    const reach = (id: number) => grains.radius[index.get(id) ?? -1] ?? 0;
    for (let k = 0; k < contacts.idI.length; k++) {
        const point = contacts.point.subarray(3 * k, 3 * k + 3);
        const [i, j] = [contacts.idI[k]!, contacts.idJ[k]!];
        const [a, b] = [near(i, point), near(j, point)];
        const beyond = j === 0 ? 0 : reach(a ? j : i);
        const from = a ?? (b ? through(b, point, beyond) : point);
        const to = b ?? (a ? through(a, point, beyond) : point);
        ends.set(from, 6 * k);
        ends.set(to, 6 * k + 3);
    }
    return ends;
}

function distance(a: Float32Array, b: Float32Array): number {
    return Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);
}

/** The place a distance behind a point, seen from another place. */
function through(from: Float32Array, point: Float32Array, beyond: number): Float32Array {
    const length = distance(from, point);
    return length > 0 ? point.map((p, c) => p + (beyond / length) * (p - from[c]!)) : point;
}
