// SPDX-License-Identifier: BSD-3-Clause
// Three tasks of somebody who designs gears, done on the page of `design` as a person would: what each takes is
// printed, and pictures of the page after each are kept beside the files of the tests.
import assert from 'node:assert/strict';
import {after, before, test} from 'node:test';
import {join} from 'node:path';
import {launch} from './browser.mjs';
import {openDesign, serveDesign} from './design_page.mjs';

const library = join(process.env.NETLOFT_SOURCE_DIR, 'gear-library');
const scene = (name, more = '') => `# my trawl\ninclude = ["${library}/scenes/${name}.toml"]\n[gear]\nnodes = 500\n${more}`;
const MOST = 60000;  // milliseconds of a task, on a machine with other work
let browser;

before(async () => { browser = await launch(); });
after(async () => { await browser.close(); });

/** Does a task on a new page, prints its time, and keeps a picture. */
async function timed(name, text, work) {
  const design = await serveDesign(text), {page, seen} = await openDesign(browser.context, design.address);
  const begun = performance.now();
  await work(page);
  const seconds = (performance.now() - begun) / 1000;
  console.log(`${name}: ${seconds.toFixed(1)} s`);
  await page.waitForTimeout(1500);
  await page.screenshot({path: `task-${name.replaceAll(' ', '-')}.png`, fullPage: true});
  design.end();
  assert.ok(seconds < MOST / 1000);
  assert.deepEqual(seen, {errors: [], requests: []});
}

const figure = (page, name) => page.evaluate((n) => window.netloftDesigner.shape.figures.find((f) => f.name === n).value, name);
const number = (page, path) => page.evaluate((p) => window.netloftDesigner.numbers.value(p), path);
const shown = (page, then) => page.waitForFunction((r) => Number(document.documentElement.dataset.revision) > r && document.getElementById('said').textContent.startsWith('equilibrium'), then, {timeout: MOST});
const revision = (page) => page.evaluate(() => window.netloftDesigner.revision);

async function set(page, text) {
  const then = await revision(page);
  await page.fill('#set', text);
  await page.keyboard.press('Enter');
  return then;
}

test('five floats more', async () => {
  await timed('five floats more', scene('83-112-flume-3.0kn'), async (page) => {
    const height = await figure(page, 'mouth/headline_height');
    const then = await revision(page);
    await page.selectOption('#add-float', '83-112-headline');
    await page.selectOption('#add-along', 'headrope');
    await page.click('#add-form button');
    await shown(page, then);
    assert.match(await page.inputValue('#text'), /\[floats\.floats-1\]/);
    assert.ok(await figure(page, 'mouth/headline_height') > height, 'the headline rises');
    assert.match(await page.textContent('#keys'), /\+/);
  });
});

test('a wider bosom that still sews', async () => {
  await timed('a wider bosom', scene('83-112-flume-3.0kn'), async (page) => {
    await page.fill('#filter', 'top-body fore');
    await page.fill('[id="number-panels.top-body.fore[0].meshes"]', '80');
    await page.keyboard.press('Tab');
    // The sides no longer end at the 56 meshes aft: the checks offer the old bosom, or another cutting, which is typed.
    await page.waitForSelector('#checks .error-message', {timeout: MOST});
    const [, sides] = (await page.textContent('#checks')).match(/panels\.top-body\.sides = (\[.*?\}\])/);
    await shown(page, await set(page, `panels.top-body.sides=${sides}`));
    await page.waitForFunction(() => document.querySelectorAll('#checks .error-message').length === 0, null, {timeout: MOST});
    assert.ok(await number(page, 'panels.top-body.fore[0].meshes') > 72, 'the bosom is wider');
  });
});

test('the warp that gives 20 m of wing spread at 80 m', async () => {
  await timed('warp for 20 m', scene('gov-like-67m'), async (page) => {
    await shown(page, await set(page, 'bed.depth=80 m'));
    await page.selectOption('#figure', 'mouth/lower_wing_spread');
    await page.selectOption('#moved', 'ship.warp.length');
    await page.fill('#target', '20');
    const then = await revision(page);
    await page.click('#ask-reach');
    await page.waitForFunction(() => /it is set|does not reach/.test(document.getElementById('answer').textContent), null, {timeout: MOST});
    assert.match(await page.textContent('#answer'), /it is set/);
    await shown(page, then);
    await page.waitForFunction(() => Math.abs(window.netloftDesigner.shape.figures.find((f) => f.name === 'mouth/lower_wing_spread').value - 20) < 1e-3, null, {timeout: MOST});
    console.log(`warp: ${(await number(page, 'ship.warp.length')).toFixed(1)} m`);
  });
});
