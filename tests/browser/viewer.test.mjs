// The page of `demeter view` in headless Chromium. A run of its own, viewer-scenario.toml, is watched while it goes on.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { describe, test } from "node:test";
import { fileURLToPath } from "node:url";
import { accessibility, compare, keep, listen, tabStops } from "./browser.mjs";
import { PATIENCE, browser, finished, program, serve, servers, viewer } from "./viewer.mjs";

const here = dirname(fileURLToPath(import.meta.url));

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
    assert.deepEqual(faults, []);
    await page.close();
});

test("a run that goes on is followed until it ends", async () => {
    const folder = mkdtempSync(join(tmpdir(), "demeter-live-"));
    const out = join(folder, "run");
    const run = spawn(program(), ["run", join(here, "viewer-scenario.toml"), "--out", out, "--threads", "1"], { stdio: "ignore" });
    const ended = new Promise((done) => run.once("exit", done));
    while (!existsSync(join(out, "series.csv"))) {
        await new Promise((done) => setTimeout(done, 50));
    }
    const { page, faults, count, frame } = await viewer(out);
    assert.equal(await page.textContent(".badge"), "running");
    assert.ok(await page.getByLabel("Live").isChecked());
    const early = await count();
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
