// Numbers for shaders: tables as textures, a row of them in each cell.
import * as THREE from "three";

/** Cells beside each other in a texture; every browser with WebGL 2 has textures so wide. */
const WIDTH = 2048;

/** A table with some numbers in each row. */
export class NumberTable {
    readonly uniform = { value: null as THREE.DataTexture | null };
    readonly #components: 2 | 4;
    #data = new Float32Array();

    constructor(components: 2 | 4) {
        this.#components = components;
    }

    /** The numbers of a table of so many rows, to be written; those of before where there were as many. */
    begin(rows: number): Float32Array {
        const height = Math.max(Math.ceil(rows / WIDTH), 1);
        const length = this.#components * WIDTH * height;
        if (length !== this.#data.length) {
            this.#data = new Float32Array(length);
            this.uniform.value?.dispose();
            const format = this.#components === 4 ? THREE.RGBAFormat : THREE.RGFormat;
            this.uniform.value = new THREE.DataTexture(this.#data, WIDTH, height, format, THREE.FloatType);
        }
        return this.change();
    }

    /** The numbers, some of which will be changed before the next picture. */
    change(): Float32Array {
        if (this.uniform.value) {
            this.uniform.value.needsUpdate = true;
        }
        return this.#data;
    }

    dispose(): void {
        this.uniform.value?.dispose();
    }
}
