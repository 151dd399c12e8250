// The directions of x, y and z in a corner of the view.
import * as THREE from "three";

const SIZE = 64;
const AXES: [string, string, THREE.Vector3][] = [
    ["x", "#d03a2b", new THREE.Vector3(1, 0, 0)],
    ["y", "#2c8a3d", new THREE.Vector3(0, 1, 0)],
    ["z", "#2f6fd0", new THREE.Vector3(0, 0, 1)],
];
const SVG = "http://www.w3.org/2000/svg";

/** Arrows that follow a camera. */
export class Axes {
    readonly element = document.createElementNS(SVG, "svg");
    readonly #lines: [SVGLineElement, SVGTextElement][] = [];

    constructor() {
        this.element.setAttribute("viewBox", `${-SIZE / 2} ${-SIZE / 2} ${SIZE} ${SIZE}`);
        this.element.setAttribute("class", "axes");
        this.element.setAttribute("aria-hidden", "true");
        for (const [name, colour] of AXES) {
            const line = document.createElementNS(SVG, "line");
            line.setAttribute("stroke", colour);
            line.setAttribute("stroke-width", "2");
            const text = document.createElementNS(SVG, "text");
            text.setAttribute("fill", colour);
            text.textContent = name;
            this.#lines.push([line, text]);
            this.element.append(line, text);
        }
    }

    follow(camera: THREE.Camera): void {
        const inverse = camera.quaternion.clone().invert();
        AXES.forEach(([, , direction], k) => {
            const { x, y } = direction.clone().applyQuaternion(inverse);
            const [line, text] = this.#lines[k]!;
            line.setAttribute("x2", (20 * x).toFixed(2));
            line.setAttribute("y2", (-20 * y).toFixed(2));
            text.setAttribute("x", (26 * x).toFixed(2));
            text.setAttribute("y", (-26 * y).toFixed(2));
        });
    }
}
