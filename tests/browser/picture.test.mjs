// What the viewer draws, in headless Chromium.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { describe, test } from "node:test";
import { inflateRawSync } from "node:zlib";
import { compare, keep } from "./browser.mjs";
import { PATIENCE, browser, finished, viewer } from "./viewer.mjs";

/** Names and contents of the files in a ZIP without compression. */
function unzip(bytes) {
    const files = new Map();
    for (let at = 0; bytes.readUInt32LE(at) === 0x04034b50; ) {
        const [method, name, extra] = [bytes.readUInt16LE(at + 8), bytes.readUInt16LE(at + 26), bytes.readUInt16LE(at + 28)];
        const start = at + 30 + name + extra;
        let end = bytes.indexOf(Buffer.from([0x50, 0x4b, 0x07, 0x08]), start);
        assert.ok(end > 0, "a file without its length");
        const content = bytes.subarray(start, end);
        files.set(bytes.toString("utf8", at + 30, at + 30 + name), method === 0 ? content : inflateRawSync(content));
        at = end + 16;
    }
    return files;
}

describe("the picture", () => {
    test("changes with colours, chains, walls and the clip plane", async () => {
        const { page, faults, picture, count, reaches } = await viewer(finished());
        await page.keyboard.press("End");
        await reaches(await count());
        let last = await picture();
        const changes = async (what) => {
            const now = await picture();
            const { different } = await compare(browser, last, now);
            assert.ok(different > 0.002, `${what} changed ${different} of the picture`);
            last = now;
        };
        await page.getByLabel("Colour grains by").selectOption("radius");
        await changes("another scalar");
        await page.getByLabel("Cut", { exact: true }).selectOption("any");
        await changes("a cut across any direction");
        await page.getByLabel("z of the normal").fill("-3");
        await changes("another direction");
        await page.getByLabel("Cut", { exact: true }).selectOption("");
        await changes("no cut");
        await page.getByLabel("Show force chains").check();
        await changes("force chains");
        const walls = page.getByRole("group", { name: "Walls", exact: true }).getByRole("checkbox");
        assert.ok((await walls.count()) > 0);
        await walls.first().uncheck();
        await changes("a wall that is hidden");
        await keep(page, "viewer-chains");
        assert.deepEqual(faults, []);
        await page.close();
    });

    test("is the same at rest where drawing is slow and hidden grains are left out", async () => {
        const looks = async (init) => {
            const { page, faults, count, reaches, picture } = await viewer(finished(), { init });
            await page.keyboard.press("End");
            await reaches(await count());
            await page.locator("canvas").first().focus();
            const pictures = [];
            const look = async () => pictures.push(await picture());
            await look();
            for (const key of ["ArrowLeft", "ArrowLeft", "ArrowUp", "+", "+"]) {
                await page.keyboard.press(key);
                await page.waitForTimeout(100);
            }
            await look();
            await page.getByLabel("Cut", { exact: true }).selectOption("any");
            await look();
            await page.getByLabel("Size of grains").fill("0.6");
            await look();
            await page.getByLabel("Opacity of grains").fill("0.5");
            await look();
            const seen = await page.evaluate(() => ({ triangles: window.triangles, shares: [...(window.shares ?? [])] }));
            assert.deepEqual(faults, []);
            await page.close();
            return { pictures, ...seen };
        };
        // counts what is drawn, and lets the page believe that a GPU draws, but `slow`: that every picture takes 0.2 s
        const watch = (slow) => {
            const { drawElements, getParameter, fenceSync } = WebGL2RenderingContext.prototype;
            window.triangles = [];
            window.shares = new Set();
            WebGL2RenderingContext.prototype.drawElements = function (mode, count, ...rest) {
                window.triangles.push(count / 3);
                window.shares.add(this.canvas.dataset.share);
                return drawElements.call(this, mode, count, ...rest);
            };
            const begun = new WeakMap();
            WebGL2RenderingContext.prototype.fenceSync = function (...told) {
                const sync = fenceSync.apply(this, told);
                begun.set(sync, performance.now());
                return sync;
            };
            WebGL2RenderingContext.prototype.getSyncParameter = function (sync, name) {
                return slow && performance.now() - begun.get(sync) < 200 ? this.UNSIGNALED : this.SIGNALED;
            };
            const UNMASKED_RENDERER_WEBGL = 0x9246;
            WebGL2RenderingContext.prototype.getParameter = function (name) {
                return name === UNMASKED_RENDERER_WEBGL ? "a GPU" : getParameter.call(this, name);
            };
        };
        const quick = await looks(`(${watch})(false)`);
        const slow = await looks(`(${watch})(true)`);
        for (const [k, picture] of quick.pictures.entries()) {
            assert.equal((await compare(browser, picture, slow.pictures[k])).different, 0, `picture ${k}`);
        }
        assert.ok(slow.shares.some((share) => Number(share) < 1), `drawn at ${slow.shares} of the resolution`);
        const all = Math.max(...quick.triangles);
        assert.ok(slow.triangles.some((n) => n > 1 && n < all), `always all ${all} triangles`);
    });

    test("tells what is picked, with contacts and history, and leads from the plot to the moment", async () => {
        const { page, faults, count, reaches, frame } = await viewer(finished());
        await page.keyboard.press("End");
        await reaches(await count());
        const { width, height } = await page.locator("canvas").first().boundingBox();
        // somewhere around the middle there is a grain
        for (let k = 0; k < 40 && !(await page.locator(".grain-values dl").count()); k++) {
            await page.locator("canvas").first().click({ position: { x: width * (0.5 + 0.01 * (k % 8) - 0.04), y: height * (0.4 + 0.04 * Math.floor(k / 8)) } });
            await page.waitForTimeout(400);
        }
        const id = await page.getByLabel("Id of a grain").inputValue();
        assert.match(id, /^\d+$/);
        await page.locator(".grain-plots .plot").waitFor(PATIENCE);
        await keep(page, "viewer-picked");
        const over = page.locator(".grain-plots .u-over");
        await over.scrollIntoViewIfNeeded();
        const box = await over.boundingBox();
        await over.click({ position: { x: 3, y: box.height / 2 } });
        await reaches(1);
        assert.equal(await frame(), 1);
        // the neighbour of a grain that touches others
        await page.keyboard.press("End");
        const partner = page.locator(".grain-values button.link").first();
        if (await partner.count()) {
            const name = (await partner.textContent()).replace("grain ", "");
            await partner.click();
            await page.waitForFunction((n) => document.querySelector("[aria-label='Id of a grain']").value === n, name, PATIENCE);
        }
        await page.getByLabel("Id of a grain").fill("999999999");
        await page.getByRole("button", { name: "Show", exact: true }).click();
        await page.getByText("there is no such grain").waitFor(PATIENCE);
        assert.deepEqual(faults.filter((fault) => !fault.includes("404")), []);
        await page.close();
    });

    test("is saved as PNG, as numbered PNGs, and as a film", async () => {
        const { page, faults } = await viewer(finished(), { acceptDownloads: true });
        await page.getByLabel("Last frame").last().fill("3");
        const saves = async (name) => {
            const download = page.waitForEvent("download", { timeout: 120_000 });
            await page.getByRole("button", { name, exact: true }).click();
            const bytes = readFileSync(await (await download).path());
            await page.getByText(/^Saved/).waitFor(PATIENCE);
            return bytes;
        };
        const png = await saves("PNG");
        assert.deepEqual([png.readUInt32BE(16), png.readUInt32BE(20)], [1280, 720]);
        assert.ok((await compare(browser, png)).colours > 100);
        const files = unzip(await saves("PNGs (ZIP)"));
        assert.deepEqual([...files.keys()], ["frame_00000.png", "frame_00001.png", "frame_00002.png"]);
        const [first, last] = [files.get("frame_00000.png"), files.get("frame_00002.png")];
        assert.ok((await compare(browser, first, last)).different > 0.001, "the pictures are of different moments");
        if (await page.getByRole("button", { name: "Film (WebM)" }).count()) {
            const film = await saves("Film (WebM)");
            assert.equal(film.readUInt32BE(0), 0x1a45dfa3);
            const seconds = await page.evaluate(async (data) => {
                const video = document.createElement("video");
                video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(data), (c) => c.charCodeAt(0))], { type: "video/webm" }));
                await new Promise((done, failed) => ((video.onloadedmetadata = done), (video.onerror = failed)));
                return video.duration;
            }, film.toString("base64"));
            assert.ok(Math.abs(seconds - 3 / 25) < 0.05, `the film lasts ${seconds} s`);
        }
        assert.deepEqual(faults, []);
        await page.close();
    });
});
