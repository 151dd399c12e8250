// How finely to draw while things move, so that they move smoothly where drawing is slow (WebGL without a GPU).

/** A picture that moves should take no longer than this [ms]. */
const SMOOTH = 60;
/** Without motion for so long, the whole resolution is drawn [ms]. */
const REST = 250;
/** Shares of the resolution to choose from. */
const SHARES = [1, 1 / 2, 1 / 3, 1 / 4, 1 / 6];

/** Watches how long pictures take, and tells the share of the resolution for those that move. */
export class Pace {
    readonly #gl: WebGL2RenderingContext;
    readonly #rest: () => void;
    /** How long a picture of the whole resolution would take [ms]. */
    #cost = 0;
    #timer = 0;
    #waiting = false;

    /** `rest` is called when a picture was drawn coarsely and nothing has moved since. */
    constructor(gl: WebGL2RenderingContext, rest: () => void) {
        this.#gl = gl;
        this.#rest = rest;
    }

    /** The share of the resolution for a picture that moves. */
    get share(): number {
        const wanted = Math.sqrt(SMOOTH / Math.max(this.#cost, 1));
        return SHARES.find((share) => share <= wanted) ?? SHARES[SHARES.length - 1]!;
    }

    /** A picture was handed to WebGL with this share of the resolution. */
    drawn(share: number): void {
        clearTimeout(this.#timer);
        if (share < 1) {
            this.#timer = window.setTimeout(this.#rest, REST);
        }
        const sync = this.#waiting ? null : this.#gl.fenceSync(this.#gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        if (sync) {
            this.#waiting = true;
            this.#gl.flush();
            this.#wait(sync, performance.now(), share);
        }
    }

    stop(): void {
        clearTimeout(this.#timer);
    }

    /** Waits until the picture is done; costs are averaged, since other programs take their time, too. */
    #wait(sync: WebGLSync, begun: number, share: number): void {
        setTimeout(() => {
            const state = this.#gl.getSyncParameter(sync, this.#gl.SYNC_STATUS) as number | null;
            if (state !== null && state !== this.#gl.SIGNALED) {
                this.#wait(sync, begun, share);
                return;
            }
            this.#gl.deleteSync(sync);
            this.#waiting = false;
            const cost = (performance.now() - begun) / share ** 2;
            this.#cost = this.#cost === 0 ? cost : 0.5 * this.#cost + 0.5 * cost;
        }, 4);
    }
}
