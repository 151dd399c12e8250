// Force chains: a cylinder per contact, its radius by the force.
import * as THREE from "three";
import { CLIP, COLOUR, LIGHT, NO_VALUE, PLACE } from "./shading";

const VERTEX = /* glsl */ `
in vec3 from;
in vec3 to;
in float thickness;
in float value;
uniform float thick;
out vec3 viewPlace;
out vec3 viewNormal;
out float chainValue;
${PLACE}
void main() {
    vec3 a = place(from);
    vec3 b = place(to);
    vec3 axis = normalize(b - a);
    vec3 right = normalize(cross(axis, abs(axis.z) > 0.9 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0)));
    vec3 up = cross(axis, right);
    vec3 out_ = position.x * right + position.y * up;
    vec4 view = modelViewMatrix * vec4(mix(a, b, position.z) + thick * thickness * scale * out_, 1.0);
    viewPlace = view.xyz;
    viewNormal = (modelViewMatrix * vec4(out_, 0.0)).xyz;
    chainValue = value;
    gl_Position = projectionMatrix * view;
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 viewPlace;
in vec3 viewNormal;
in float chainValue;
out vec4 shown;
${COLOUR}${LIGHT}${CLIP}
void main() {
    if (cut(viewPlace)) discard;
    vec3 toEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -normalize(viewPlace);
    shown = vec4(lit(colourOf(chainValue), normalize(viewNormal), toEye), 1.0);
}
`;

const SIDES = 10;

/** The force chains of a scene. */
export class Chains {
    readonly mesh: THREE.Mesh<THREE.InstancedBufferGeometry, THREE.ShaderMaterial>;

    constructor(uniforms: Record<string, THREE.IUniform>) {
        const material = new THREE.ShaderMaterial({
            glslVersion: THREE.GLSL3,
            vertexShader: VERTEX,
            fragmentShader: FRAGMENT,
            uniforms,
            side: THREE.DoubleSide,
        });
        this.mesh = new THREE.Mesh(tube(), material);
        this.mesh.frustumCulled = false;
        this.mesh.visible = false;
    }

    /** Draws those contacts whose force is at least `threshold`; the area of a cylinder's section grows with its force. */
    set(ends: Float32Array, force: Float32Array, threshold: number, reference: number, radius: number): number {
        const drawn: number[] = [];
        force.forEach((f, k) => {
            if (f >= threshold && f > 0) {
                drawn.push(k);
            }
        });
        const pick = (offset: number) => Float32Array.from({ length: 3 * drawn.length }, (_, i) => ends[6 * drawn[Math.floor(i / 3)]! + offset + (i % 3)]!);
        const size = (f: number) => radius * Math.sqrt(Math.min(f / reference, 2));
        const geometry = tube();
        const put = (name: string, array: Float32Array, components: number) => {
            geometry.setAttribute(name, new THREE.InstancedBufferAttribute(array, components));
        };
        put("from", pick(0), 3);
        put("to", pick(3), 3);
        put("thickness", Float32Array.from(drawn, (k) => size(force[k]!)), 1);
        put("value", Float32Array.from(drawn, (k) => (Number.isFinite(force[k]) ? force[k]! : NO_VALUE)), 1);
        geometry.instanceCount = drawn.length;
        this.mesh.geometry.dispose();
        this.mesh.geometry = geometry;
        return drawn.length;
    }

    dispose(): void {
        this.mesh.geometry.dispose();
        this.mesh.material.dispose();
    }
}

/** A tube of radius 1 along z from 0 to 1, without any instance. */
function tube(): THREE.InstancedBufferGeometry {
    const geometry = new THREE.InstancedBufferGeometry();
    const places: number[] = [];
    const index: number[] = [];
    for (let k = 0; k < SIDES; k++) {
        const angle = (2 * Math.PI * k) / SIDES;
        places.push(Math.cos(angle), Math.sin(angle), 0, Math.cos(angle), Math.sin(angle), 1);
        const [a, b] = [2 * k, 2 * ((k + 1) % SIDES)];
        index.push(a, b, a + 1, b, b + 1, a + 1);
    }
    geometry.setAttribute("position", new THREE.BufferAttribute(new Float32Array(places), 3));
    geometry.setIndex(index);
    geometry.instanceCount = 0;
    return geometry;
}
