// Grains: for each a square that faces the eye, on which the fragment shader finds the sphere with its depth.
import * as THREE from "three";
import { CLIP, COLOUR, DEPTH, DITHER, LIGHT, NO_VALUE, PLACE } from "./shading";

const VERTEX = /* glsl */ `
in vec3 centre;
in float radius;
in float value;
in float marked;
uniform float size;
out vec3 viewCentre;
out vec3 viewPlace;
out float sphereRadius;
out float sphereValue;
out float sphereMarked;
${PLACE}
void main() {
    viewCentre = (modelViewMatrix * vec4(place(centre), 1.0)).xyz;
    sphereRadius = radius * scale * size;
    sphereValue = value;
    sphereMarked = marked;
    vec3 toEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -normalize(viewCentre);
    float distance = length(viewCentre);
    // in perspective the outline of a sphere is wider than its radius
    float wide = isOrthographic ? 1.0 : distance / sqrt(max(distance * distance - sphereRadius * sphereRadius, 1e-12));
    vec3 right = normalize(cross(abs(toEye.y) > 0.99 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0), toEye));
    vec3 up = cross(toEye, right);
    viewPlace = viewCentre + 1.05 * wide * sphereRadius * (position.x * right + position.y * up);
    gl_Position = projectionMatrix * vec4(viewPlace, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 viewCentre;
in vec3 viewPlace;
in float sphereRadius;
in float sphereValue;
in float sphereMarked;
uniform float opacity;
uniform vec3 mark;
out vec4 shown;
${COLOUR}${LIGHT}${CLIP}${DITHER}${DEPTH}
void main() {
    vec3 from = isOrthographic ? vec3(viewPlace.xy, 0.0) : vec3(0.0);
    vec3 ray = isOrthographic ? vec3(0.0, 0.0, -1.0) : normalize(viewPlace);
    // from the point of the ray that is nearest to the centre: exact also far away
    float along = dot(viewCentre - from, ray);
    vec3 nearest = from + along * ray - viewCentre;
    float inside = sphereRadius * sphereRadius - dot(nearest, nearest);
    if (inside < 0.0) discard;
    float reach = sqrt(inside);
    vec3 x = from + (along - reach) * ray;
    vec3 normal = (x - viewCentre) / sphereRadius;
    vec3 colour = colourOf(sphereValue);
    if (sphereMarked > 0.5) colour = mix(colour, mark, 0.85);
    if (cut(x)) {
        // where the plane cuts the sphere its section is shown
        float steep = dot(clip.xyz, ray);
        float t = (clip.w - dot(clip.xyz, from)) / (abs(steep) < 1e-9 ? 1e-9 : steep);
        if (steep >= 0.0 || t > along + reach || t < along - reach) discard;
        x = from + t * ray;
        normal = clip.xyz;
        colour *= 0.82;
    }
    if (sphereMarked < 0.5 && sifted(opacity)) discard;
    shown = vec4(lit(colour, normal, -ray), 1.0);
    gl_FragDepth = depthOf(x);
}
`;

/** The grains of a scene. */
export class Spheres {
    readonly mesh: THREE.Mesh<THREE.InstancedBufferGeometry, THREE.ShaderMaterial>;
    readonly #geometry = new THREE.InstancedBufferGeometry();

    constructor(uniforms: Record<string, THREE.IUniform>) {
        this.#geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]), 3));
        this.#geometry.setIndex([0, 1, 2, 0, 2, 3]);
        this.#geometry.instanceCount = 0;
        const material = new THREE.ShaderMaterial({
            glslVersion: THREE.GLSL3,
            vertexShader: VERTEX,
            fragmentShader: FRAGMENT,
            uniforms,
        });
        this.mesh = new THREE.Mesh(this.#geometry, material);
        this.mesh.frustumCulled = false;
    }

    set(position: Float32Array, radius: Float32Array): void {
        this.#put("centre", position, 3);
        this.#put("radius", radius, 1);
        this.#put("value", new Float32Array(radius.length), 1);
        this.#put("marked", new Float32Array(radius.length), 1);
        this.#geometry.instanceCount = radius.length;
    }

    setValues(values: Float32Array): void {
        this.#put("value", values.map((v) => (Number.isFinite(v) ? v : NO_VALUE)), 1);
    }

    setMarked(marked: Float32Array): void {
        this.#put("marked", marked, 1);
    }

    /** Puts an array into the buffer of its name, which is kept where the number of grains is the same. */
    #put(name: string, array: Float32Array, components: number): void {
        const old = this.#geometry.getAttribute(name) as THREE.InstancedBufferAttribute | undefined;
        if (old && old.array.length === array.length) {
            (old.array as Float32Array).set(array);
            old.needsUpdate = true;
            return;
        }
        const made = new THREE.InstancedBufferAttribute(Float32Array.from(array), components);
        made.setUsage(THREE.DynamicDrawUsage);
        if (old) {
            // three.js frees the buffers of an attribute only with its geometry
            this.#geometry.dispose();
        }
        this.#geometry.setAttribute(name, made);
    }

    dispose(): void {
        this.#geometry.dispose();
        this.mesh.material.dispose();
    }
}
