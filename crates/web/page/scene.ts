// A packing in 3D: grains as exact spheres, force chains as cylinders, walls translucent. Shared by report and viewer.
import * as THREE from "three";
import { Axes } from "./scene/axes";
import { CameraRig, type ViewName } from "./scene/camera";
import { Chains } from "./scene/chains";
import { categoryTexture, mapTexture, NO_VALUE_COLOUR, spreadOf, type MapName } from "./scene/colours";
import { boundsOf, median } from "./scene/extent";
import { drawsInSoftware, Pace } from "./scene/pace";
import { firstSphere, type Plane } from "./scene/pick";
import { Spheres } from "./scene/spheres";
import { VisibleGrains } from "./scene/visible";
import { Walls } from "./scene/walls";

export { CAMERA_KEYS, type ViewName } from "./scene/camera";
export type { MapName } from "./scene/colours";
export type { Plane } from "./scene/pick";

/** Grains, `n` of them, in SI units. */
export interface Grains {
    /** Centres, 3n numbers [m]. */
    position: Float32Array;
    /** Radii [m]. */
    radius: Float32Array;
    id: Uint32Array;
    /** What grains can be coloured by: a value per grain; NaN where there is none. */
    scalars: Map<string, Float32Array>;
    /** Names of the categories of those scalars that are categories (materials, tags): value `k` is called names[k]. */
    categories?: Map<string, string[]>;
}

/** What force chains are drawn of: contacts, `m` of them. */
export interface Contacts {
    /** From where to where the cylinder of each goes, 6m numbers [m]. */
    ends: Float32Array;
    /** Size of the normal force [N]. */
    normalForce: Float32Array;
}

/** The surface of a wall. */
export interface WallSurface {
    name: string;
    index: number;
    /** Nine numbers per triangle [m]. */
    triangles: Float32Array;
}

/** What the colours of the grains, or of the force chains, mean, for a legend. */
export interface ColourScale {
    scalar: string;
    map: MapName;
    range: [number, number];
    /** Whether values lie below or above the range. */
    beyond: [boolean, boolean];
    /** Names of the categories, where the scalar is one. */
    names: string[] | null;
    /** Whether some have no value. */
    gaps: boolean;
}

export interface SceneOptions {
    /** Name of the scene for screen readers. */
    label: string;
    /** CSS colour behind the packing; the page's own (transparent) when left out. */
    background?: string;
    /** Called with the id of the grain that was clicked, or null beside all grains. */
    onPick?: (id: number | null) => void;
}

/** A scene in the container, or a message there and `null` where the browser has no WebGL 2. */
export function createScene(container: HTMLElement, options: SceneOptions): PackingScene | null {
    try {
        return new PackingScene(container, options);
    } catch (error) {
        const message = document.createElement("p");
        message.className = "no-webgl";
        message.setAttribute("role", "alert");
        message.textContent =
            "The 3D view needs WebGL 2, which this browser does not offer or has switched off. " +
            "Try a current Firefox, Chrome, Edge or Safari with hardware acceleration on; everything else on this page works without it.";
        container.replaceChildren(message);
        console.info(`no WebGL: ${error}`);
        return null;
    }
}

/** The 3D view of a packing. */
export class PackingScene {
    readonly canvas: HTMLCanvasElement;
    readonly #container: HTMLElement;
    readonly #renderer: THREE.WebGLRenderer;
    readonly #scene = new THREE.Scene();
    readonly #rig: CameraRig;
    readonly #spheres: Spheres;
    readonly #chains: Chains;
    readonly #walls: Walls;
    readonly #axes = new Axes();
    readonly #watch: ResizeObserver;
    #grains: Grains = { position: new Float32Array(), radius: new Float32Array(), id: new Uint32Array(), scalars: new Map() };
    #contacts: Contacts | null = null;
    #wallTriangles: Float32Array[] = [];
    #visible = new VisibleGrains(0);
    #bounds: THREE.Box3 | null = null;
    #scale: ColourScale = { scalar: "", map: "viridis", range: [0, 1], beyond: [false, false], names: null, gaps: false };
    #wanted: { scalar: string; range: [number, number] | null; map: MapName } = { scalar: "", range: null, map: "viridis" };
    #chainsWanted = { shown: false, threshold: 0 };
    #chainScale: ColourScale | null = null;
    #clip: Plane | null = null;
    #marked = new Set<number>();
    #fitted = false;
    #pending = 0;
    readonly #pace: Pace;
    #share = 1;
    /** Pixels that are drawn for one of a picture that is saved, on a side. */
    readonly #finest: number;
    #maps = new Map<string, THREE.DataTexture>();

    // what the shaders share
    readonly #space = { origin: { value: new THREE.Vector3() }, scale: { value: 1 }, projection: { value: new THREE.Matrix4() } };
    readonly #cut = { clip: { value: new THREE.Vector4() }, clipped: { value: 0 } };
    readonly #grainLook = { colours: { value: null as THREE.Texture | null }, range: { value: new THREE.Vector2(0, 1) }, categories: { value: 0 } };
    readonly #chainLook = { colours: { value: null as THREE.Texture | null }, range: { value: new THREE.Vector2(0, 1) }, categories: { value: 0 } };
    readonly #size = { value: 1 };
    readonly #opacity = { value: 1 };
    readonly #wallColour = { colour: { value: rgb("#7f8fa6") }, edgeColour: { value: rgb("#66748a") } };
    readonly #thick = { value: 1 };

    constructor(container: HTMLElement, options: SceneOptions) {
        this.#container = container;
        // several samples of a pixel cost the processor more than they are worth while things move
        const isSoftware = drawsInSoftware();
        this.#finest = isSoftware ? 2 : 1;
        this.#renderer = new THREE.WebGLRenderer({ antialias: !isSoftware, alpha: true, powerPreference: "high-performance" });
        // the shaders' colours are those of the screen
        this.#renderer.outputColorSpace = THREE.LinearSRGBColorSpace;
        if (options.background) {
            this.#scene.background = rgb(options.background);
        }
        this.canvas = this.#renderer.domElement;
        this.canvas.tabIndex = 0;
        this.canvas.setAttribute("role", "application");
        this.canvas.setAttribute("aria-label", options.label);
        container.replaceChildren(this.canvas, this.#axes.element);
        this.#rig = new CameraRig(this.canvas, () => this.render());

        const noValue = { value: rgb(NO_VALUE_COLOUR) };
        const common = { ...this.#space, ...this.#cut, noValue };
        const mark = { value: rgb("#ff2d87") };
        this.#spheres = new Spheres({ ...common, ...this.#grainLook, size: this.#size, opacity: this.#opacity, mark });
        this.#chains = new Chains({ ...common, ...this.#chainLook, thick: this.#thick });
        this.#walls = new Walls({ ...this.#space, ...this.#cut, ...this.#wallColour });
        this.#scene.add(this.#spheres.mesh, this.#chains.mesh, this.#walls.group);
        this.#grainLook.colours.value = this.#texture("viridis");
        this.#chainLook.colours.value = this.#texture("viridis");

        if (options.onPick) {
            this.#listenForClicks(options.onPick);
        }
        this.#pace = new Pace(this.#renderer.getContext() as WebGL2RenderingContext, isSoftware, (share) => this.#rest(share));
        this.#watch = new ResizeObserver(() => this.#resize());
        this.#watch.observe(container);
        this.#resize();
    }

    /** Shows these grains instead of those before, coloured by what `colourBy` tells next; the camera stays once there was something to see. */
    setGrains(grains: Grains): void {
        this.#grains = grains;
        this.#bounds = null;
        this.#spheres.set(grains.position, grains.radius);
        if (this.#marked.size > 0) {
            this.highlight([...this.#marked]);
        }
        this.#fitFirst();
        this.render();
    }

    /** Contacts that `showChains` draws; `null` for none. */
    setContacts(contacts: Contacts | null): void {
        this.#contacts = contacts;
        this.#drawChains();
    }

    setWalls(walls: WallSurface[]): void {
        const same = walls.length === this.#wallTriangles.length && walls.every((wall, k) => wall.triangles === this.#wallTriangles[k]);
        if (same) {
            return;
        }
        this.#wallTriangles = walls.map((wall) => wall.triangles);
        this.#bounds = null;
        this.#walls.set(this.#wallTriangles);
        this.#fitFirst();
        this.render();
    }

    /** Colours grains by a scalar; the range is found from its values where none is given. Returns what colours mean. */
    colourBy(scalar: string, range: [number, number] | null = null, map: MapName = "viridis"): ColourScale {
        this.#wanted = { scalar, range, map };
        this.#colour();
        return this.#scale;
    }

    /** What the colours of the grains mean now. */
    get colourScale(): ColourScale {
        return this.#scale;
    }

    /** What the colours of the force chains mean now; null while none are shown. */
    get chainScale(): ColourScale | null {
        return this.#chainScale;
    }

    /** Draws contacts whose normal force is at least `threshold` [N] as cylinders. Returns how many. */
    showChains(shown: boolean, threshold = 0): number {
        this.#chainsWanted = { shown, threshold };
        return this.#drawChains();
    }

    /** 0: none, 1: solid. */
    setWallOpacity(opacity: number): void {
        this.#walls.setOpacity(opacity);
        this.render();
    }

    /** 0: none, 1: solid. */
    setGrainOpacity(opacity: number): void {
        this.#opacity.value = opacity;
        this.#spheres.mesh.visible = opacity > 0;
        this.render();
    }

    /** Draws grains with this share of their radius. */
    setGrainSize(share: number): void {
        this.#size.value = share;
        this.render();
    }

    /** Cuts away what lies at `normal . x > offset` [m]; grains show their section. `null`: nothing is cut. */
    setClipPlane(plane: Plane | null): void {
        this.#clip = plane;
        this.render();
    }

    /** Marks grains by their ids. */
    highlight(ids: Iterable<number>): void {
        this.#marked = new Set(ids);
        const { id } = this.#grains;
        this.#spheres.setMarked((k) => this.#marked.has(id[k]!));
        this.render();
    }

    /** Id of the grain at a place of the canvas [CSS pixels from its top left corner]. */
    pick(x: number, y: number): number | null {
        const { clientWidth, clientHeight } = this.canvas;
        const caster = new THREE.Raycaster();
        this.#rig.camera.updateMatrixWorld();
        caster.setFromCamera(new THREE.Vector2((2 * x) / clientWidth - 1, 1 - (2 * y) / clientHeight), this.#rig.camera);
        const from = caster.ray.origin.clone().divideScalar(this.#space.scale.value).add(this.#space.origin.value);
        const { position, radius, id } = this.#grains;
        const drawn = this.#size.value === 1 ? radius : radius.map((r) => r * this.#size.value);
        const at = firstSphere({ from: from.toArray(), direction: caster.ray.direction.toArray() }, position, drawn, this.#clip);
        return at < 0 || this.#opacity.value === 0 ? null : id[at]!;
    }

    /** Looks at the whole packing from a direction. */
    view(name: ViewName): void {
        this.#rig.view(name);
    }

    /** Fits the scene's space to what is shown and looks at all of it. */
    fit(): void {
        const box = this.bounds();
        if (box.isEmpty()) {
            return;
        }
        const half = box.getSize(new THREE.Vector3()).multiplyScalar(0.5);
        const scale = 1 / Math.max(half.length(), 1e-30);
        this.#space.origin.value.copy(box.getCenter(new THREE.Vector3()));
        this.#space.scale.value = scale;
        this.#rig.setExtent(half.multiplyScalar(scale));
        this.#fitted = true;
        this.#rig.whole();
    }

    /** Whether frames follow each other: pictures are then drawn as finely as there is time for. */
    set plays(plays: boolean) {
        this.#pace.plays = plays;
    }

    /** The box around grains and walls [m]; walls that reach far beyond the grains count only near them. */
    bounds(): THREE.Box3 {
        this.#bounds ??= boundsOf(this.#grains, this.#wallTriangles);
        return this.#bounds.clone();
    }

    /** The picture as it is now, as PNG; by default as large as on the screen. */
    async screenshot(size?: { width: number; height: number }): Promise<Blob> {
        const { clientWidth, clientHeight } = this.canvas;
        const { width, height } = size ?? { width: clientWidth * pixelRatio(), height: clientHeight * pixelRatio() };
        const canvas = this.#drawn(Math.round(width), Math.round(height));
        return new Promise<Blob>((resolve, reject) => {
            canvas.toBlob((made) => (made ? resolve(made) : reject(new Error("the browser made no picture"))), "image/png");
        });
    }

    /** The picture as it is now, as the address of an image, for printing. */
    picture(): string {
        const { clientWidth, clientHeight } = this.canvas;
        return this.#drawn(2 * clientWidth, 2 * clientHeight).toDataURL("image/png");
    }

    /** A copy of the picture as it is now, in another size. */
    #drawn(width: number, height: number): HTMLCanvasElement {
        const finest = Math.min(this.#finest, WIDEST / Math.max(width, height));
        this.#renderer.setPixelRatio(Math.max(finest, 1));
        this.#renderer.setSize(Math.max(width, 1), Math.max(height, 1), false);
        this.#rig.camera.aspect = width / height;
        this.#rig.camera.updateProjectionMatrix();
        this.#paint();
        const copy = document.createElement("canvas");
        [copy.width, copy.height] = [width, height];
        const context = copy.getContext("2d")!;
        context.imageSmoothingQuality = "high";
        context.drawImage(this.canvas, 0, 0, width, height);
        this.#resize();
        return copy;
    }

    /** Asks for a picture; many requests make one. */
    render(): void {
        this.#pending ||= requestAnimationFrame(() => this.#draw(this.#pace.share));
    }

    dispose(): void {
        cancelAnimationFrame(this.#pending);
        this.#pace.stop();
        this.#watch.disconnect();
        this.#rig.dispose();
        for (const part of [this.#spheres, this.#chains, this.#walls]) {
            part.dispose();
        }
        for (const map of this.#maps.values()) {
            map.dispose();
        }
        this.#renderer.dispose();
        this.#container.replaceChildren();
    }

    #fitFirst(): void {
        if (!this.#fitted) {
            this.fit();
            this.#fitted = this.#grains.radius.length > 0;
        }
    }

    #colour(): void {
        const { scalar, range, map } = this.#wanted;
        const values = this.#grains.scalars.get(scalar);
        const names = this.#grains.categories?.get(scalar) ?? null;
        const spread = spreadOf(values ?? new Float32Array());
        const [low, high] = range ?? spread.range;
        this.#scale = { scalar, map, range: [low, high], beyond: [spread.low < low, spread.high > high], names, gaps: spread.gaps };
        this.#spheres.setValues(values ?? new Float32Array(this.#grains.radius.length).fill(NaN));
        this.#grainLook.colours.value = this.#texture(names ? "categories" : map);
        this.#grainLook.range.value.set(low, high);
        this.#grainLook.categories.value = names ? 1 : 0;
        this.render();
    }

    #drawChains(): number {
        const { shown, threshold } = this.#chainsWanted;
        this.#chains.mesh.visible = shown && this.#contacts !== null;
        this.#chainScale = null;
        let drawn = 0;
        if (this.#chains.mesh.visible) {
            const { ends, normalForce } = this.#contacts!;
            const spread = spreadOf(normalForce);
            const strong = spread.range[1];
            const typical = median(this.#grains.radius);
            drawn = this.#chains.set(ends, normalForce, threshold, strong, 0.45 * typical);
            this.#chainLook.range.value.set(0, strong);
            if (drawn > 0) {
                this.#chainScale = { scalar: "force chains: normal force", map: "viridis", range: [0, strong], beyond: [false, spread.high > strong], names: null, gaps: false };
            }
        }
        this.render();
        return drawn;
    }

    #texture(name: MapName | "categories"): THREE.DataTexture {
        let map = this.#maps.get(name);
        if (!map) {
            map = name === "categories" ? categoryTexture() : mapTexture(name);
            this.#maps.set(name, map);
        }
        return map;
    }

    #resize(): void {
        const { clientWidth, clientHeight } = this.#container;
        if (clientWidth > 0 && clientHeight > 0) {
            this.#share = 1;
            this.#renderer.setPixelRatio(pixelRatio());
            this.#renderer.setSize(clientWidth, clientHeight);
            this.#rig.resize(clientWidth / clientHeight);
            this.#draw();
        }
    }

    /** Draws with a share of the resolution. */
    #draw(share = 1): void {
        cancelAnimationFrame(this.#pending);
        this.#pending = 0;
        if (share !== this.#share) {
            this.#share = share;
            this.#renderer.setPixelRatio(share * pixelRatio());
        }
        this.canvas.dataset["share"] = String(share);
        this.#paint();
        this.#pace.drawn(share);
        this.canvas.dataset["rests"] = String(this.#pace.rests);
    }

    #rest(share: number | null): void {
        if (share !== null) {
            this.#draw(share);
        }
        this.canvas.dataset["rests"] = String(this.#pace.rests);
    }

    #paint(): void {
        const camera = this.#rig.camera;
        // near and far around the content, which has a size of about 1, so that depths stay exact
        const distance = camera.position.length();
        camera.near = Math.max(distance - 4, 0.002 * Math.max(distance, 0.5));
        camera.far = distance + 8;
        camera.updateProjectionMatrix();
        camera.updateMatrixWorld();
        this.#space.projection.value.copy(camera.projectionMatrix);
        this.#placeClip(camera.matrixWorldInverse);
        this.#chooseGrains(camera);
        this.#axes.follow(camera);
        this.#renderer.render(this.#scene, camera);
    }

    /** Where drawing is slow, hidden grains are left out. */
    #chooseGrains(camera: THREE.PerspectiveCamera): void {
        const { position, radius } = this.#grains;
        if (!this.#pace.isSlow || !this.#spheres.mesh.visible) {
            this.#spheres.choose(null);
            return;
        }
        if (radius.length > this.#visible.found.length) {
            this.#visible = new VisibleGrains(radius.length);
        }
        const { origin, scale } = this.#space;
        const s = scale.value;
        const toView = camera.matrixWorldInverse.clone().multiply(new THREE.Matrix4().makeScale(s, s, s));
        toView.multiply(new THREE.Matrix4().makeTranslation(origin.value.clone().negate()));
        const { clip, clipped } = this.#cut;
        this.#visible.find({
            position,
            radius,
            toView: toView.elements,
            scale: s * this.#size.value,
            tangent: Math.tan((camera.fov * Math.PI) / 360),
            aspect: camera.aspect,
            near: camera.near,
            clip: clipped.value > 0 ? clip.value.toArray() : null,
            solid: this.#opacity.value >= 1,
        });
        this.#spheres.choose(this.#visible.found.subarray(0, this.#visible.count));
    }

    /** The clip plane in view space. */
    #placeClip(toView: THREE.Matrix4): void {
        this.#cut.clipped.value = this.#clip ? 1 : 0;
        if (this.#clip) {
            const normal = new THREE.Vector3(...this.#clip.normal);
            const length = normal.length() || 1;
            const offset = ((this.#clip.offset - normal.dot(this.#space.origin.value)) / length) * this.#space.scale.value;
            const plane = new THREE.Plane(normal.divideScalar(length), -offset).applyMatrix4(toView);
            this.#cut.clip.value.set(plane.normal.x, plane.normal.y, plane.normal.z, -plane.constant);
        }
    }

    #listenForClicks(onPick: (id: number | null) => void): void {
        let down: [number, number] | null = null;
        this.canvas.addEventListener("pointerdown", (event) => (down = [event.offsetX, event.offsetY]));
        this.canvas.addEventListener("pointerup", (event) => {
            if (down && Math.hypot(event.offsetX - down[0], event.offsetY - down[1]) < 4) {
                onPick(this.pick(event.offsetX, event.offsetY));
            }
            down = null;
        });
    }
}

/** Pictures that are saved are drawn with more pixels than they get up to this width and height; beyond, browsers may not draw all. */
const WIDEST = 4096;

function pixelRatio(): number {
    return Math.min(window.devicePixelRatio, 2);
}

/** A colour as it is, not turned into linear light. */
function rgb(css: string): THREE.Color {
    return new THREE.Color().setStyle(css, THREE.LinearSRGBColorSpace);
}
