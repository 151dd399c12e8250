// The camera: turned by pointer, touch and keys; z points up.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

export type ViewName = "oblique" | "front" | "side" | "top";

/** Directions from the packing to the eye. */
const VIEWS: Record<ViewName, [number, number, number]> = {
    oblique: [0.55, -1, 0.42],
    front: [0, -1, 0],
    side: [1, 0, 0],
    // not straight from above, where turning would have no axis
    top: [0, -0.001, 1],
};

const TURN = Math.PI / 24;
const FIELD_OF_VIEW = 32;

/** What the keys do, for the help text of a page. */
export const CAMERA_KEYS: [string, string][] = [
    ["Arrow keys", "turn"],
    ["Shift + arrow keys", "move"],
    ["+ and -", "zoom"],
    ["0", "whole packing"],
    ["1, 2, 3, 4", "oblique, front, side, top view"],
];

/** The camera of a scene whose content lies within a sphere about the origin. */
export class CameraRig {
    readonly camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
    readonly controls: OrbitControls;
    /** Half the extents of what is to be seen. */
    #half = new THREE.Vector3(1, 1, 1);
    readonly #listening = new AbortController();
    readonly #changed: () => void;
    #touched = false;

    constructor(surface: HTMLElement, changed: () => void) {
        this.#changed = changed;
        this.camera.up.set(0, 0, 1);
        this.controls = new OrbitControls(this.camera, surface);
        this.controls.zoomToCursor = true;
        this.controls.addEventListener("change", changed);
        this.controls.addEventListener("start", () => (this.#touched = true));
        // the wheel scrolls the page until the scene has the focus
        this.controls.enableZoom = false;
        const until = { signal: this.#listening.signal };
        surface.addEventListener("focus", () => (this.controls.enableZoom = true), until);
        surface.addEventListener("blur", () => (this.controls.enableZoom = false), until);
        surface.addEventListener("pointerdown", () => surface.focus({ preventScroll: true }), until);
        surface.addEventListener("keydown", (event) => this.#key(event), until);
        this.view("oblique");
    }

    /** Tells how large the content is, as half of its extents. */
    setExtent(half: THREE.Vector3): void {
        this.#half.copy(half);
    }

    /** Looks at the whole content from a direction. */
    view(name: ViewName): void {
        this.#look(new THREE.Vector3(...VIEWS[name]).normalize());
        this.#touched = false;
    }

    /** Looks at the whole content from where the camera is. */
    whole(): void {
        this.#look(this.camera.position.clone().sub(this.controls.target).normalize());
    }

    resize(aspect: number): void {
        this.camera.aspect = aspect;
        this.camera.updateProjectionMatrix();
        if (!this.#touched) {
            this.whole();
        }
    }

    #look(direction: THREE.Vector3): void {
        this.controls.target.set(0, 0, 0);
        this.camera.position.copy(direction);
        this.camera.lookAt(0, 0, 0);
        this.camera.updateMatrixWorld();
        this.camera.position.multiplyScalar(this.#distance());
        this.controls.update();
        this.#changed();
    }

    /** From how far all corners of the content are seen. */
    #distance(): number {
        const up = Math.tan((FIELD_OF_VIEW * Math.PI) / 360);
        const across = up * this.camera.aspect;
        const inverse = this.camera.quaternion.clone().invert();
        let distance = 0.1;
        for (const [x, y, z] of corners()) {
            const corner = new THREE.Vector3(x, y, z).multiply(this.#half).applyQuaternion(inverse);
            distance = Math.max(distance, corner.z + Math.max(Math.abs(corner.x) / across, Math.abs(corner.y) / up));
        }
        return 1.04 * distance;
    }

    #key(event: KeyboardEvent): void {
        if (event.ctrlKey || event.metaKey || event.altKey) {
            return;
        }
        const views: Record<string, ViewName> = { "1": "oblique", "2": "front", "3": "side", "4": "top" };
        const arrows: Record<string, [number, number]> = {
            ArrowLeft: [-1, 0],
            ArrowRight: [1, 0],
            ArrowUp: [0, 1],
            ArrowDown: [0, -1],
        };
        const arrow = arrows[event.key];
        if (arrow && event.shiftKey) {
            this.#move(...arrow);
        } else if (arrow) {
            this.#turn(...arrow);
        } else if (event.key === "+" || event.key === "=") {
            this.#zoom(1 / 1.15);
        } else if (event.key === "-" || event.key === "_") {
            this.#zoom(1.15);
        } else if (event.key === "0" || event.key === "Home") {
            this.whole();
        } else if (views[event.key]) {
            this.view(views[event.key]!);
        } else {
            return;
        }
        event.preventDefault();
        event.stopPropagation();
    }

    #turn(right: number, up: number): void {
        const arm = this.camera.position.clone().sub(this.controls.target);
        arm.applyAxisAngle(this.camera.up, right * TURN);
        const side = new THREE.Vector3().crossVectors(this.camera.up, arm).normalize();
        const angle = arm.angleTo(this.camera.up);
        const wanted = Math.min(Math.max(angle - up * TURN, 0.01), Math.PI - 0.01);
        arm.applyAxisAngle(side, wanted - angle);
        this.camera.position.copy(this.controls.target).add(arm);
        this.#done();
    }

    #move(right: number, up: number): void {
        const step = 0.05 * this.camera.position.distanceTo(this.controls.target);
        const shift = new THREE.Vector3(right * step, up * step, 0).applyQuaternion(this.camera.quaternion);
        this.camera.position.add(shift);
        this.controls.target.add(shift);
        this.#done();
    }

    #zoom(factor: number): void {
        const arm = this.camera.position.clone().sub(this.controls.target).multiplyScalar(factor);
        this.camera.position.copy(this.controls.target).add(arm);
        this.#done();
    }

    #done(): void {
        this.#touched = true;
        this.controls.update();
        this.#changed();
    }

    dispose(): void {
        this.controls.dispose();
        this.#listening.abort();
    }
}

function* corners(): Generator<[number, number, number]> {
    for (const x of [-1, 1]) {
        for (const y of [-1, 1]) {
            for (const z of [-1, 1]) {
                yield [x, y, z];
            }
        }
    }
}
