// Walls: translucent triangles with their edges.
import * as THREE from "three";
import { CLIP, PLACE } from "./shading";

const VERTEX = /* glsl */ `
out vec3 viewPlace;
${PLACE}
void main() {
    viewPlace = (modelViewMatrix * vec4(place(position), 1.0)).xyz;
    gl_Position = projectionMatrix * vec4(viewPlace, 1.0);
}
`;

const FRAGMENT = /* glsl */ `
precision highp float;
in vec3 viewPlace;
uniform vec3 colour;
uniform float opacity;
out vec4 shown;
${CLIP}
void main() {
    if (cut(viewPlace)) discard;
    vec3 normal = normalize(cross(dFdx(viewPlace), dFdy(viewPlace)));
    vec3 toEye = isOrthographic ? vec3(0.0, 0.0, 1.0) : -normalize(viewPlace);
    shown = vec4(colour * (0.72 + 0.28 * abs(dot(normal, toEye))), opacity);
}
`;

const LINE_FRAGMENT = /* glsl */ `
precision highp float;
in vec3 viewPlace;
uniform vec3 edgeColour;
uniform float edgeOpacity;
out vec4 shown;
${CLIP}
void main() {
    if (cut(viewPlace)) discard;
    shown = vec4(edgeColour, edgeOpacity);
}
`;

/** Edges between triangles that are bent by less than this are not drawn [degrees]. */
const SMOOTH = 25;

/** The walls of a scene. */
export class Walls {
    readonly group = new THREE.Group();
    readonly #faces: THREE.ShaderMaterial;
    readonly #lines: THREE.ShaderMaterial;
    readonly #opacity = { value: 0.18 };
    readonly #edgeOpacity = { value: 0.8 };

    constructor(shared: Record<string, THREE.IUniform>) {
        const uniforms = { ...shared, opacity: this.#opacity, edgeOpacity: this.#edgeOpacity };
        const common = { glslVersion: THREE.GLSL3, vertexShader: VERTEX, uniforms, transparent: true, depthWrite: false } as const;
        this.#faces = new THREE.ShaderMaterial({ ...common, fragmentShader: FRAGMENT, side: THREE.DoubleSide });
        this.#lines = new THREE.ShaderMaterial({ ...common, fragmentShader: LINE_FRAGMENT });
    }

    /** Draws these triangles (nine numbers each), one list per wall. */
    set(walls: Float32Array[]): void {
        this.#clear();
        for (const triangles of walls) {
            const geometry = new THREE.BufferGeometry();
            geometry.setAttribute("position", new THREE.BufferAttribute(triangles, 3));
            const faces = new THREE.Mesh(geometry, this.#faces);
            const lines = new THREE.LineSegments(edges(geometry), this.#lines);
            for (const part of [faces, lines]) {
                part.frustumCulled = false;
                this.group.add(part);
            }
            faces.renderOrder = 1;
            lines.renderOrder = 2;
        }
    }

    setOpacity(opacity: number): void {
        this.#opacity.value = opacity;
        this.#edgeOpacity.value = Math.min(1, 4 * opacity);
        this.#faces.depthWrite = opacity >= 1;
        this.group.visible = opacity > 0;
    }

    #clear(): void {
        for (const part of this.group.children) {
            (part as THREE.Mesh).geometry.dispose();
        }
        this.group.clear();
    }

    dispose(): void {
        this.#clear();
        this.#faces.dispose();
        this.#lines.dispose();
    }
}

/**
 * Edges that outline the wall. They are found on triangles brought to a size of about 1, since three.js takes vertices
 * for the same within a fixed distance.
 */
function edges(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
    geometry.computeBoundingSphere();
    const { center, radius } = geometry.boundingSphere!;
    const size = radius > 0 ? radius : 1;
    const unit = geometry.clone().translate(-center.x, -center.y, -center.z).scale(1 / size, 1 / size, 1 / size);
    const found = new THREE.EdgesGeometry(unit, SMOOTH);
    unit.dispose();
    return found.scale(size, size, size).translate(center.x, center.y, center.z);
}
