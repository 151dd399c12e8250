// How far things reach.
import * as THREE from "three";

interface Spheres {
    position: Float32Array;
    radius: Float32Array;
}

/** The box around grains and walls [m]; walls that reach far beyond the grains count only near them. */
export function boundsOf(grains: Spheres, wallTriangles: Float32Array[]): THREE.Box3 {
    const box = boxAround(grains);
    const walls = new THREE.Box3();
    for (const triangles of wallTriangles) {
        walls.union(new THREE.Box3().setFromArray(triangles));
    }
    if (!box.isEmpty() && !walls.isEmpty()) {
        walls.intersect(box.clone().expandByScalar(1.5 * box.getSize(new THREE.Vector3()).length()));
    }
    return box.union(walls);
}

function boxAround({ position, radius }: Spheres): THREE.Box3 {
    const low = [Infinity, Infinity, Infinity];
    const high = [-Infinity, -Infinity, -Infinity];
    for (let k = 0; k < radius.length; k++) {
        const r = radius[k]!;
        for (let axis = 0; axis < 3; axis++) {
            const x = position[3 * k + axis]!;
            low[axis] = x - r < low[axis]! ? x - r : low[axis]!;
            high[axis] = x + r > high[axis]! ? x + r : high[axis]!;
        }
    }
    return new THREE.Box3(new THREE.Vector3(...low), new THREE.Vector3(...high));
}

/** A usual value: the median of some. */
export function median(values: Float32Array): number {
    const stride = Math.ceil(values.length / 1000);
    const some = Float32Array.from({ length: stride > 0 ? Math.floor(values.length / stride) : 0 }, (_, k) => values[k * stride]!).sort();
    return some[some.length >> 1] ?? 0;
}
