// `demeter view` in headless Chromium.
//
// DEMETER is the program; DEMETER_RUN the folder of a run with several frames, contacts, walls and a series. A run of its own,
// viewer-scenario.toml, is watched while it goes on. `cargo xtask browser` tells both.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { after, before, describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { inflateRawSync } from "node:zlib";
import { accessibility, compare, keep, launch, listen, open, settled, tabStops, withGpu } from "./browser.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const PATIENCE = { timeout: 60_000 };
const program = () => {
    assert.ok(process.env.DEMETER, "DEMETER does not tell the program");
    return resolve(process.env.DEMETER);
};

let browser;
const servers = [];
before(async () => (browser = await launch()));
after(async () => {
    await browser.close();
    servers.forEach((server) => server.kill("SIGINT"));
});

/** Serves a folder; the address. */
async function serve(folder) {
    const server = spawn(program(), ["view", folder, "--no-browser"]);
    servers.push(server);
    return new Promise((done, failed) => {
        server.stdout.once("data", (text) => done(String(text).trim()));
        server.once("exit", (code) => failed(new Error(`demeter view ended with ${code}`)));
    });
}

/** The viewer of a folder, once a frame is drawn. */
async function viewer(folder, options = {}) {
    const address = await serve(folder);
    const opened = await open(browser, address, { allows: new RegExp(`^${address}`), ...options });
    const { page } = opened;
    await page.locator(".timeline[data-shown]").waitFor(PATIENCE);
    const told = () => page.textContent(".time-told");
    const frame = async () => Number(/frame (\d+) of/.exec(await told())?.[1]);
    const count = async () => Number(/of (\d+)/.exec(await told())?.[1]);
    const reaches = (at) => page.locator(`.timeline[data-shown="${at}"]`).waitFor(PATIENCE);
    const picture = async () => {
        await settled(page);
        return page.locator(".scene-frame").screenshot();
    };
    return { ...opened, address, told, frame, count, reaches, picture };
}

const finished = () => {
    assert.ok(process.env.DEMETER_RUN, "DEMETER_RUN names no folder");
    return process.env.DEMETER_RUN;
};

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

describe("the timeline", () => {
    test("scrubs, plays, and does both by keys", async () => {
        const { page, faults, frame, count, reaches, picture } = await viewer(finished());
        const all = await count();
        assert.ok(all > 3, `${all} frames`);
        assert.equal(await page.textContent(".badge"), "finished");
        const first = await picture();
        await keep(page, "viewer-first");
        await page.evaluate(() => document.activeElement.blur());
        await page.keyboard.press("End");
        await reaches(all);
        const { different } = await compare(browser, first, await picture());
        assert.ok(different > 0.005, `the last frame differs by ${different}`);
        await page.keyboard.press("ArrowLeft");
        await reaches(all - 1);
        await page.locator(".timeline [role=status]", { hasText: `frame ${all - 1} of ${all}` }).waitFor({ state: "attached", ...PATIENCE });
        await page.keyboard.press("Home");
        await reaches(1);
        await page.keyboard.press("ArrowRight");
        await reaches(2);
        await page.keyboard.press(",");
        await reaches(1);
        await page.getByLabel("Frame", { exact: true }).fill(String(all - 2));
        await reaches(all - 1);
        await page.keyboard.press("Home");
        await reaches(1);
        await page.getByLabel("Frames per second").selectOption("30");
        await page.evaluate(() => document.activeElement.blur());
        await page.keyboard.press("Space");
        await page.getByRole("button", { name: "Pause" }).waitFor(PATIENCE);
        await reaches(all);
        await page.getByRole("button", { name: "Play" }).waitFor(PATIENCE);
        assert.equal(await frame(), all, "it stops at the end");
        await page.getByLabel("Loop").check();
        await page.getByRole("button", { name: "Play" }).click();
        await page.waitForFunction((n) => !document.querySelector(".time-told").textContent.includes(`frame ${n} of`), all, PATIENCE);
        await page.getByRole("button", { name: "Pause" }).click();
        assert.deepEqual(faults, []);
        await page.close();
    });
});

describe("the picture", () => {
    test("changes with colours, chains, walls and the clip plane", async () => {
        const { page, faults, picture, count, reaches } = await viewer(finished(), { init: `(${withGpu})()` });
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
        const keys = page.locator(".colour-key");
        assert.equal(await keys.count(), 1);
        await page.getByLabel("Show force chains").check();
        await changes("force chains");
        assert.match(await keys.last().textContent(), /^force chains: normal force \[\S*N\]0/);
        assert.match(await page.locator("[id^=scene-in-words]").textContent(), /, coloured by radius from .*; \d+ contacts, force chains: normal force from 0 N to \S+ \S*N\.$/);
        const place = page.getByRole("group", { name: "Clip plane" }).locator("output");
        await page.getByLabel("Cut", { exact: true }).selectOption("z");
        await changes("a cut across z");
        const before = await place.textContent();
        assert.match(before, /^z = /);
        const walls = page.getByRole("group", { name: "Walls", exact: true }).getByRole("checkbox");
        assert.ok((await walls.count()) > 0);
        await walls.first().uncheck();
        await changes("a wall that is hidden");
        assert.notEqual(await place.textContent(), before, "the plane stands where half of what is shown now is cut away");
        await keep(page, "viewer-chains");
        await page.getByLabel("Show force chains").uncheck();
        assert.equal(await keys.count(), 1);
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
        // counts what is drawn, and lets the page believe that every picture takes 0.2 s where it is `slow`
        const watch = (slow) => {
            const { drawElements, fenceSync } = WebGL2RenderingContext.prototype;
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
        };
        const quick = await looks(`(${withGpu})(); (${watch})(false)`);
        const slow = await looks(`(${withGpu})(); (${watch})(true)`);
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
        await page.getByText("Grain 999999999 is not there at this moment.").waitFor(PATIENCE);
        assert.deepEqual(faults, []);
        await page.close();
    });

    test("is saved as PNG, as numbered PNGs, and as a film", async () => {
        const { page, faults, count, reaches } = await viewer(finished(), { acceptDownloads: true });
        await page.getByLabel("Last frame").last().fill("3");
        const colours = (bytes, places) =>
            page.evaluate(
                async ([data, at]) => {
                    const image = new Image();
                    image.src = `data:image/png;base64,${data}`;
                    await image.decode();
                    const context = new OffscreenCanvas(image.width, image.height).getContext("2d", { willReadFrequently: true });
                    context.drawImage(image, 0, 0);
                    return at.map(([x, y]) => [...context.getImageData(x, y, 1, 1).data.subarray(0, 3)]);
                },
                [bytes.toString("base64"), places],
            );
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
        // of grains and force chains each has its bar, one above the other
        const { width, height } = { width: 1280, height: 720 };
        const rows = [height - 1.2 * (height / 36), height - 2.8 * (height / 36)];
        const viridis = [[68, 1, 84], [253, 231, 37]];
        const bars = async (bytes) => {
            const found = await colours(bytes, rows.flatMap((row) => [[0.55 * width + 1, row], [0.8 * width - 2, row]]));
            const isBar = (ends) => ends.flat().every((c, k) => Math.abs(c - viridis.flat()[k]) < 9);
            return [isBar(found.slice(0, 2)), isBar(found.slice(2))];
        };
        assert.deepEqual(await bars(png), [true, false]);
        await page.getByRole("button", { name: "Last frame" }).click();
        await reaches(await count());
        await page.getByLabel("Show force chains").check();
        await page.getByText(/of \d+ contacts; thicker is stronger/).waitFor(PATIENCE);
        assert.deepEqual(await bars(await saves("PNG")), [true, true]);
        await page.getByLabel("Show force chains").uncheck();
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

test("the series shows its columns, and a click in it leads to the moment", async () => {
    const { page, faults, reaches } = await viewer(finished());
    await page.keyboard.press("End");
    await page.getByLabel("Find columns").fill("coordination");
    await page.getByLabel("coordination", { exact: true }).first().check();
    await page.locator(".series-plot figcaption", { hasText: /coordination,.* over time/ }).waitFor(PATIENCE);
    const over = page.locator(".series-plot .u-over");
    await over.scrollIntoViewIfNeeded();
    await over.click({ position: { x: 2, y: 40 } });
    await reaches(1);
    // not more columns than are plotted
    await page.getByLabel("Find columns").fill("");
    const boxes = page.locator(".column-list input");
    const free = page.locator(".column-list input:not(:checked):not(:disabled)");
    while (await free.count()) {
        await free.first().check();
    }
    assert.equal(await page.locator(".column-list input:checked").count(), 12);
    assert.ok((await boxes.count()) > 12);
    await page.getByText("12 columns are ticked, which is the most").waitFor(PATIENCE);
    await page.locator(".series-plot .plot-legend button").nth(11).waitFor(PATIENCE);
    await page.locator(".column-list input:checked").first().uncheck();
    assert.ok((await free.count()) > 0);
    assert.deepEqual(faults, []);
    await page.close();
});

test("a run that goes on is followed until it ends", async () => {
    const folder = mkdtempSync(join(tmpdir(), "demeter-live-"));
    const out = join(folder, "run");
    const run = spawn(program(), ["run", join(here, "viewer-scenario.toml"), "--out", out, "--threads", "1"], { stdio: "ignore" });
    const ended = new Promise((done) => run.once("exit", done));
    const began = () => existsSync(join(out, "walls.pvd")) && readdirSync(join(out, "frames")).some((name) => name.startsWith("walls"));
    do {
        await new Promise((done) => setTimeout(done, 50));
    } while (!began());
    // until the collections name the frame
    await new Promise((done) => setTimeout(done, 100));
    // on a busy machine the run would be over before the page is there
    run.kill("SIGSTOP");
    const { page, faults, count, frame } = await viewer(out);
    assert.equal(await page.textContent(".badge"), "running");
    assert.ok(await page.getByLabel("Live").isChecked());
    const early = await count();
    run.kill("SIGCONT");
    await page.waitForFunction((n) => Number(/of (\d+)/.exec(document.querySelector(".time-told").textContent)?.[1]) > n, early, PATIENCE);
    await keep(page, "viewer-live");
    // scrubbing back stops following
    await page.getByRole("button", { name: "First frame" }).click();
    assert.ok(!(await page.getByLabel("Live").isChecked()));
    assert.equal(await ended, 0);
    await page.waitForFunction(() => document.querySelector(".badge").textContent === "finished", null, PATIENCE);
    assert.equal(await frame(), 1);
    await page.getByLabel("Live").check();
    await page.waitForFunction(() => /frame (\d+) of \1$/.test(document.querySelector(".time-told").textContent), null, PATIENCE);
    const lines = readFileSync(join(out, "series.csv"), "utf8").trim().split("\n").length - 1;
    await page.getByText(`${lines} rows`).waitFor(PATIENCE);
    assert.deepEqual(faults, []);
    await page.close();
    rmSync(folder, { recursive: true });
});

test("a run that replaces another is shown in its place", async () => {
    const folder = mkdtempSync(join(tmpdir(), "demeter-anew-"));
    const out = join(folder, "run");
    const make = (...overrides) => {
        const run = ["run", join(here, "viewer-scenario.toml"), "--out", out, "--overwrite", "--set", 'stage[0].duration="20 ms"', ...overrides.flatMap((text) => ["--set", text])];
        return new Promise((done) => spawn(program(), run, { stdio: "ignore" }).once("exit", done));
    };
    assert.equal(await make(), 0);
    const { page, faults, picture } = await viewer(out);
    const walls = page.getByRole("group", { name: "Walls", exact: true });
    assert.equal(await walls.textContent(), "Wallsbox");
    const before = await picture();
    assert.equal(await make('wall[0].name="vessel"', "grains[0].count=150"), 0);
    await walls.getByLabel("vessel").waitFor(PATIENCE);
    assert.equal(await walls.textContent(), "Wallsvessel");
    await page.waitForFunction(() => document.querySelector("[id^=scene-in-words]").textContent.startsWith("150 grains"), null, PATIENCE);
    assert.ok((await compare(browser, before, await picture())).different > 0.01);
    assert.deepEqual(faults, []);
    await page.close();
    rmSync(folder, { recursive: true });
});

test("the page can be read and used by everybody", async () => {
    const dark = await viewer(finished(), { colorScheme: "dark" });
    await dark.page.getByLabel("Id of a grain").fill("1");
    await dark.page.getByRole("button", { name: "Show", exact: true }).click();
    await dark.page.locator(".grain-plots .plot").waitFor(PATIENCE);
    await keep(dark.page, "viewer-dark");
    assert.deepEqual(await accessibility(dark.page), []);
    await dark.page.close();
    const small = await viewer(finished(), { viewport: { width: 420, height: 800 } });
    await keep(small.page, "viewer-small");
    assert.deepEqual(await accessibility(small.page), []);
    const wide = await small.page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(wide <= 0, `the page is ${wide} pixels wider than the window`);
    await small.page.close();
});

test("the keyboard reaches everything, which has a name and is seen", async () => {
    // a window of 1280 by 720 at 200 %
    const { page, faults } = await viewer(finished(), { viewport: { width: 640, height: 360 }, deviceScaleFactor: 2 });
    await keep(page, "viewer-zoomed");
    const stops = await tabStops(page);
    assert.equal(stops[0].name, "Skip to the picture");
    const view = stops.find(({ name }) => name.includes("a 3D view. Arrow keys: turn"));
    assert.match(view.description, /^\d+ grains, with 1 wall, in .* coloured by \S+ from .* to .*; \d+ contacts?\.$/);
    assert.deepEqual(stops.filter(({ name, inWindow, ring }) => name === "" || !inWindow || !ring), []);
    for (const name of ["Play", "Frame", "Colour grains by", "Show force chains", "Cut", "Film (WebM)", "Id of a grain", "Find columns", "Keys of the timeline"]) {
        assert.ok(stops.some((stop) => stop.name === name), name);
    }
    assert.ok(stops.length < 299, "the Tab key leaves the page");
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(wide <= 0, `the page is ${wide} pixels wider than the window`);
    assert.deepEqual(faults, []);
    await page.close();
});

test("those who listen hear where it is, and not every frame", async () => {
    const { page, count, reaches } = await viewer(finished());
    const all = await count();
    await page.getByRole("button", { name: "First frame" }).click();
    await reaches(1);
    await page.waitForTimeout(200);
    const said = await listen(page);
    await page.getByLabel("Frames per second").selectOption("60");
    await page.getByRole("button", { name: "Play", exact: true }).click();
    await reaches(all);
    await page.getByRole("button", { name: "Play", exact: true }).waitFor(PATIENCE);
    const heard = await said();
    assert.ok(heard.length >= 1 && heard.length <= 2, heard.join(" | "));
    assert.match(heard.at(-1), new RegExp(`frame ${all} of ${all}$`));
    const download = page.waitForEvent("download", { timeout: 120_000 });
    await page.getByRole("button", { name: "PNGs (ZIP)", exact: true }).click();
    await download;
    await page.getByText(/^Saved/).waitFor(PATIENCE);
    const exported = await said();
    assert.ok(exported.filter((text) => /export|saved|frame/i.test(text)).length <= 3, exported.join(" | "));
    await page.close();
});

test("single keys can be kept from working everywhere", async () => {
    const { page, reaches, frame, count } = await viewer(finished());
    await page.getByRole("button", { name: "Last frame" }).click();
    const all = await count();
    await reaches(all);
    await page.getByText("Keys of the timeline").click();
    await page.getByLabel("These keys work wherever the focus is").uncheck();
    await page.getByRole("button", { name: "Front" }).focus();
    await page.keyboard.press(",");
    await page.waitForTimeout(200);
    assert.equal(await frame(), all);
    await page.getByRole("button", { name: "Play", exact: true }).focus();
    await page.keyboard.press(",");
    await reaches(all - 1);
    await page.reload();
    await page.locator(".timeline[data-shown]").waitFor(PATIENCE);
    assert.equal(await page.locator("footer input[type=checkbox]").isChecked(), false, "it is remembered");
    await page.close();
});

test("who knows the port but not the key is told nothing", async () => {
    const address = await serve(finished());
    const { origin, pathname } = new URL(address);
    assert.match(pathname, /^\/[0-9a-f]{32,}\/$/);
    const page = await browser.newPage();
    for (const path of ["/", "/viewer.js", "/api/state?moments=0", `/${"0".repeat(pathname.length - 2)}/`]) {
        const answer = await page.goto(`${origin}${path}`);
        assert.equal(answer.status(), 403, path);
        assert.match(await page.textContent("body"), /open the whole address that `demeter view` tells/);
    }
    // without its last stroke the address still leads to the page
    await page.goto(address.slice(0, -1));
    await page.locator(".time-told", { hasText: "frame 1 of" }).waitFor(PATIENCE);
    assert.equal(page.url(), address);
    await page.close();
});

test("the history of a grain fills its plot while it is read", async () => {
    const { page, faults } = await viewer(finished());
    const asked = [];
    let answered = 0;
    await page.route("**/api/history/**", async (route) => {
        const told = new URL(route.request().url()).searchParams;
        const moments = told.get("moments").split(",").map(Number);
        asked.push({ moments });
        // a server that has time for two moments in each answer
        const answer = await route.fetch();
        const json = await answer.json();
        const some = json.moments.slice(0, 2);
        answered += some.length;
        await route.fulfill({ response: answer, json: { ...json, moments: some } });
    });
    await page.getByLabel("Id of a grain").fill("1");
    await page.getByRole("button", { name: "Show", exact: true }).click();
    const count = Number(/of (\d+)/.exec(await page.textContent(".time-told"))[1]);
    await page.locator(".grain-plots .plot").waitFor(PATIENCE);
    while (answered < count) {
        await page.waitForTimeout(50);
    }
    assert.equal(answered, count, "every moment once");
    await page.waitForTimeout(200);
    await page.locator(".grain-plots").getByText("Numbers").click();
    await page.locator(".grain-plots tbody tr").nth(count - 1).waitFor({ state: "attached", ...PATIENCE });
    assert.equal(await page.locator(".grain-plots tbody tr").count(), count);
    assert.deepEqual(asked[0].moments.slice(0, 3), [0, count - 1, 2 ** Math.ceil(Math.log2(count) - 1)], "from coarse to fine");
    const questions = asked.length;
    await page.getByLabel("History of").selectOption("contact_force");
    await page.locator(".grain-plots figcaption", { hasText: "contact force of grain 1" }).waitFor(PATIENCE);
    assert.equal(asked.length, questions, "what contacts do was read with the rest");
    await page.unrouteAll({ behavior: "wait" });
    assert.deepEqual(faults, []);
    await page.close();
});

test("without the server the page says so", async () => {
    const { page } = await viewer(finished());
    servers.pop().kill("SIGINT");
    await page.getByText("Is `demeter view` still running?").waitFor(PATIENCE);
    await page.close();
});
