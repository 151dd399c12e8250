// Pictures and films of the view: one PNG, numbered PNGs in a ZIP, or a WebM where the browser makes it.
import { Zip, ZipPassThrough } from "fflate";
import { ArrayBufferTarget, Muxer } from "webm-muxer";
import { button, choice, group, make, save, tick } from "../dom";
import type { PackingScene } from "../scene";
import { barTexts, type ShownScale } from "../scene/colour_key";
import { mapColour } from "../scene/colours";
import { quantity } from "../units";

const SIZES: [string, string][] = [
    ["1280x720", "1280 × 720"],
    ["1920x1080", "1920 × 1080"],
    ["3840x2160", "3840 × 2160"],
    ["1080x1080", "1080 × 1080"],
];
/** Colours of which the bar in a picture is made. */
const STOPS = 16;
/** Pictures of a film per second. */
const RATE = 25;

export interface ExportSource {
    scene: PackingScene;
    /** Name of the files. */
    name: () => string;
    count: () => number;
    index: () => number;
    time: (index: number) => number;
    /** The colours that are shown. */
    scales: () => ShownScale[];
    /** Shows a frame and waits until it is drawn. */
    show: (index: number) => Promise<void>;
}

export class ExportPanel {
    readonly element: HTMLElement;
    readonly #source: ExportSource;
    readonly #from = make("input", { type: "number", min: 1, step: 1, value: 1, "aria-label": "First frame" });
    readonly #to = make("input", { type: "number", min: 1, step: 1, value: 1, "aria-label": "Last frame" });
    readonly #size: HTMLSelectElement;
    readonly #told: HTMLInputElement;
    readonly #status = make("p", { class: "hint export-status", role: "status" });
    /** How far it is; what is read aloud is told at the beginning and at the end alone. */
    readonly #bar = make("progress", { max: 1, value: 0, "aria-label": "Export" });
    readonly #frames = make("span");
    readonly #progress = make("div", { class: "export-told", hidden: true }, this.#bar, this.#frames);
    readonly #stop = button("Stop", () => (this.#stopped = true));
    readonly #starters: HTMLButtonElement[];
    #stopped = false;

    constructor(source: ExportSource) {
        this.#source = source;
        const size = choice("Size", SIZES, () => undefined);
        this.#size = size.select;
        const written = tick("Write time and colours into pictures", true, () => undefined);
        this.#told = written.input;
        const frames = make("div", { class: "range-row" }, "Frames ", this.#from, "to", this.#to);
        this.#starters = [
            button("PNG", () => void this.#run(() => this.#picture())),
            button("PNGs (ZIP)", () => void this.#run(() => this.#pictures())),
        ];
        const row = make("div", { class: "button-row" }, ...this.#starters, this.#stop);
        void canFilm(...this.#pixels()).then((can) => {
            if (can) {
                const film = button("Film (WebM)", () => void this.#run(() => this.#video()));
                this.#starters.push(film);
                this.#stop.before(film);
            }
        });
        this.#stop.hidden = true;
        const hint = make("p", { class: "hint" }, "An MP4 of the pictures: ", make("code", {}, FFMPEG));
        this.element = group("Export", size.element, written.element, frames, row, this.#progress, this.#status, hint);
    }

    /** Tells how many frames there are; the last one to export follows as long as it was the last. */
    setCount(count: number): void {
        if (this.#to.value === this.#to.max || this.#to.max === "") {
            this.#to.value = String(count);
        }
        this.#from.max = this.#to.max = String(count);
    }

    async #run(job: () => Promise<string>): Promise<void> {
        this.#stopped = false;
        this.#starters.forEach((b) => (b.disabled = true));
        this.#stop.hidden = false;
        this.#status.textContent = "Exporting …";
        const before = this.#source.index();
        try {
            this.#status.textContent = await job();
        } catch (error) {
            this.#status.textContent = `Not exported: ${(error as Error).message}`;
        } finally {
            this.#stop.hidden = this.#progress.hidden = true;
            this.#starters.forEach((b) => (b.disabled = false));
            await this.#source.show(before).catch(() => undefined);
        }
    }

    #tell(done: number, all: number): void {
        this.#progress.hidden = false;
        [this.#bar.max, this.#bar.value] = [all, done];
        this.#frames.textContent = `frame ${done + 1} of ${all}`;
    }

    #range(): [number, number] {
        const count = this.#source.count();
        const read = (input: HTMLInputElement, other: number) => (Number.isInteger(input.valueAsNumber) ? Math.min(Math.max(input.valueAsNumber, 1), count) : other);
        const [from, to] = [read(this.#from, 1), read(this.#to, count)];
        if (count === 0 || from > to) {
            throw new Error("choose a first frame that is not behind the last one.");
        }
        return [from - 1, to - 1];
    }

    async #picture(): Promise<string> {
        const canvas = await this.#draw(this.#source.index());
        save(await png(canvas), `${this.#source.name()}_${String(this.#source.index() + 1).padStart(5, "0")}.png`);
        return "Saved.";
    }

    async #pictures(): Promise<string> {
        const [from, to] = this.#range();
        const parts: BlobPart[] = [];
        const zip = new Zip((error, data) => {
            if (error) {
                throw error;
            }
            parts.push(data as Uint8Array<ArrayBuffer>);
        });
        let done = 0;
        for (let index = from; index <= to && !this.#stopped; index++) {
            this.#tell(index - from, to - from + 1);
            await this.#source.show(index);
            const bytes = new Uint8Array(await (await png(await this.#draw(index))).arrayBuffer());
            // PNGs are compressed already
            const file = new ZipPassThrough(`frame_${String(done).padStart(5, "0")}.png`);
            zip.add(file);
            file.push(bytes, true);
            done += 1;
        }
        zip.end();
        save(new Blob(parts, { type: "application/zip" }), `${this.#source.name()}_frames.zip`);
        return `Saved ${done} pictures. Unpack them and run: ${FFMPEG}`;
    }

    async #video(): Promise<string> {
        const [from, to] = this.#range();
        const [width, height] = this.#pixels();
        const target = new ArrayBufferTarget();
        const muxer = new Muxer({ target, video: { codec: "V_VP8", width, height, frameRate: RATE } });
        let fault: Error | null = null;
        const encoder = new VideoEncoder({ output: (chunk, about) => muxer.addVideoChunk(chunk, about), error: (error) => (fault = error) });
        encoder.configure(codec(width, height));
        let done = 0;
        for (let index = from; index <= to && !this.#stopped && !fault; index++) {
            this.#tell(index - from, to - from + 1);
            await this.#source.show(index);
            const picture = new VideoFrame(await this.#draw(index), { timestamp: (done * 1e6) / RATE, duration: 1e6 / RATE });
            encoder.encode(picture, { keyFrame: done % RATE === 0 });
            picture.close();
            done += 1;
        }
        await encoder.flush();
        encoder.close();
        if (fault) {
            throw fault;
        }
        muxer.finalize();
        save(new Blob([target.buffer], { type: "video/webm" }), `${this.#source.name()}.webm`);
        return `Saved a film of ${done} pictures.`;
    }

    #pixels(): [number, number] {
        const [width, height] = this.#size.value.split("x").map(Number);
        return [width!, height!];
    }

    async #draw(index: number): Promise<HTMLCanvasElement> {
        const [width, height] = this.#pixels();
        const image = await createImageBitmap(await this.#source.scene.screenshot({ width, height }));
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [width, height];
        const context = canvas.getContext("2d")!;
        context.fillStyle = "#ffffff";
        context.fillRect(0, 0, width, height);
        context.drawImage(image, 0, 0);
        image.close();
        if (this.#told.checked) {
            this.#write(context, index, width, height);
        }
        return canvas;
    }

    /** Writes the time and what colours mean along the lower edge. */
    #write(context: CanvasRenderingContext2D, index: number, width: number, height: number): void {
        const size = Math.round(height / 36);
        context.font = `600 ${size}px system-ui, sans-serif`;
        context.textBaseline = "middle";
        context.fillStyle = "#1a2129";
        const middle = height - 1.2 * size;
        context.fillText(quantity(this.#source.time(index), "s"), size, middle);
        const bars = this.#source.scales().filter(({ scale }) => scale.scalar !== "" && !scale.names);
        bars.forEach((bar, k) => drawBar(context, bar, { size, middle: middle - 1.6 * size * k, width }));
    }
}

/** Draws what colours mean into a row of a picture. */
function drawBar(context: CanvasRenderingContext2D, bar: ShownScale, { size, middle, width }: { size: number; middle: number; width: number }): void {
    const { title, low, high } = barTexts(bar);
    const [left, long] = [0.55 * width, 0.25 * width];
    const gradient = context.createLinearGradient(left, 0, left + long, 0);
    for (let k = 0; k <= STOPS; k++) {
        gradient.addColorStop(k / STOPS, `rgb(${mapColour(bar.scale.map, k / STOPS).join(", ")})`);
    }
    const ink = context.fillStyle;
    context.textAlign = "right";
    context.fillText(`${title}   ${low}`, left - 0.5 * size, middle);
    context.textAlign = "left";
    context.fillText(high, left + long + 0.5 * size, middle);
    context.fillStyle = gradient;
    context.fillRect(left, middle - 0.45 * size, long, 0.9 * size);
    context.fillStyle = ink;
}

const FFMPEG = `ffmpeg -framerate ${RATE} -i frame_%05d.png -c:v libx264 -pix_fmt yuv420p run.mp4`;

function codec(width: number, height: number): VideoEncoderConfig {
    return { codec: "vp8", width, height, bitrate: 12e6, framerate: RATE };
}

/** Whether the browser makes films; not every one does. */
async function canFilm(width: number, height: number): Promise<boolean> {
    return typeof VideoEncoder !== "undefined" && ((await VideoEncoder.isConfigSupported(codec(width, height))).supported ?? false);
}

function png(canvas: HTMLCanvasElement): Promise<Blob> {
    return new Promise((resolve, reject) => canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("the browser made no picture"))), "image/png"));
}
