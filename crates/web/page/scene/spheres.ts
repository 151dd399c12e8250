// Grains: for each a triangle that faces the eye, on which the fragment shader finds the sphere with its depth.
//
// Not as instances: without a GPU every instance is drawn as if alone, which takes many times longer than its pixels. What is
// known of the grains lies in textures, and the triangles are told by numbers: grain k has the corners 3k, 3k + 1 and 3k + 2.
import * as THREE from "three";
import { CLIP, COLOUR, DEPTH, DITHER, LIGHT, NO_VALUE, PLACE, TABLE } from "./shading";
import { NumberTable } from "./tables";

const VERTEX = /* glsl */ `
uniform sampler2D places;
uniform sampler2D looks;
uniform float size;
uniform vec3 mark;
flat out vec4 sphere;
flat out vec4 look;
out vec3 viewPlace;
${PLACE}${TABLE}${COLOUR}
void main() {
    vec4 grain = texelFetch(places, cell(gl_VertexID / 3, places), 0);
    vec2 told = texelFetch(looks, cell(gl_VertexID / 3, looks), 0).rg;
    vec3 centre = (modelViewMatrix * vec4(place(grain.xyz), 1.0)).xyz;
    float radius = grain.w * scale * size;
    sphere = vec4(centre, radius);
    look = vec4(told.g > 0.5 ? mix(colourOf(told.r), mark, 0.85) : colourOf(told.r), told.g);
    vec3 toEye = -normalize(centre);
    float distance = length(centre);
    // in perspective the outline of a sphere is wider than its radius
    float wide = distance / sqrt(max(distance * distance - radius * radius, 1e-12));
    vec3 right = normalize(cross(abs(toEye.y) > 0.99 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), toEye));
    vec3 up = cross(toEye, right);
    // the corners of a triangle around a circle
    int corner = gl_VertexID % 3;
    vec2 at = corner == 0 ? vec2(-1.7321, -1.0) : corner == 1 ? vec2(1.7321, -1.0) : vec2(0.0, 2.0);
    viewPlace = centre + 1.01 * wide * radius * (at.x * right + at.y * up);
    gl_Position = projectionMatrix * vec4(viewPlace, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
flat in vec4 sphere;
flat in vec4 look;
in vec3 viewPlace;
uniform float opacity;
out vec4 shown;
${LIGHT}${CLIP}${DITHER}${DEPTH}
void main() {
    vec3 ray = normalize(viewPlace);
    // from the point of the ray that is nearest to the centre: exact also far away
    float along = dot(sphere.xyz, ray);
    vec3 nearest = along * ray - sphere.xyz;
    float inside = sphere.w * sphere.w - dot(nearest, nearest);
    if (inside < 0.0 || (look.a < 0.5 && sifted(opacity))) discard;
    float reach = sqrt(inside);
    vec3 x = (along - reach) * ray;
    vec3 normal = (x - sphere.xyz) / sphere.w;
    vec3 colour = look.rgb;
    if (cut(x)) {
        // where the plane cuts the sphere its section is shown
        float steep = dot(clip.xyz, ray);
        float t = clip.w / (abs(steep) < 1e-9 ? 1e-9 : steep);
        if (steep >= 0.0 || t > along + reach || t < along - reach) discard;
        x = t * ray;
        normal = clip.xyz;
        colour *= 0.82;
    }
    shown = vec4(lit(colour, normal, -ray), 1.0);
    gl_FragDepth = depthOf(x);
}
`;

/** The grains of a scene. */
export class Spheres {
    readonly mesh: THREE.Mesh<THREE.BufferGeometry, THREE.ShaderMaterial>;
    readonly #places = new NumberTable(4);
    readonly #looks = new NumberTable(2);
    #count = 0;
    /** Which corners the triangles have; the first of them are drawn. */
    #corners = new THREE.BufferAttribute(new Uint32Array(), 1);
    /** Whether all grains are among the corners, in their order. */
    #all = false;

    constructor(uniforms: Record<string, THREE.IUniform>) {
        const material = new THREE.ShaderMaterial({
            glslVersion: THREE.GLSL3,
            vertexShader: VERTEX,
            fragmentShader: FRAGMENT,
            uniforms: { ...uniforms, places: this.#places.uniform, looks: this.#looks.uniform },
        });
        this.mesh = new THREE.Mesh(new THREE.BufferGeometry(), material);
        this.mesh.frustumCulled = false;
        this.set(new Float32Array(), new Float32Array());
    }

    set(position: Float32Array, radius: Float32Array): void {
        const count = radius.length;
        const places = this.#places.begin(count);
        for (let k = 0; k < count; k++) {
            places[4 * k] = position[3 * k]!;
            places[4 * k + 1] = position[3 * k + 1]!;
            places[4 * k + 2] = position[3 * k + 2]!;
            places[4 * k + 3] = radius[k]!;
        }
        this.#looks.begin(count);
        if (count !== this.#count || !this.mesh.geometry.index) {
            this.#count = count;
            // three.js frees the buffers of an index only with its geometry
            this.mesh.geometry.dispose();
            this.mesh.geometry = new THREE.BufferGeometry();
            this.#corners = new THREE.BufferAttribute(new Uint32Array(3 * count), 1);
            this.#corners.setUsage(THREE.DynamicDrawUsage);
            this.mesh.geometry.setIndex(this.#corners);
            this.#all = false;
        }
    }

    /** Draws some of the grains, or all. */
    choose(chosen: Uint32Array | null): void {
        if (chosen === null && this.#all) {
            return;
        }
        const corners = this.#corners.array as Uint32Array;
        const count = chosen?.length ?? this.#count;
        for (let k = 0; k < count; k++) {
            const first = 3 * (chosen ? chosen[k]! : k);
            corners[3 * k] = first;
            corners[3 * k + 1] = first + 1;
            corners[3 * k + 2] = first + 2;
        }
        this.#corners.clearUpdateRanges();
        this.#corners.addUpdateRange(0, 3 * count);
        this.#corners.needsUpdate = true;
        this.mesh.geometry.setDrawRange(0, 3 * count);
        this.#all = chosen === null;
    }

    setValues(values: Float32Array): void {
        const looks = this.#looks.change();
        for (let k = 0; k < values.length; k++) {
            const value = values[k]!;
            looks[2 * k] = value - value === 0 ? value : NO_VALUE;
        }
    }

    /** Marks the grains for which it is true. */
    setMarked(isMarked: (index: number) => boolean): void {
        const looks = this.#looks.change();
        for (let k = 0; k < this.#count; k++) {
            looks[2 * k + 1] = isMarked(k) ? 1 : 0;
        }
    }

    dispose(): void {
        this.mesh.geometry.dispose();
        this.mesh.material.dispose();
        this.#places.dispose();
        this.#looks.dispose();
    }
}
