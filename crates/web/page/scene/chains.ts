// Force chains: a cylinder with round ends per contact, its radius by the force. For each a square that faces the eye, on which
// the fragment shader finds the cylinder with its depth; like the grains not as instances.
import * as THREE from "three";
import { CLIP, COLOUR, DEPTH, LIGHT, NO_VALUE, PLACE, TABLE } from "./shading";
import { NumberTable } from "./tables";

const VERTEX = /* glsl */ `
uniform sampler2D cylinders;
uniform float thick;
flat out vec4 from;
flat out vec3 to;
flat out vec3 colour;
out vec3 viewPlace;
${PLACE}${TABLE}${COLOUR}
void main() {
    int row = 2 * (gl_VertexID / 4);
    vec4 first = texelFetch(cylinders, cell(row, cylinders), 0);
    vec4 second = texelFetch(cylinders, cell(row + 1, cylinders), 0);
    vec3 a = (modelViewMatrix * vec4(place(first.xyz), 1.0)).xyz;
    vec3 b = (modelViewMatrix * vec4(place(second.xyz), 1.0)).xyz;
    float radius = thick * first.w * scale;
    from = vec4(a, radius);
    to = b;
    colour = colourOf(second.w);
    vec3 middle = 0.5 * (a + b);
    float distance = length(middle);
    vec3 toEye = -middle / distance;
    float deep = 0.5 * dot(b - a, toEye);
    vec3 along = 0.5 * (b - a) - deep * toEye;
    float half_ = length(along);
    vec3 u = half_ > 1e-6 ? along / half_ : normalize(cross(toEye, abs(toEye.y) > 0.99 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0)));
    vec3 v = cross(toEye, u);
    // the end that is nearer to the eye is larger in the picture
    float wide = distance / max(distance - abs(deep) - radius, 0.1 * distance);
    int corner = gl_VertexID % 4;
    float side = corner == 0 || corner == 3 ? -1.0 : 1.0;
    float up = corner < 2 ? -1.0 : 1.0;
    viewPlace = middle + wide * (side * (half_ + 1.05 * radius) * u + up * 1.05 * radius * v);
    gl_Position = projectionMatrix * vec4(viewPlace, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
flat in vec4 from;
flat in vec3 to;
flat in vec3 colour;
in vec3 viewPlace;
out vec4 shown;
${LIGHT}${CLIP}${DEPTH}
vec3 nearestOnAxis(vec3 x) {
    vec3 axis = to - from.xyz;
    return from.xyz + clamp(dot(x - from.xyz, axis) / max(dot(axis, axis), 1e-12), 0.0, 1.0) * axis;
}
/** How far along the ray from a place the cylinder begins; negative where it is missed. After I. Quilez. */
float meets(vec3 start, vec3 ray, out bool hit) {
    float radius2 = from.w * from.w;
    vec3 axis = to - from.xyz;
    vec3 away = start - from.xyz;
    float length2 = dot(axis, axis);
    float axisRay = dot(axis, ray);
    float axisAway = dot(axis, away);
    float a = length2 - axisRay * axisRay;
    float b = length2 * dot(ray, away) - axisAway * axisRay;
    float c = length2 * dot(away, away) - axisAway * axisAway - radius2 * length2;
    float h = b * b - a * c;
    float t = a > 1e-4 * length2 ? (-b - sqrt(max(h, 0.0))) / a : 0.0;
    float at = axisAway + t * axisRay;
    hit = h >= 0.0 && a > 1e-4 * length2 && at > 0.0 && at < length2;
    if (hit) return t;
    // the round end that is nearer
    vec3 end = (a > 1e-4 * length2 ? at <= 0.0 : axisRay > 0.0) ? away : start - to;
    b = dot(ray, end);
    h = b * b - dot(end, end) + radius2;
    hit = h >= 0.0;
    return -b - sqrt(max(h, 0.0));
}
void main() {
    vec3 ray = normalize(viewPlace);
    // from near the cylinder on: exact also far away
    vec3 start = dot(0.5 * (from.xyz + to), ray) * ray;
    bool hit;
    float t = meets(start, ray, hit);
    if (!hit) discard;
    vec3 x = start + t * ray;
    vec3 normal = (x - nearestOnAxis(x)) / from.w;
    vec3 seen = colour;
    if (cut(x)) {
        float steep = dot(clip.xyz, ray);
        x = (clip.w / (abs(steep) < 1e-9 ? 1e-9 : steep)) * ray;
        if (steep >= 0.0 || distance(x, nearestOnAxis(x)) > from.w) discard;
        normal = clip.xyz;
        seen *= 0.82;
    }
    shown = vec4(lit(seen, normal, -ray), 1.0);
    gl_FragDepth = depthOf(x);
}
`;

/** The force chains of a scene. */
export class Chains {
    readonly mesh: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
    /** Two rows for each: its first end and radius, its second end and value. */
    readonly #cylinders = new NumberTable(4);

    constructor(uniforms: Record<string, THREE.IUniform>) {
        const material = new THREE.ShaderMaterial({
            glslVersion: THREE.GLSL3,
            vertexShader: VERTEX,
            fragmentShader: FRAGMENT,
            uniforms: { ...uniforms, cylinders: this.#cylinders.uniform },
        });
        this.mesh = new THREE.Mesh(squares(0), material);
        this.mesh.frustumCulled = false;
        this.mesh.visible = false;
    }

    /** Draws those contacts whose force is at least `threshold`; the area of a cylinder's section grows with its force. */
    set(ends: Float32Array, force: Float32Array, threshold: number, reference: number, radius: number): number {
        const isDrawn = (f: number) => f >= threshold && f > 0;
        const count = force.reduce((sum, f) => sum + (isDrawn(f) ? 1 : 0), 0);
        const cylinders = this.#cylinders.begin(2 * count);
        let at = 0;
        for (let k = 0; k < force.length; k++) {
            const f = force[k]!;
            if (isDrawn(f)) {
                cylinders.set(ends.subarray(6 * k, 6 * k + 3), at);
                cylinders[at + 3] = radius * Math.sqrt(Math.min(f / reference, 2));
                cylinders.set(ends.subarray(6 * k + 3, 6 * k + 6), at + 4);
                cylinders[at + 7] = Number.isFinite(f) ? f : NO_VALUE;
                at += 8;
            }
        }
        if (this.mesh.geometry.index!.count < 6 * count) {
            this.mesh.geometry.dispose();
            this.mesh.geometry = squares(Math.ceil(1.2 * count));
        }
        this.mesh.geometry.setDrawRange(0, 6 * count);
        return count;
    }

    dispose(): void {
        this.mesh.geometry.dispose();
        this.mesh.material.dispose();
        this.#cylinders.dispose();
    }
}

/** Squares with the corners 4k to 4k + 3. */
function squares(count: number): THREE.BufferGeometry {
    const corners = new Uint32Array(6 * count);
    for (let k = 0; k < count; k++) {
        corners.set([4 * k, 4 * k + 1, 4 * k + 2, 4 * k, 4 * k + 2, 4 * k + 3], 6 * k);
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setIndex(new THREE.BufferAttribute(corners, 1));
    return geometry;
}
