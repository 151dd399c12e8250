// Headless Chromium, with WebGL in software, and what tests ask of a page.
import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { chromium } from "playwright-core";

const NAMES = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

/** Where Chromium is: DEMETER_CHROMIUM, or on the path. */
export function executable() {
    const told = process.env.DEMETER_CHROMIUM;
    const places = (process.env.PATH ?? "").split(":").flatMap((folder) => NAMES.map((name) => join(folder, name)));
    const found = told ?? places.find((place) => existsSync(place));
    assert.ok(found, "no Chromium on the path; install it or tell its place with DEMETER_CHROMIUM");
    return found;
}

/** Starts Chromium; `webgl: false` without WebGL. */
export function launch({ webgl = true } = {}) {
    const gl = webgl ? ["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"] : ["--disable-3d-apis"];
    return chromium.launch({ executablePath: executable(), args: ["--no-sandbox", ...gl] });
}

/** A page that remembers what went wrong on it: messages of errors, requests to a network, dialogs; `init` is run in it first. */
export async function open(browser, address, { init, ...options } = {}) {
    const page = await browser.newPage({ viewport: { width: 1200, height: 720 }, ...options });
    if (init) {
        await page.addInitScript(init);
    }
    // a machine that does other work, too, takes its time
    page.setDefaultTimeout(120_000);
    const faults = [];
    page.on("console", (message) => ["error", "warning"].includes(message.type()) && faults.push(`console: ${message.text()}`));
    page.on("pageerror", (error) => faults.push(`error: ${error.message}`));
    page.on("dialog", (dialog) => {
        faults.push(`dialog: ${dialog.message()}`);
        void dialog.dismiss();
    });
    page.on("request", (request) => {
        if (!/^(file|data|blob):/.test(request.url()) && !options.allows?.test(request.url())) {
            faults.push(`request: ${request.url()}`);
        }
    });
    await page.goto(address);
    return { page, faults };
}

/** Waits until everything is drawn as finely as it will be: what moves may be drawn more coarsely. */
export function settled(page) {
    return page.evaluate(
        () =>
            new Promise((done) => {
                const whole = () => [...document.querySelectorAll("canvas[data-rests]")].every((canvas) => canvas.dataset.rests === "true");
                const twice = (then) => requestAnimationFrame(() => requestAnimationFrame(then));
                const look = () => (whole() ? twice(done) : setTimeout(look, 30));
                twice(look);
            }),
    );
}

/** Run first in a page, lets it believe that a GPU draws: it then draws no more pixels than those of the screen. */
export function withGpu() {
    const { getParameter } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getParameter = function (name) {
        const UNMASKED_RENDERER_WEBGL = 0x9246;
        return name === UNMASKED_RENDERER_WEBGL ? "a GPU" : getParameter.call(this, name);
    };
}

/** The page of a browser that compares pictures. */
const comparing = new WeakMap();

/** How many different colours a picture has, and how much of it differs from another of the same size. */
export async function compare(browser, a, b = a) {
    if (!comparing.has(browser)) {
        comparing.set(browser, await browser.newPage());
    }
    return comparing.get(browser).evaluate(
        async (pictures) => {
            const pixels = [];
            for (const picture of pictures) {
                const image = new Image();
                image.src = `data:image/png;base64,${picture}`;
                await image.decode();
                const canvas = new OffscreenCanvas(image.width, image.height);
                const context = canvas.getContext("2d");
                context.drawImage(image, 0, 0);
                pixels.push(new Uint32Array(context.getImageData(0, 0, image.width, image.height).data.buffer));
            }
            const [first, second] = pixels;
            let different = 0;
            first.forEach((pixel, k) => (different += pixel === second[k] ? 0 : 1));
            return { colours: new Set(first).size, different: different / first.length };
        },
        [a.toString("base64"), b.toString("base64")],
    );
}

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe-core finds wrong with a page, one line each. */
export async function accessibility(page) {
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => window.axe.run(document, { runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"] }));
    return violations.flatMap((rule) => rule.nodes.map((node) => `${rule.id}: ${rule.help}: ${node.target.join(" ")} ${node.failureSummary}`));
}

/** What the Tab key reaches, in order: role, name and description as screen readers have them, and whether it is seen. */
export async function tabStops(page, most = 300) {
    const client = await page.context().newCDPSession(page);
    const stops = [];
    for (let k = 0; k < most; k++) {
        await page.keyboard.press("Tab");
        const seen = await page.evaluate(() => {
            const element = document.activeElement;
            if (element === document.body) {
                return null;
            }
            const style = getComputedStyle(element);
            const { top, bottom, left, right } = element.getBoundingClientRect();
            const inWindow = bottom > 0 && top < innerHeight && right > 0 && left < innerWidth;
            return { inWindow, ring: style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 2 };
        });
        if (!seen) {
            break;
        }
        const { result } = await client.send("Runtime.evaluate", { expression: "document.activeElement" });
        const { nodes } = await client.send("Accessibility.getPartialAXTree", { objectId: result.objectId, fetchRelatives: false });
        const [{ role, name, description }] = nodes;
        stops.push({ role: role?.value, name: name?.value ?? "", description: description?.value ?? "", ...seen });
    }
    return stops;
}

/** What is said by itself while something goes on: every change of what screen readers watch. */
export async function listen(page) {
    await page.evaluate(() => {
        window.said = [];
        const live = "[role=status], [role=alert], [aria-live=polite], [aria-live=assertive], output:not([aria-live=off])";
        // what is inside a button belongs to its name
        const isLive = (node) => (node instanceof Element ? node : node.parentElement)?.closest(live) && !(node instanceof Element ? node : node.parentElement).closest("button");
        new MutationObserver((changes) => changes.forEach(({ target }) => isLive(target) && window.said.push(target.textContent))).observe(document.body, { subtree: true, childList: true, characterData: true });
    });
    return async () => page.evaluate(() => window.said.splice(0));
}

/** Keeps a picture for people to look at, where DEMETER_PICTURES tells a folder. */
export async function keep(page, name, options = { fullPage: true }) {
    const folder = process.env.DEMETER_PICTURES;
    if (folder) {
        mkdirSync(folder, { recursive: true });
        await page.screenshot({ path: join(folder, `${name}.png`), ...options });
    }
}
