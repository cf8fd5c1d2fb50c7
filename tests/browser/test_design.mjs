// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {readFileSync, readdirSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import {canvasPixels, drawn, launch, luminances, variance} from './browser.mjs';
import {openDesign as open, serveDesign} from './design_page.mjs';

const AXE = createRequire(import.meta.url).resolve('axe-core/axe.min.js');
const SCENE = join(process.env.NETLOFT_SOURCE_DIR, 'gear-library/scenes/83-112-flume-3.0kn.toml');
const OWN = `# my trawl\ninclude = ["${SCENE}"]\n[gear]\nnodes = 200\n[tow]\nspeed = "3 kn"   # over the ground\n`;

const running = [];
let browser, flat;

async function serve(text = OWN) {
  const design = await serveDesign(text);
  running.push(design);
  return design;
}

const sliderOf = (page, path) => page.locator(`.one-number[data-path="${path}"] input[type=range]`);

async function openTable(page, table) {
  await page.evaluate((name) => { document.querySelector(`details[data-table="${name}"]`).open = true; }, table);
}

/** Waits until the equilibrium of a text with this revision, or a newer one, is shown. */
async function solved(page, revision) {
  await page.waitForFunction((r) => Number(document.documentElement.dataset.revision) >= r && document.getElementById('said').textContent.startsWith('equilibrium'), revision, {timeout: 30000});
}

const height = (page) => page.evaluate(() => window.netloftDesigner.shape.figures.find((f) => f.name === 'mouth/headline_height').value);
const pointsShown = (page) => page.evaluate(() => Array.from(window.netloftViewer.model.points));
const revision = (page) => page.evaluate(() => window.netloftDesigner.revision);

before(async () => { [browser, flat] = [await launch(), await launch({webgl: false})]; });
after(async () => {
  for (const one of running) one.end();
  await Promise.all([browser.close(), flat.close()]);
});

test('a slider moves, its ghost follows at once and the equilibrium after it', async () => {
  const {address, file} = await serve(), {page, seen} = await open(browser.context, address);
  const light = luminances(await canvasPixels(page));
  assert.ok(variance(light) > 60, `variance ${variance(light)}`);
  const [h, points, first] = [await height(page), await pointsShown(page), await revision(page)];
  await openTable(page, 'tow');
  const slider = sliderOf(page, 'tow.speed');
  await slider.focus();
  await page.waitForFunction(() => window.netloftDesigner.shape.tangents.size > 0);
  await page.evaluate(() => Promise.all(window.netloftDesigner.shape.tangents.values()));
  for (let i = 0; i < 10; ++i) await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => window.netloftDesigner.shape.timesOfGhosts.length > 0);
  const ghost = await pointsShown(page);
  assert.ok(ghost.some((v, i) => Math.abs(v - points[i]) > 1e-4), 'the ghost moves the nodes');
  await page.waitForFunction((r) => Number(document.documentElement.dataset.revision) > r, first, {timeout: 30000});
  await solved(page, first + 1);
  assert.ok(await height(page) < h, 'a faster tow lowers the headline');
  const moved = await pointsShown(page);
  const off = Math.max(...moved.map((v, i) => Math.abs(v - ghost[i]))), went = Math.max(...moved.map((v, i) => Math.abs(v - points[i])));
  assert.ok(off < went, `the equilibrium is ${off} m from the ghost and went ${went} m`);
  assert.equal(await page.evaluate(() => document.getElementById('undo').disabled), false);
  assert.equal(readFileSync(file, 'utf8'), OWN, 'nothing is written before it is saved');
  await page.click('#save-text');
  await page.waitForFunction(() => document.getElementById('saved').textContent === 'saved');
  assert.match(readFileSync(file, 'utf8'), /^speed = "3\.\d+ kn" {3}# over the ground$/m);
  await page.evaluate(() => document.activeElement.blur());
  while (!await page.evaluate(() => document.getElementById('undo').disabled)) {
    await page.click('#undo');
    await page.waitForTimeout(50);
  }
  await page.waitForFunction(() => document.getElementById('saved').textContent === 'not saved');
  await page.click('#save-text');
  await page.waitForFunction(() => document.getElementById('saved').textContent === 'saved');
  assert.equal(readFileSync(file, 'utf8'), OWN);
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('an error in the text is marked at its line, and the last shape stays', async () => {
  const {address} = await serve(), {page, seen} = await open(browser.context, address);
  const points = await pointsShown(page);
  await page.click('#tab-text');
  await page.fill('#text', OWN.replace('"3 kn"', '3 kn'));
  await page.waitForSelector('#text-errors li');
  assert.match(await page.textContent('#text-errors'), /own\.toml:6:/);
  assert.match(await page.textContent('#lines .wrong'), /6/);
  assert.match(await page.textContent('#marks .fault'), /\S/);
  assert.deepEqual(await pointsShown(page), points);
  const before = await revision(page);
  await page.fill('#text', OWN.replace('3 kn', '3.3 kn'));
  await page.waitForFunction((r) => Number(document.documentElement.dataset.revision) > r, before, {timeout: 30000});
  assert.equal(await page.locator('#text-errors li').count(), 0);
  assert.equal(await page.evaluate(() => window.netloftDesigner.numbers.value('tow.speed')), 3.3);
  await page.fill('#text', OWN.replace('3 kn', '3 kg'));
  await page.waitForSelector('#notice:not([hidden])');
  assert.equal(await page.textContent('#marks .fault'), '"3 kg"');  // what only the reader of the scene knows is marked, too
  assert.match(await page.textContent('#notice-text'), /tow\.speed/);
  await page.click('#go-back');
  await page.waitForFunction(() => document.getElementById('notice').hidden);
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('an error is marked soon after the key press', async () => {
  const {address} = await serve(), {page} = await open(browser.context, address), times = [];
  await page.click('#tab-text');
  for (const wrong of ['= =', '[[', 'a b', '"', '] =', '== 1', '{', ', ,', '1 2', '[x']) {
    times.push(await page.evaluate((text) => new Promise((done) => {
      const area = document.getElementById('text'), begun = performance.now();
      new MutationObserver((_, observer) => { if (document.querySelector('#marks .fault')) { observer.disconnect(); done(performance.now() - begun); } }).observe(document.getElementById('marks'), {childList: true});
      area.value = text;
      area.dispatchEvent(new InputEvent('input', {bubbles: true}));
    }), `${OWN}${wrong}\n`));
    await page.fill('#text', OWN);
    await page.waitForFunction(() => !document.querySelector('#marks .fault'));
    await page.waitForTimeout(300);
  }
  times.sort((a, b) => a - b);
  console.log(`from a key press to the mark of its error: median ${times[5].toFixed(0)} ms, longest ${times[9].toFixed(0)} ms`);
  assert.ok(times[5] < 1000);  // a machine with other work; the goal is 50 ms
});

test('a click on a part opens its numbers', async () => {
  const {address} = await serve(), {page} = await open(browser.context, address);
  await page.evaluate(() => { const {viewer} = window.netloftDesigner.shape; viewer.selection.take('rope', viewer.result.barPart.indexOf(viewer.result.parts.findIndex((p) => p.name === 'headrope'))); });
  assert.equal(await page.inputValue('#filter'), 'headrope');
  assert.ok(await sliderOf(page, 'ropes.headrope.length').isVisible());
  await page.evaluate(() => [...document.querySelectorAll('#pane-plan text')].find((t) => t.textContent === 'top-body').dispatchEvent(new MouseEvent('click', {bubbles: true, clientX: 0, clientY: 0})));
  assert.notEqual(await page.inputValue('#filter'), 'headrope');
});

test('what is shown becomes what a run of the text finds', async () => {
  const {address} = await serve(), {page, seen} = await open(browser.context, address), first = await revision(page);
  await openTable(page, 'tow');
  await sliderOf(page, 'tow.speed').focus();
  for (let i = 0; i < 5; ++i) await page.keyboard.press('ArrowRight');
  await page.waitForFunction((r) => Number(document.documentElement.dataset.confirmed) > r, first, {timeout: 30000});
  assert.match(await page.textContent('#said'), /a run of the text finds the same/);
  assert.ok(await page.isHidden('#notice'));
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('the page outlives its solver', async () => {
  const {address, process: program} = await serve(), {page, seen} = await open(browser.context, address), h = await height(page);
  const solver = readdirSync(`/proc/${program.pid}/task`).flatMap((task) => readFileSync(`/proc/${program.pid}/task/${task}/children`, 'utf8').split(' ').filter(Boolean));
  assert.equal(solver.length, 1);
  process.kill(Number(solver[0]), 'SIGKILL');
  await openTable(page, 'tow');
  await sliderOf(page, 'tow.speed').focus();
  await page.keyboard.press('ArrowRight');
  await page.waitForSelector('#notice:not([hidden])');
  await page.waitForFunction(() => /signal 9/.test(document.getElementById('notice-text').textContent));
  await page.keyboard.press('ArrowRight');
  await page.waitForFunction((before) => window.netloftDesigner.shape.figures.find((f) => f.name === 'mouth/headline_height').value < before, h, {timeout: 30000});
  assert.deepEqual(seen.requests, []);
});

test('questions are answered', async () => {
  const {address} = await serve(), {page, seen} = await open(browser.context, address);
  await page.selectOption('#figure', 'mouth/headline_height');
  await page.click('#ask-influences');
  await page.waitForSelector('#answer table button', {timeout: 30000});
  await page.selectOption('#moved', 'tow.speed');
  await page.click('#ask-sweep');
  await page.waitForSelector('#curve-of-sweep canvas', {timeout: 30000});
  await page.fill('#target', '2');
  await page.click('#ask-reach');
  await page.waitForFunction(() => /it is set/.test(document.getElementById('answer').textContent), null, {timeout: 30000});
  await page.waitForFunction(() => Math.abs(window.netloftDesigner.shape.figures.find((f) => f.name === 'mouth/headline_height').value - 2) < 1e-3, null, {timeout: 30000});
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('files are exported, and errors of the mesh stand beside the figures', async () => {
  const {address} = await serve(OWN.replace('nodes = 200', 'nodes = 500')), {page, seen} = await open(browser.context, address);
  for (const [kind, begin] of [['pdf', '%PDF-1.'], ['svg', '<svg'], ['hdf', '\u0089HDF'], ['html', '<!DOCTYPE html>']]) {
    await page.selectOption('#export', kind);
    const [download] = await Promise.all([page.waitForEvent('download'), page.click('#do-export')]);
    assert.ok(download.suggestedFilename().endsWith(`.${kind}`), download.suggestedFilename());
    assert.ok(readFileSync(await download.path(), 'latin1').trimStart().replace(/^<\?xml[^>]*>\s*/, '').startsWith(begin), kind);
  }
  assert.equal(await page.locator('#report td:nth-child(4)', {hasText: '±'}).count(), 0);
  await page.click('#ask-errors');
  await page.waitForFunction(() => [...document.querySelectorAll('#report td:nth-child(4)')].some((cell) => cell.textContent.includes('±')), null, {timeout: 60000});
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('a rope is added between two points that are clicked, and removed; what cannot be removed says why', async () => {
  const {address} = await serve(), {page, seen} = await open(browser.context, address), first = await revision(page);
  const text = () => page.evaluate(() => window.netloftDesigner.text.files[0].text), before = await text();
  const select = (part) => page.evaluate((name) => {
    const {viewer} = window.netloftDesigner.shape, r = viewer.result, p = r.parts.findIndex((one) => one.name === name);
    viewer.selection.take('rope', r.barPart.lastIndexOf(p));
  }, part);
  await page.selectOption('#add-kind', 'rope');
  await page.focus('#add-from');
  assert.match(await page.textContent('#add-hint'), /from/);
  await select('headrope');
  assert.match(await page.textContent('#add-hint'), /to/);
  await select('footrope');
  const [from, to] = [await page.inputValue('#add-from'), await page.inputValue('#add-to')];
  assert.notEqual(from, to);
  await page.click('#add-form button');
  await solved(page, first + 1);
  assert.ok((await text()).includes(`between = ["${from}", "${to}"]`), await text());
  await page.waitForFunction(() => [...document.querySelectorAll('#remove-part option')].some((o) => o.value === 'ropes.rope-1'), null, {timeout: 30000});
  await page.selectOption('#remove-part', 'ropes.headrope');
  await page.click('#remove-form button');
  await page.waitForFunction(() => /headrope cannot be removed: .*there is no/.test(document.getElementById('said').textContent));
  await page.selectOption('#remove-part', 'ropes.rope-1');
  await page.click('#remove-form button');
  await solved(page, first + 2);
  assert.ok(!(await text()).includes('rope-1'));
  await page.click('#undo');
  await page.click('#undo');
  await page.waitForFunction((t) => window.netloftDesigner.text.files[0].text === t, before);
  assert.deepEqual([seen.errors.filter((e) => !/status of 422/.test(e)), seen.requests], [[], []]);  // the browser logs the refusal
});

test('the start stands beside the gear, at one scale, and differences are those from it', async () => {
  const {address} = await serve(), {page, seen} = await open(browser.context, address), first = await revision(page), h = await height(page);
  await openTable(page, 'tow');
  await page.fill('.one-number[data-path="tow.speed"] input[type=number]', '4');
  await page.keyboard.press('Tab');
  await solved(page, first + 1);
  await page.click('#keep-beside');
  await page.waitForFunction(() => /as kept/.test(document.getElementById('said').textContent), null, {timeout: 30000});
  assert.match(await page.textContent('#keys div:nth-child(3) small'), /no difference/);
  await page.selectOption('#beside', 'start');
  await page.waitForFunction(() => document.getElementById('compared-with').textContent === 'the start' && window.netloftViewer.panes.areTwo && window.netloftViewer.results[1].file === 'the start', null, {timeout: 30000});
  await drawn(page);
  const {scale, heights, names} = await page.evaluate(() => {
    const v = window.netloftViewer, high = (i) => { const z = Array.from(v.models[i].points).filter((_, k) => k % 3 === 2); return Math.max(...z) - Math.min(...z); };
    const project = (pane) => v.panes.within(pane, () => [[0, 0, 0], [0, 0, 1]].map((p) => v.camera.project(p)[1]));
    return {scale: v.panes.list.map((pane) => { const [a, b] = project(pane); return a - b; }), heights: [high(0), high(1)], names: [...document.querySelectorAll('#dimensions > svg > text:last-of-type')].length};
  });
  assert.ok(Math.abs(scale[0] - scale[1]) < 1e-9 && scale[0] > 0, 'one scale, one direction of view');
  assert.notEqual(heights[0], heights[1]);
  assert.equal(names, 2);
  const said = (await page.textContent('#report tbody tr:has(th:text-is("mouth, headline height")) td:nth-child(5)'));
  assert.ok(Math.abs(parseFloat(said) - h) < 1e-3 * h, said);
  const box = await page.locator('#canvas').boundingBox();
  const spot = await page.evaluate(() => { const v = window.netloftViewer, pane = v.panes.list[1]; return v.panes.within(pane, () => v.camera.project(v.models[1].at(v.results[1].tri[0])).map((x, i) => (i === 0 ? x + pane.left : x))); });
  await page.mouse.click(box.x + spot[0], box.y + spot[1]);
  assert.equal(await page.evaluate(() => window.netloftViewer.selection.hit && window.netloftViewer.selection.hit.pane), 1);
  await page.evaluate(() => window.netloftViewer.selection.set(null));
  await page.selectOption('#beside', '');
  await page.waitForFunction(() => window.netloftViewer.results.length === 1);
  assert.equal(await page.textContent('#compared-with'), 'at the start');
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('everything on the page is reached with the Tab key, and a number is changed by keys alone', async () => {
  const {address} = await serve(), {page} = await open(browser.context, address), first = await revision(page);
  const wanted = await page.evaluate(() => ['undo', 'save-text', 'beside', 'keep-beside', 'export', 'do-export', 'tab-plan', 'canvas', 'filter', 'set', 'add-kind', 'add-count', 'remove-part', 'figure', 'ask-influences', 'moved', 'ask-sweep', 'ask-range', 'target', 'ask-reach', 'ask-errors'].filter((id) => !document.getElementById(id).disabled));
  const reached = new Set();
  await page.evaluate(() => { document.activeElement.blur(); document.querySelector('details[data-table="tow"]').open = true; });
  for (let i = 0; i < 300 && (reached.size === 0 || !wanted.every((id) => reached.has(id)) || !reached.has('tow.speed')); ++i) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => document.activeElement.id || (document.activeElement.closest('.one-number') || {dataset: {}}).dataset.path);
    if (at === 'tow.speed' && !reached.has(at)) await page.keyboard.press('ArrowRight');
    reached.add(at);
  }
  assert.deepEqual(wanted.filter((id) => !reached.has(id)), []);
  await solved(page, first + 1);
});

test('without WebGL the plan, the numbers and the report still work', async () => {
  const {address} = await serve(), {page} = await open(flat.context, address);
  assert.ok(await page.isHidden('#app'));
  assert.ok(await page.isVisible('#pane-plan svg'));
  const h = await height(page), first = await revision(page);
  await openTable(page, 'tow');
  await sliderOf(page, 'tow.speed').focus();
  await page.keyboard.press('ArrowRight');
  await solved(page, first + 1);
  assert.ok(await height(page) < h);
  assert.ok(await page.locator('#report tbody tr').count() > 20);
});

test('a narrow window and a dark one keep everything in reach', async () => {
  const {address} = await serve(), {page} = await open(browser.context, address, {width: 420, height: 800, scheme: 'dark'});
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= window.innerWidth + 1), 'nothing is cut off at the side');
  for (const id of ['pane-plan', 'stage', 'number-list', 'report']) assert.ok(await page.isVisible(`#${id}`), id);
});

test('axe finds no violation of WCAG 2 A or AA, in light and dark', async () => {
  const {address} = await serve();
  for (const scheme of ['light', 'dark']) {
    const {page} = await open(browser.context, address, {scheme});
    await openTable(page, 'tow');
    await drawn(page);
    await page.evaluate(readFileSync(AXE, 'utf8'));
    const {violations} = await page.evaluate(() => window.axe.run(document, {runOnly: ['wcag2a', 'wcag2aa']}));
    assert.deepEqual(violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html).slice(0, 3).join(' ')}`), [], scheme);
    await page.close();
  }
});

test('the program ends some seconds after its page', async () => {
  const {address, process: program} = await serve(), {page} = await open(browser.context, address);
  const ended = new Promise((done) => program.once('exit', done));
  await page.close();
  assert.equal(await Promise.race([ended, new Promise((done) => setTimeout(() => done('still there'), 20000))]), 0);
});
