// What `page/scene/visible.ts` leaves out is seen nowhere, by casting rays at all grains.
import assert from "node:assert/strict";
import { test } from "node:test";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));

/** A module of the page. */
async function load(name) {
    const { outputFiles } = await build({ entryPoints: [join(here, "../page", name)], bundle: true, write: false, format: "esm" });
    return import(`data:text/javascript;base64,${Buffer.from(outputFiles[0].text).toString("base64")}`);
}

const { VisibleGrains } = await load("scene/visible.ts");
const { coarseToFine } = await load("viewer/history.ts");

/** Numbers from 0 to 1 that are the same in every run. */
function random(seed) {
    let state = seed;
    return () => {
        state = (1664525 * state + 1013904223) >>> 0;
        return state / 2 ** 32;
    };
}

/** A heap of grains of several sizes in a cube from -1 to 1, some of which overlap. */
function heap(count, seed, sizes) {
    const next = random(seed);
    const position = Float32Array.from({ length: 3 * count }, () => 2 * next() - 1);
    const radius = Float32Array.from({ length: count }, () => sizes[0] + (sizes[1] - sizes[0]) * next() ** 3);
    return { position, radius };
}

/** Looks along -z from a place that is turned about y. */
function view(distance, angle) {
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    // columns of the matrix one after the other
    return [c, 0, s, 0, 0, 1, 0, 0, -s, 0, c, 0, 0.1, -0.05, -distance, 1];
}

/** The grains that rays through the points of a grid meet first. */
function seen({ position, radius, toView: m, scale, tangent, aspect, clip }, across) {
    const centres = Array.from(radius, (r, k) => {
        const [x, y, z] = position.subarray(3 * k, 3 * k + 3);
        return [0, 1, 2].map((row) => m[row] * x + m[4 + row] * y + m[8 + row] * z + m[12 + row]).concat(r * scale);
    });
    const found = new Set();
    for (let row = 0; row < across; row++) {
        for (let column = 0; column < across * aspect; column++) {
            const ray = [tangent * aspect * ((2 * (column + 0.5)) / (across * aspect) - 1), tangent * ((2 * (row + 0.5)) / across - 1), -1];
            const length2 = ray[0] ** 2 + ray[1] ** 2 + 1;
            let [from, to] = [0, Infinity];
            if (clip) {
                const steep = clip[0] * ray[0] + clip[1] * ray[1] + clip[2] * ray[2];
                [from, to] = steep < 0 ? [Math.max(clip[3] / steep, 0), Infinity] : [0, clip[3] / steep];
            }
            let [nearest, at] = [Infinity, -1];
            centres.forEach(([x, y, z, r], k) => {
                const along = (ray[0] * x + ray[1] * y + ray[2] * z) / length2;
                const aside = (along * ray[0] - x) ** 2 + (along * ray[1] - y) ** 2 + (along * ray[2] - z) ** 2;
                if (aside < r * r) {
                    const reach = Math.sqrt((r * r - aside) / length2);
                    const t = Math.max(along - reach, from);
                    if (t <= Math.min(along + reach, to) && t < nearest) {
                        [nearest, at] = [t, k];
                    }
                }
            });
            if (at >= 0) {
                found.add(at);
            }
        }
    }
    return found;
}

const look = { scale: 1, tangent: 0.2867, aspect: 1.5, near: 0.01, clip: null, solid: true };
const cases = {
    "from outside": { ...heap(1500, 1, [0.08, 0.12]), ...look, toView: view(5, 0.4) },
    "very different sizes": { ...heap(1500, 2, [0.01, 0.5]), ...look, toView: view(4, 2) },
    "from the midst": { ...heap(1500, 3, [0.05, 0.2]), ...look, toView: view(0.3, 1), tangent: 0.7 },
    "behind a plane": { ...heap(1500, 4, [0.08, 0.12]), ...look, toView: view(5, 0.4), clip: [0.6, 0, 0.8, -4] },
    "smaller than they are": { ...heap(1500, 5, [0.1, 0.2]), ...look, toView: view(4, -1), scale: 0.6 },
    "close by": { ...heap(1500, 6, [0.05, 0.08]), ...look, toView: view(1.6, 3) },
};

for (const [name, sight] of Object.entries(cases)) {
    test(`grains ${name}: whatever a ray meets first is found, and most of what is hidden is not`, () => {
        const grains = new VisibleGrains(sight.radius.length);
        grains.find(sight);
        const found = [...grains.found.subarray(0, grains.count)];
        assert.equal(new Set(found).size, found.length, "each once");
        const missed = [...seen(sight, 120)].filter((k) => !found.includes(k));
        assert.deepEqual(missed, []);
        assert.ok(found.length < 0.8 * sight.radius.length, `${found.length} of ${sight.radius.length}`);
    });
}

test("grains that hide nothing are all found, and those that are nowhere are not", () => {
    const sight = { ...cases["from outside"], solid: false };
    const grains = new VisibleGrains(1500);
    grains.find(sight);
    assert.equal(grains.count, 1500);
    sight.position.set([NaN, 0, 0, Infinity, 0, 0], 300);
    grains.find({ ...sight, solid: true });
    const found = grains.found.subarray(0, grains.count);
    assert.ok(!found.includes(100) && !found.includes(101) && grains.count > 100);
    grains.find({ ...sight, toView: view(-9, 0) });
    assert.equal(grains.count, 0, "all are behind the eye");
});

test("a history is read from coarse to fine, every moment once", () => {
    assert.deepEqual(coarseToFine(0), []);
    assert.deepEqual(coarseToFine(1), [0]);
    assert.deepEqual(coarseToFine(2), [0, 1]);
    assert.deepEqual(coarseToFine(9), [0, 8, 4, 2, 6, 1, 3, 5, 7]);
    for (const count of [3, 10, 64, 65, 1000]) {
        const order = coarseToFine(count);
        assert.deepEqual([...order].sort((a, b) => a - b), Array.from({ length: count }, (_, k) => k));
        // of the first moments none are far from each other
        const first = order.slice(0, 24).sort((a, b) => a - b);
        const gaps = first.slice(1).map((k, i) => k - first[i]);
        assert.ok(Math.max(...gaps) <= Math.max(count / 8, 1), `${count}: ${gaps}`);
    }
});
