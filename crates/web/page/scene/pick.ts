// Which grain a ray meets first.

export interface Ray {
    /** Where it starts, in the coordinates of the data. */
    from: [number, number, number];
    /** Its direction, of length 1. */
    direction: [number, number, number];
}

/** A plane; what lies at `normal . x > offset` is cut away. */
export interface Plane {
    normal: [number, number, number];
    offset: number;
}

/** Index of the first sphere on the ray, as it is drawn with the part beyond the plane cut away; -1 for none. */
export function firstSphere(ray: Ray, position: Float32Array, radius: Float32Array, clip: Plane | null): number {
    const [ox, oy, oz] = ray.from;
    const [dx, dy, dz] = ray.direction;
    // the part of the ray that is not cut away
    let [start, end] = [0, Infinity];
    if (clip) {
        const [a, b, c] = clip.normal;
        const steep = a * dx + b * dy + c * dz;
        const gap = clip.offset - (a * ox + b * oy + c * oz);
        if (steep < 0) {
            start = Math.max(start, gap / steep);
        } else if (steep > 0) {
            end = gap / steep;
        } else if (gap < 0) {
            return -1;
        }
    }
    let found = -1;
    let nearest = end;
    for (let k = 0; k < radius.length; k++) {
        const x = position[3 * k]! - ox;
        const y = position[3 * k + 1]! - oy;
        const z = position[3 * k + 2]! - oz;
        const along = x * dx + y * dy + z * dz;
        const aside = (x - along * dx) ** 2 + (y - along * dy) ** 2 + (z - along * dz) ** 2;
        const inside = radius[k]! ** 2 - aside;
        if (inside < 0) {
            continue;
        }
        const reach = Math.sqrt(inside);
        const at = Math.max(along - reach, start);
        if (at <= along + reach && at < nearest) {
            nearest = at;
            found = k;
        }
    }
    return found;
}
