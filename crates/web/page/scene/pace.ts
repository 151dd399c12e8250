// How finely to draw, so that things move smoothly where drawing is slow (WebGL without a GPU), and are exact at rest.

/** A picture that moves should take no longer than this [ms]. */
const SMOOTH = 60;
/** A picture that takes longer than this tells that drawing is slow [ms]. */
const SLOW = 40;
/** Without motion for so long, the whole resolution is drawn [ms]; for longer where pictures that move come more slowly. */
const REST = 250;
/** Pictures that are farther apart than this are not of one motion [ms]. */
const APART = 2000;
/** And after so long, without a GPU, four pixels for each of the screen: edges become smooth [ms]. */
const FINE = 800;
/** Unless that would take longer than this [ms]. */
const PATIENCE = 800;
/** Shares of the resolution to choose from. */
const SHARES = [1, 1 / 2, 1 / 3, 1 / 4, 1 / 6];

/** Watches how long pictures take, and tells the share of the resolution for those that move. */
export class Pace {
    /** While true nothing comes to rest: a film is played. */
    plays = false;
    /** Whether pictures have been seen to take long. */
    isSlow: boolean;
    readonly #gl: WebGL2RenderingContext;
    readonly #rest: (share: number | null) => void;
    /** The share of the resolution that is drawn when nothing moves. */
    readonly #finest: number;
    /** Place among the shares; none until a picture was measured. */
    #at = -1;
    /** How long a picture of the whole resolution took last [ms]. */
    #whole = 0;
    #timer = 0;
    #waiting = false;
    /** When the last picture was drawn, and how long after each other those that move are [ms]. */
    #last = -Infinity;
    #gap = 0;

    /**
     * `rest` is called, with the share of the resolution, when a picture was drawn coarsely and nothing has moved since; with
     * null when no finer picture is worth its time.
     */
    constructor(gl: WebGL2RenderingContext, isSoftware: boolean, rest: (share: number | null) => void) {
        this.#gl = gl;
        this.#rest = rest;
        this.isSlow = isSoftware;
        this.#finest = isSoftware && window.devicePixelRatio <= 1 ? 2 : 1;
    }

    /** The share of the resolution for a picture that moves. */
    get share(): number {
        return SHARES[Math.max(this.#at, 0)]!;
    }

    /** A picture was handed to WebGL with this share of the resolution. */
    drawn(share: number): void {
        clearTimeout(this.#timer);
        const now = performance.now();
        if (share < 1 && now - this.#last < APART) {
            this.#gap = 0.5 * this.#gap + 0.5 * (now - this.#last);
        }
        this.#last = now;
        const wait = share < 1 ? Math.max(REST, 3 * this.#gap) : FINE;
        this.#timer = share < this.#finest ? window.setTimeout(() => this.#settle(share), wait) : 0;
        const sync = this.#waiting ? null : this.#gl.fenceSync(this.#gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
        if (sync) {
            this.#waiting = true;
            this.#gl.flush();
            this.#wait(sync, performance.now(), share);
        }
    }

    /** Whether nothing will be drawn until something moves. */
    get rests(): boolean {
        return this.#timer === 0;
    }

    stop(): void {
        clearTimeout(this.#timer);
    }

    #settle(share: number): void {
        if (this.plays || this.#waiting) {
            this.#timer = window.setTimeout(() => this.#settle(share), REST);
            return;
        }
        this.#timer = 0;
        const isQuick = this.#whole * this.#finest ** 2 < PATIENCE;
        this.#rest(share < 1 ? 1 : isQuick ? this.#finest : null);
    }

    #wait(sync: WebGLSync, begun: number, share: number): void {
        setTimeout(() => {
            const state = this.#gl.getSyncParameter(sync, this.#gl.SYNC_STATUS) as number | null;
            if (state !== null && state !== this.#gl.SIGNALED) {
                this.#wait(sync, begun, share);
                return;
            }
            this.#gl.deleteSync(sync);
            this.#waiting = false;
            this.#learn(share, performance.now() - begun);
        }, 4);
    }

    /** One step coarser after a picture that took too long, one finer where even all of its pixels anew would not. */
    #learn(share: number, took: number): void {
        this.isSlow ||= took > SLOW;
        if (share === 1) {
            this.#whole = took;
        }
        if (this.#at < 0) {
            // nearly all of the time is spent on pixels
            const fits = SHARES.findIndex((s) => took * (s / share) ** 2 <= SMOOTH);
            this.#at = fits < 0 ? SHARES.length - 1 : fits;
            return;
        }
        if (share > 1) {
            return;
        }
        const now = SHARES[this.#at]!;
        const [finer, coarser] = [SHARES[this.#at - 1], SHARES[this.#at + 1]];
        if (share <= now && finer && took * (finer / share) ** 2 < SMOOTH) {
            this.#at -= 1;
        } else if (share >= now && share < 1 && coarser && took > 1.3 * SMOOTH) {
            this.#at += 1;
        } else if (now === 1 && took > 1.3 * SMOOTH) {
            this.#at += 1;
        }
    }
}

/** Whether WebGL is drawn by the processor. */
export function drawsInSoftware(): boolean {
    const gl = document.createElement("canvas").getContext("webgl2");
    if (!gl) {
        return false;
    }
    const told = gl.getExtension("WEBGL_debug_renderer_info");
    const name = String(gl.getParameter(told ? told.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    gl.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
