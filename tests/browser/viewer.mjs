// `demeter view` in headless Chromium, for the tests of a file: each file is a process with a browser of its own.
//
// DEMETER is the program; DEMETER_RUN the folder of a run with several frames, contacts, walls and a series. `cargo xtask browser` tells both.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { resolve } from "node:path";
import { after, before } from "node:test";
import { launch, open, settled } from "./browser.mjs";

export const PATIENCE = { timeout: 60_000 };
export const program = () => {
    assert.ok(process.env.DEMETER, "DEMETER does not tell the program");
    return resolve(process.env.DEMETER);
};

export let browser;
export const servers = [];
before(async () => (browser = await launch()));
after(async () => {
    await browser.close();
    servers.forEach((server) => server.kill("SIGINT"));
});

/** Serves a folder; the address. */
export async function serve(folder) {
    const server = spawn(program(), ["view", folder, "--no-browser"]);
    servers.push(server);
    return new Promise((done, failed) => {
        server.stdout.once("data", (text) => done(String(text).trim()));
        server.once("exit", (code) => failed(new Error(`demeter view ended with ${code}`)));
    });
}

/** The viewer of a folder, once a frame is drawn. */
export async function viewer(folder, options = {}) {
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

export const finished = () => {
    assert.ok(process.env.DEMETER_RUN, "DEMETER_RUN names no folder");
    return process.env.DEMETER_RUN;
};
