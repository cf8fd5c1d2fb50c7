// SPDX-License-Identifier: BSD-3-Clause
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdirSync, readFileSync, statSync, writeFileSync} from 'node:fs';
import {createRequire} from 'node:module';
import {join} from 'node:path';
import {after, before, test} from 'node:test';
import validator from 'gltf-validator';
import {PNG} from 'pngjs';
import {blocks, canvasPixels, drawn, launch, luminances, open, quarter, variance} from './browser.mjs';

const PICTURES = join(process.env.NETLOFT_SOURCE_DIR, 'tests/browser/pictures');
const AXE = createRequire(import.meta.url).resolve('axe-core/axe.min.js');

function view(page, ...results) {
  execFileSync(process.env.NETLOFT_PROGRAM, ['view', ...results.map((r) => `${r}.hdf`), '-o', page], {stdio: 'pipe'});
  return join(process.cwd(), page);
}

const shown = new Map();  // pages that several tests look at, opened once
let browser;

async function opened(name, ...results) {
  if (!shown.has(name)) shown.set(name, await open(browser.context, view(`${name}.html`, ...results)));
  return shown.get(name);
}

async function sizeOfStage(page, width, height) {
  await page.evaluate(([w, h]) => { Object.assign(document.getElementById('stage').style, {width: w, height: h}); window.netloftViewer.resize(); }, [width, height]);
  await drawn(page);
}

before(async () => { browser = await launch(); });
after(async () => { await browser.close(); });

test('a page draws a gear and not a blank, without a word on the console or the network', async () => {
  const {page, seen} = await opened('trawl', 'trawl');
  assert.equal(await page.evaluate(() => document.documentElement.dataset.ready), 'yes');
  const light = luminances(await canvasPixels(page));
  assert.ok(variance(light) > 60, `variance ${variance(light)}`);
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('six views of the 83-112 look as when somebody last looked at them', async () => {
  const {page} = await opened('trawl', 'trawl');
  await sizeOfStage(page, '804px', '632px');  // whatever a page has above it
  const views = [['side', 'tension'], ['top', 'tension'], ['front', 'tension'], ['oblique', 'tension'], ['oblique', 'opening'], ['oblique', 'part']];
  for (const [view_, field] of views) {
    await page.evaluate(([v, f]) => { window.netloftViewer.setField(f); window.netloftViewer.look(v); }, [view_, field]);
    const png = quarter(await canvasPixels(page)), file = join(PICTURES, `${view_}-${field}.png`);
    if (process.env.NETLOFT_NEW_PICTURES) { mkdirSync(PICTURES, {recursive: true}); writeFileSync(file, PNG.sync.write(png)); continue; }
    const stored = PNG.sync.read(readFileSync(file));
    assert.deepEqual([png.width, png.height], [stored.width, stored.height], file);
    const now = blocks(png, 3), then = blocks(stored, 3);
    const off = Math.max(...now.map((v, i) => Math.abs(v - then[i])));
    assert.ok(off < 40, `${view_}, ${field}: a block differs by ${off.toFixed(0)} of 255`);
    const mean = now.reduce((sum, v, i) => sum + Math.abs(v - then[i]), 0) / now.length;
    assert.ok(mean < 1.5, `${view_}, ${field}: blocks differ by ${mean.toFixed(2)} on average`);
  }
  await sizeOfStage(page, '', '');
});

test('a click finds the part that is there, and the plan the same place', async () => {
  const {page} = await opened('trawl', 'trawl');
  const spots = await page.evaluate(() => {
    const v = window.netloftViewer, r = v.result, found = [];
    v.selection.set(null);
    for (const [name, view] of [['top-wing', 'oblique'], ['bottom-wing', 'front'], ['headrope', 'front'], ['headline', 'front']]) {
      v.look(view);
      const part = r.parts.findIndex((p) => p.name === name);
      const [parts, nodes, of] = [[r.triPart, r.tri, 3], [r.barPart, r.bar, 2], [r.dotPart, r.dot, 1]].find(([p]) => p.includes(part));
      for (let i = 0; i < parts.length; ++i) {
        if (parts[i] !== part) continue;
        const middle = [0, 1, 2].map((k) => Array.from({length: of}, (_, c) => v.model.points[3 * nodes[of * i + c] + k] / of).reduce((a, b) => a + b, 0));
        const [x, y] = v.camera.project(middle), hit = v.pickAt(x, y);
        if (hit && hit.part === part && hit.index === i) { found.push({name, view, x, y}); break; }
      }
    }
    return found;
  });
  assert.deepEqual(spots.map((s) => s.name), ['top-wing', 'bottom-wing', 'headrope', 'headline']);
  const canvas = await page.locator('#canvas').boundingBox();
  for (const spot of spots) {
    await page.evaluate((view) => window.netloftViewer.look(view), spot.view);
    await page.mouse.click(canvas.x + spot.x, canvas.y + spot.y);
    assert.match(await page.textContent('#selection'), new RegExp(`^part${spot.name}type`));
  }
  // From the plan to the shape: the same element is selected in both.
  const place = await page.evaluate(() => {
    const v = window.netloftViewer, part = v.result.parts.findIndex((p) => p.name === 'top-body');
    v.plan.fit();
    // The largest: clicks are at whole pixels, and small triangles have few.
    const size = (k) => { const [a, b, c] = [0, 2, 4].map((i) => v.plan.at(6 * k + i)); return Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])); };
    const t = [...v.result.triPart.keys()].filter((k) => v.result.triPart[k] === part).reduce((best, k) => (size(k) > size(best) ? k : best));
    return {at: v.plan.whereIs({index: t, weights: [1 / 3, 1 / 3, 1 / 3]}), t};
  });
  const plan = await page.locator('#plan').boundingBox();
  await page.mouse.click(plan.x + place.at[0], plan.y + place.at[1]);
  assert.match(await page.textContent('#selection'), /^parttop-bodytype.*meshes across/);
  assert.equal(await page.evaluate(() => window.netloftViewer.selection.hit.index), place.t);
  assert.equal(await page.locator('#dimensions .selected').count(), 2);
});

test('a second click with Shift measures a distance', async () => {
  const {page} = await opened('trawl', 'trawl');
  const metres = await page.evaluate(() => {
    const {selection, model} = window.netloftViewer, part = model.result.parts.findIndex((p) => p.name === 'headline');
    const floats = Array.from(model.result.dot.keys()).filter((i) => model.result.dotPart[i] === part).slice(0, 2);
    const hit = (i) => ({kind: 'point', index: i, part, cell: model.result.dotCell[i], nodes: [model.result.dot[i]], weights: [1], mirrored: false});
    selection.set(hit(floats[0]));
    selection.set(hit(floats[1]), true);
    const [a, b] = floats.map((i) => model.at(model.result.dot[i]));
    return Math.hypot(...a.map((v, d) => v - b[d]));
  });
  assert.ok(metres > 0.05);
  const said = Number(/distance([0-9.]+) m/.exec(await page.textContent('#selection'))[1]);
  assert.ok(Math.abs(said - metres) < 1e-3 * metres + 1e-3, `${said} ${metres}`);
  await page.evaluate(() => window.netloftViewer.selection.set(null));
});

test('colours of netting are means at its nodes, or those of each element', async () => {
  const {page} = await opened('trawl', 'trawl');
  const spread = (byElement) => page.evaluate((by) => {
    const v = window.netloftViewer;
    document.getElementById('by-element').checked = by;
    v.setField('tension');
    const values = v.model.netting.attributes.value.array;
    let largest = 0;
    for (let t = 0; t < values.length; t += 3) largest = Math.max(largest, Math.abs(values[t] - values[t + 1]));
    return largest;
  }, byElement);
  assert.equal(await spread(true), 0);
  assert.ok(await spread(false) > 1);
});

test('netting and ropes have legends of their own, with round numbers', async () => {
  const {page} = await opened('trawl', 'trawl');
  await page.evaluate(() => window.netloftViewer.setField('tension'));
  assert.equal(await page.locator('#legend svg').count(), 2);
  for (const text of await page.locator('#legend svg text').allTextContents()) assert.match(text, /^([<>]|[0-9.]+)$/);
});

test('the force of the bed shows where the gear touches it', async () => {
  const {page} = await opened('trawl', 'trawl');
  const shown = () => page.evaluate(() => { const {model} = window.netloftViewer; return model.result.parts.filter((p, i) => p.contact && model.shown[i]).length; });
  assert.equal(await shown(), 0);
  await page.evaluate(() => window.netloftViewer.setField('normal_force'));
  assert.ok(await shown() > 0);
  await page.evaluate(() => window.netloftViewer.setField('tension'));
  assert.equal(await shown(), 0);
});

test('a cod-end shows its catch, closed in front', async () => {
  const {page, seen} = await opened('codend', 'codend');
  const facts = await page.evaluate(() => {
    const v = window.netloftViewer, {triangles, rim} = v.result.catch;
    return {part: triangles.length / v.result.triPart.length, rim: rim.length / 2, moved: v.model.catchBody.attributes.position.array.every(Number.isFinite)};
  });
  assert.ok(facts.part > 0.2 && facts.part < 0.9, JSON.stringify(facts));
  assert.ok(facts.rim > 4 && facts.moved, JSON.stringify(facts));
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('boards are plates that a click finds, with their attitude; the ship is ahead of the warps', async () => {
  const {page, seen} = await opened('boards', 'boards');
  const facts = await page.evaluate(() => {
    const v = window.netloftViewer, {solids, result} = v.model;
    v.look('top');
    const corners = solids.at(solids.corners, 0, false), middle = [0, 1, 2].map((d) => (corners[0][d] + corners[1][d] + corners[2][d]) / 3);
    const [x, y] = v.camera.project(middle), hit = v.pickAt(x, y), hull = Array.from({length: v.model.solids.hullCorners.length / 9}, (_, t) => solids.at(solids.hullCorners, t, false)).flat();
    document.getElementById('extent').value = 'all';
    v.fit();
    v.selection.set(hit);
    return {part: hit && result.parts[hit.part].name, aft: Math.max(...hull.map((p) => p[0])) + result.origin[0], inside: hull.every((p) => { const [a, b] = v.camera.project(p); return a > 0 && a < v.camera.width && b > 0 && b < v.camera.height; })};
  });
  assert.equal(facts.part, 'board');
  assert.ok(Math.abs(facts.aft) < 0.01 && facts.inside, JSON.stringify(facts));
  assert.match(await page.textContent('#selection'), /heading-?[0-9.]+°/);
  assert.match(await page.textContent('main'), /board spread/);
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('pages of small gears stay below two megabytes', async () => {
  for (const result of ['trawl', 'codend', 'slower']) {
    const {size} = statSync(view(`${result}-size.html`, result));
    assert.ok(size < 2e6, `${result}: ${size} bytes`);
  }
});

test('netting is drawn in its twines at any zoom', async () => {
  const {page} = await opened('trawl', 'trawl');
  // Across a patch of netting seen closely, lines and gaps follow one another; the count is that of the twines.
  const edges = await page.evaluate(() => {
    const v = window.netloftViewer, r = v.result, part = r.parts.findIndex((p) => p.name === 'top-body');
    v.selection.set(null);
    v.setField('part');
    v.look('top');
    v.camera.target = [0, 1, 2].map((k) => v.model.points[3 * r.tri[3 * (r.triPart.indexOf(part) + 40)] + k]);
    v.camera.pixelsPerMetre = 2000;
    v.drawNow();
    const gl = v.renderer.getContext(), [w, h] = [gl.drawingBufferWidth, gl.drawingBufferHeight], row = new Uint8Array(4 * w);
    gl.readPixels(0, Math.floor(h / 2), w, 1, gl.RGBA, gl.UNSIGNED_BYTE, row);
    const light = Array.from({length: w}, (_, i) => row[4 * i] + row[4 * i + 1] + row[4 * i + 2]);
    let changes = 0;
    for (let i = 1; i < w; ++i) changes += Math.abs(light[i] - light[i - 1]) > 60 ? 1 : 0;
    return {changes, metres: w / v.camera.pixelsPerMetre};
  });
  assert.ok(edges.changes >= 4 && edges.changes < 200, JSON.stringify(edges));
});

test('the slider moves a motion, and the keyboard does what the mouse does', async () => {
  const {page, seen} = await opened('motion', 'motion');
  const first = await page.evaluate(() => Array.from(window.netloftViewer.model.points));
  await page.locator('#frame').focus();
  await page.keyboard.press('Home');
  await page.waitForFunction(() => window.netloftViewer.frames.index === 0 && window.netloftViewer.curves);
  const moved = await page.evaluate((before_) => Math.max(...before_.map((v, i) => Math.abs(v - window.netloftViewer.model.points[i]))), first);
  assert.ok(moved > 0.01, `moved ${moved}`);
  assert.match(await page.textContent('#when'), /^0 s$/);
  const blue = await page.evaluate(() => {
    const canvas = document.querySelector('#curve canvas'), pixels = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
    let found = 0;
    for (let i = 0; i < pixels.length; i += 4) found += pixels[i + 2] > pixels[i] + 100 && pixels[i + 3] > 200 ? 1 : 0;
    return found;
  });
  assert.ok(blue > 100, `the curve has ${blue} pixels`);
  await page.locator('#canvas').focus();
  const azimuth = await page.evaluate(() => window.netloftViewer.camera.azimuth);
  await page.keyboard.press('ArrowLeft');
  assert.notEqual(await page.evaluate(() => window.netloftViewer.camera.azimuth), azimuth);
  await page.keyboard.press('n');
  assert.match(await page.textContent('#selection'), /^part/);
  await page.keyboard.press('Escape');
  assert.match(await page.textContent('#selection'), /^Nothing is selected/);
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('keys select every part that is shown, any place, and measure', async () => {
  const {page, seen} = await opened('trawl', 'trawl');
  await page.evaluate(() => { window.netloftViewer.setField('tension'); window.netloftViewer.selection.set(null); });
  await page.locator('#canvas').focus();
  const shown = await page.evaluate(() => { const {result, shown: is} = window.netloftViewer.model; return result.parts.filter((p, i) => is[i]).map((p) => p.name).sort(); });
  const hit = () => page.evaluate(() => { const v = window.netloftViewer, h = v.selection.hit; return {...h, name: v.result.parts[h.part].name}; });
  const found = new Set();
  for (let i = 0; i < shown.length; ++i) { await page.keyboard.press('PageDown'); found.add((await hit()).name); }
  assert.deepEqual([...found].sort(), shown);
  // From the last element of the netting to the first of the ropes.
  await page.evaluate(() => { const {selection, result} = window.netloftViewer; selection.take('netting', result.triPart.length - 1); });
  await page.keyboard.press('n');
  assert.equal((await hit()).kind, 'rope');
  await page.keyboard.press('p');
  assert.equal((await hit()).kind, 'netting');
  // Under the cross: what a click in the middle would find, moved there by keys.
  await page.keyboard.press('4');
  for (const key of ['+', '+', 'Shift+ArrowLeft']) await page.keyboard.press(key);
  await drawn(page);
  assert.equal(await page.locator('#cross').evaluate((cross) => getComputedStyle(cross).display), 'block');
  const expected = await page.evaluate(() => { const v = window.netloftViewer; return v.pickAt(v.camera.width / 2, v.camera.height / 2); });
  assert.ok(expected);
  await page.keyboard.press('Enter');
  assert.deepEqual((({kind, index}) => ({kind, index}))(await hit()), {kind: expected.kind, index: expected.index});
  await page.keyboard.press('Shift+ArrowUp');
  await page.keyboard.press('Shift+Enter');
  assert.match(await page.textContent('#selection'), /^distance[0-9.]+ m/);
  assert.ok(await page.evaluate(() => window.netloftViewer.isTouched));  // paper and windows keep what was turned to
  await page.keyboard.press('Escape');
  await page.keyboard.press('0');
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('everything that can be operated is reached with the Tab key', async () => {
  const {page} = await opened('trawl', 'trawl');
  const wanted = await page.evaluate(() => {
    document.activeElement.blur();
    const all = [...document.querySelectorAll('button, select, input, summary, a[href], [tabindex="0"]')].filter((e) => e.checkVisibility() && !e.disabled);
    all.forEach((e, i) => { e.dataset.order = String(i); });
    return all.length;
  });
  assert.ok(wanted > 30, `${wanted} controls`);
  const reached = new Set();
  for (let i = 0; i < wanted + 5; ++i) {
    await page.keyboard.press('Tab');
    const at = await page.evaluate(() => { const e = document.activeElement, {outlineStyle} = getComputedStyle(e); return {order: e.dataset.order, outlineStyle}; });
    if (at.order === undefined) continue;
    reached.add(at.order);
    assert.notEqual(at.outlineStyle, 'none', `control ${at.order} does not show that it has the focus`);
  }
  assert.equal(reached.size, wanted);
});

test('a dimension line is drawn where both its ends are in the picture', async () => {
  const {page} = await opened('trawl', 'trawl');
  const outside = await page.evaluate(() => {
    const v = window.netloftViewer, off = [];
    let drawnLines = 0;
    for (const view_ of ['side', 'top', 'front', 'oblique']) {
      v.look(view_);
      v.drawNow();
      for (const path of document.querySelectorAll('#dimensions path.dimension')) {
        const [[, x, y], [, x2, y2]] = [...path.getAttribute('d').matchAll(/[ML]([-0-9.e]+) ([-0-9.e]+)/g)];
        ++drawnLines;
        if ([x, x2].some((a) => a < 0 || a > v.camera.width) || [y, y2].some((a) => a < 0 || a > v.camera.height)) off.push(view_);
      }
    }
    return {off, drawnLines};
  });
  assert.deepEqual(outside.off, []);
  assert.ok(outside.drawnLines >= 6, `${outside.drawnLines} lines`);
});

test('words of dimension lines lie over no others', async () => {
  const {page} = await opened('trawl', 'trawl');
  const {over, words} = await page.evaluate(() => {
    const v = window.netloftViewer, clashes = [];
    const overlap = (a, b) => a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
    let count = 0;
    for (const view_ of ['side', 'top', 'front', 'oblique']) {
      v.look(view_);
      v.drawNow();
      const boxes = [...document.querySelectorAll('#dimensions text.dimension')].map((text) => text.getBBox());
      count += boxes.length;
      boxes.forEach((one, i) => boxes.slice(i + 1).forEach((other) => { if (overlap(one, other)) clashes.push(view_); }));
    }
    return {over: clashes, words: count};
  });
  assert.deepEqual(over, []);
  assert.ok(words >= 6, `${words} words`);
});

test('a motion is played, again from its start, until it is stopped', async () => {
  const {page} = await opened('motion', 'motion');
  const index = () => page.evaluate(() => window.netloftViewer.frames.index), last = await page.evaluate(() => window.netloftViewer.frames.all.length - 1);
  await page.evaluate((to) => window.netloftViewer.showFrame(to), last);
  await page.locator('#play').click();
  await page.waitForFunction((end) => { const {index: i} = window.netloftViewer.frames; return i > 0 && i < end; }, last);
  await page.locator('#play').click();
  assert.equal(await page.textContent('#play'), 'Play');
  const stopped = await index();
  await page.waitForTimeout(300);
  assert.equal(await index(), stopped);
});

test('a click at a curve goes to that time', async () => {
  const {page} = await opened('motion', 'motion');
  const box = await page.locator('#curve .u-over').boundingBox();
  await page.mouse.move(box.x + box.width / 4, box.y + box.height / 2);
  await page.mouse.click(box.x + box.width / 4, box.y + box.height / 2);
  await page.waitForFunction(() => { const {index, all} = window.netloftViewer.frames; return Math.abs(index / (all.length - 1) - 0.25) < 0.1; });
});

test('the legend covers no part of a gear that was fitted', async () => {
  for (const name of ['trawl', 'motion', 'codend']) {
    const {page} = await opened(name, name);
    for (const view_ of ['side', 'top', 'front', 'oblique']) {
      const covered = await page.evaluate((v_) => {
        const v = window.netloftViewer, {left, top} = v.canvas.getBoundingClientRect(), legend = document.getElementById('legend').getBoundingClientRect();
        v.look(v_);
        return [...v.model.places('netting')].map((p) => v.camera.project(p)).filter(([x, y]) => x + left < legend.right && y + top < legend.bottom && x + left > legend.left && y + top > legend.top).length;
      }, view_);
      assert.equal(covered, 0, `${name}, ${view_}`);
    }
  }
});

test('a section takes what lies beyond it out of the picture and out of reach', async () => {
  const {page} = await opened('trawl', 'trawl');
  const facts = await page.evaluate(() => {
    const v = window.netloftViewer, {result, model} = v, section = document.getElementById('section');
    v.look('top');
    const parts = result.parts.map((p) => p.name), aft = result.triPart.lastIndexOf(parts.indexOf('top-codend')), fore = result.triPart.indexOf(parts.indexOf('top-body'));
    const at = (t) => [0, 1, 2].map((k) => [0, 1, 2].reduce((sum, c) => sum + model.points[3 * result.tri[3 * t + c] + k] / 3, 0));
    const found = (t) => { const [x, y] = v.camera.project(at(t)); return Boolean(v.pickAt(x, y)); };
    const cut = (axis) => { section.value = axis; section.dispatchEvent(new Event('change')); v.drawNow(); return [found(fore), found(aft)]; };
    return {whole: cut(''), cut: cut('x'), again: cut('')};
  });
  assert.deepEqual(facts, {whole: [true, true], cut: [true, false], again: [true, true]});
  const all = luminances(await canvasPixels(page));
  await page.locator('#section').selectOption('x');
  await drawn(page);
  const some = luminances(await canvasPixels(page));
  assert.ok(some.filter((v, i) => Math.abs(v - all[i]) > 20).length > 500);
  await page.locator('#section').selectOption('');
});

test('parts are hidden and isolated', async () => {
  const {page} = await opened('trawl', 'trawl');
  await page.evaluate(() => { window.netloftViewer.setField('part'); window.netloftViewer.look('oblique'); });
  const all = blocks(await canvasPixels(page), 12);
  await page.getByRole('button', {name: 'show top-wing only'}).click();
  await drawn(page);
  const one = blocks(await canvasPixels(page), 12);
  assert.ok(one.some((v, i) => Math.abs(v - all[i]) > 20));
  await page.getByRole('button', {name: 'show top-wing only'}).click();
});

test('a solve that did not end says so, and where it is farthest from equilibrium', async () => {
  const {page, seen} = await opened('broken', 'broken');
  assert.match(await page.textContent('.badge >> nth=0'), /not converged/);
  assert.match(await page.textContent('#dimensions'), /largest force out of balance, [0-9.]+ kN/);
  const worst = /at (\S+) node (\d+)/.exec(await page.textContent('main'));
  const marked = await page.evaluate(() => {
    const {model, camera} = window.netloftViewer, ring = document.querySelector('#dimensions circle'), {result} = model;
    const at = [Number(ring.getAttribute('cx')), Number(ring.getAttribute('cy'))];
    const off = (n) => { const p = camera.project(model.at(n)); return Math.hypot(p[0] - at[0], p[1] - at[1]); };
    return Array.from({length: result.nPoints}, (_, n) => n).filter((n) => off(n) < 0.01).map((n) => `${result.parts[result.nodePart[n]].name} ${result.nodeNumber[n]}`);
  });
  assert.ok(marked.includes(`${worst[1]} ${worst[2]}`), `${marked} ${worst}`);
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('the bed is a line when seen from its edge', async () => {
  const {page} = await opened('trawl', 'trawl');
  const lines = async (view_) => { await page.evaluate((v) => window.netloftViewer.look(v), view_); await drawn(page); return page.locator('#dimensions .bed').count(); };
  assert.deepEqual([await lines('side'), await lines('top')], [1, 0]);
});

test('paper has the picture in its own size, on light ground', async () => {
  const {page, seen} = await open(browser.context, view('paper.html', 'slower'), {scheme: 'dark'});
  const facts = () => page.evaluate(() => {
    const v = window.netloftViewer, {width, height} = document.getElementById('stage').getBoundingClientRect(), wing = v.result.dimensions.find((d) => /upper wing/.test(d.name));
    return {ratio: width / height, canvas: v.canvas.width / v.canvas.height, dark: getComputedStyle(document.documentElement).getPropertyValue('--is-dark').trim(),
      inside: v.camera.project(v.model.at(wing.from.node))[0] < width};
  });
  await page.evaluate(() => window.dispatchEvent(new Event('beforeprint')));
  const paper = await facts();
  assert.ok(Math.abs(paper.ratio - 186 / 105) < 0.02 && Math.abs(paper.canvas - paper.ratio) < 0.02, JSON.stringify(paper));
  assert.deepEqual([paper.dark, paper.inside], ['0', true]);
  await page.evaluate(() => window.dispatchEvent(new Event('afterprint')));
  assert.equal((await facts()).dark, '1');
  assert.deepEqual(seen, {errors: [], requests: []});
  await page.close();
});

test('two results are laid over one another and coloured by their distance', async () => {
  const {page, seen} = await opened('two', 'slower', 'faster');
  const facts = await page.evaluate(() => {
    const v = window.netloftViewer;
    return {field: v.field.name, largest: v.scales[0].hi, models: v.models.map((m) => m.group.visible)};
  });
  assert.equal(facts.field, 'move');
  assert.equal(await page.locator('#legend svg').count(), 1);  // metres are metres, of netting or of ropes
  assert.ok(facts.largest > 0.3 && facts.largest < 10, `largest ${facts.largest}`);  // metres between 2 and 4 knots
  assert.deepEqual(facts.models, [true, true]);
  assert.match(await page.textContent('main'), /What changed/);
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('two results stand beside each other, and the picture of each is its own', async () => {
  const {page, seen} = await opened('two', 'slower', 'faster');
  await page.selectOption('#overlay', 'beside');
  await drawn(page);
  const high = await page.evaluate(() => {
    const v = window.netloftViewer, span = (i) => { const y = v.panes.within(v.panes.list[i], () => [...v.models[i].places('netting')].map((p) => v.camera.project(p))); return [0, 1].map((k) => [Math.min(...y.map((p) => p[k])), Math.max(...y.map((p) => p[k]))]); };
    v.look('side');
    return {spans: [span(0), span(1)], width: v.panes.list[0].width};
  });
  for (const [[left, right]] of high.spans) assert.ok(left >= 0 && right <= high.width, JSON.stringify(high));
  const [slow, fast] = high.spans.map(([, [top, bottom]]) => bottom - top);
  assert.ok(slow > 1.1 * fast, `a slower net is higher at the same scale: ${slow} and ${fast} pixels`);
  const png = await canvasPixels(page), half = png.width / 2, dark = [0, 0];
  luminances(png).forEach((light, i) => { if (light < 120) ++dark[i % png.width < half ? 0 : 1]; });
  assert.ok(dark.every((count) => count > 500), `netting in both halves: ${dark}`);
  await page.selectOption('#overlay', 'both');
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('two results on different meshes are compared place by place on their panels', async () => {
  const {page, seen} = await opened('meshes', 'slower', 'trawl');
  const facts = await page.evaluate(() => {
    const v = window.netloftViewer, part = (field) => {
      v.setField(field);
      const values = v.model.netting.attributes.value.array;
      return {known: values.filter((x) => x > -1e37).length / values.length, hi: v.scales[0].hi, lo: v.scales[0].lo};
    };
    return {move: part('move'), change: part('change of tension')};
  });
  assert.ok(facts.move.known > 0.9 && facts.move.hi > 0.3 && facts.move.hi < 10, JSON.stringify(facts));
  assert.ok(facts.change.known > 0.9 && facts.change.lo === -facts.change.hi, JSON.stringify(facts));
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('the slider goes through the stages of a solve, from the start to its end', async () => {
  const {page, seen} = await opened('stages', 'stages');
  const names = await page.evaluate(() => window.netloftViewer.result.stages);
  assert.ok(names.length > 2, names.join(', '));
  assert.equal(names[0], 'start');
  assert.equal(names.at(-1), 'converged');
  assert.match(await page.textContent('#when'), /converged$/);
  // Colours are for the result: on the way ropes carried a million times as much.
  assert.ok(await page.evaluate(() => window.netloftViewer.scales[1].hi) < 1e5);
  const end = await page.evaluate(() => Array.from(window.netloftViewer.model.points));
  await page.locator('#frame').focus();
  await page.keyboard.press('Home');
  await page.waitForFunction(() => window.netloftViewer.frames.index === 0);
  assert.match(await page.textContent('#when'), /start$/);
  const moved = await page.evaluate((before_) => Math.max(...before_.map((v, i) => Math.abs(v - window.netloftViewer.model.points[i]))), end);
  assert.ok(moved > 0.1, `moved ${moved}`);
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('three results are a sweep over the setting in which they differ', async () => {
  const {page} = await opened('sweep', 'slower', 'trawl', 'faster');
  const curve = await page.evaluate(() => { const {choices} = window.netloftViewer.curves; return {x: choices[0].x, over: choices[0].over}; });
  assert.deepEqual(curve, {x: [2, 3, 4], over: 'tow.speed [kn]'});
  const inked = await page.evaluate(() => {
    const plan = document.getElementById('plan'), {data} = plan.getContext('2d').getImageData(0, 0, plan.width, plan.height);
    return data.filter((v, i) => i % 4 === 3 && v > 200).length;
  });
  assert.ok(inked > 500, `the plan has ${inked} pixels`);
  const drag = page.locator('#keys [data-figure="drag/all/x"]'), fast = await drag.textContent();
  assert.equal(await page.textContent('#when'), 'tow.speed = 4.0 kn');
  await page.locator('#frame').focus();
  await page.keyboard.press('Home');
  await page.waitForFunction(() => window.netloftViewer.frames.index === 0);
  assert.equal(await page.textContent('#when'), 'tow.speed = 2.0 kn');
  assert.deepEqual(await page.evaluate(() => window.netloftViewer.models.map((m) => m.group.visible)), [true, false, false]);
  assert.notEqual(await drag.textContent(), fast);
});

test('a page with scripts and WebGL switched off keeps its report and its pictures', async () => {
  const bare = await launch({webgl: false});
  try {
    const {page, seen} = await open(bare.context, view('trawl.html', 'trawl'));
    assert.equal(await page.evaluate(() => document.documentElement.dataset.ready), 'static');
    assert.match(await page.textContent('#status'), /does not draw in three dimensions/);
    assert.equal(await page.locator('#pictures svg').count(), 4);  // three views and the plan
    assert.ok(await page.locator('#pictures').isVisible());
    assert.match(await page.textContent('main'), /headline height/);
    assert.deepEqual(seen.requests, []);
  } finally {
    await bare.close();
  }
});

test('what a result says is shown and never executed', async () => {
  const {page, seen} = await opened('hostile', 'hostile');
  await page.evaluate(() => window.netloftViewer.selection.step(1));
  assert.match(await page.textContent('#selection'), /<img src=x onerror=alert\(1\)>/);
  assert.equal(await page.locator('img').count(), 0);
  assert.deepEqual(seen, {errors: [], requests: []});
});

test('shapes for other programs are valid glTF', async () => {
  for (const result of ['trawl', 'codend', 'motion', 'hostile', 'boards']) {
    execFileSync(process.env.NETLOFT_PROGRAM, ['export', `${result}.hdf`, `${result}.glb`], {stdio: 'pipe'});
    const {issues} = await validator.validateBytes(new Uint8Array(readFileSync(`${result}.glb`)));
    assert.deepEqual(issues.messages.map((m) => `${m.code} ${m.pointer}`), [], result);
  }
});

const PAGES = {motion: ['motion'], trawl: ['trawl'], boards: ['boards'], two: ['slower', 'faster'], sweep: ['slower', 'trawl', 'faster']};

async function violations(page) {
  // The test's own script is let in past the policy of the page, as an extension of the browser would be.
  await page.evaluate(readFileSync(AXE, 'utf8'));
  const found = await page.evaluate(() => window.axe.run(document, {runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa']}));
  assert.ok(found.passes.length > 5);
  return found.violations.map((v) => `${v.id}: ${v.nodes.map((n) => n.html.slice(0, 120)).join(' | ')}`);
}

for (const scheme of ['light', 'dark'])
  for (const [name, results] of Object.entries(PAGES))
    test(`a page of ${name} is accessible, in ${scheme} colours`, async () => {
      const {page} = await open(browser.context, view(`${name}-axe.html`, ...results), {scheme});
      assert.deepEqual(await violations(page), []);
      await page.close();
    });

test('the report as a page has key figures, loads and pictures with dimensions, and is accessible', async () => {
  execFileSync(process.env.NETLOFT_PROGRAM, ['report', 'trawl.hdf', '-o', 'report.html'], {stdio: 'pipe'});
  const {page, seen} = await open(browser.context, join(process.cwd(), 'report.html'), {scripts: false});
  assert.match(await page.textContent('#keys'), /headline height[0-9.]+ m/);
  assert.ok(await page.locator('meter').count() > 4);
  assert.equal(await page.locator('figure svg').count(), 5);  // four views and the plan
  assert.match(await page.textContent('main'), /upper wing spread 17\.\d m/);
  assert.deepEqual(await violations(page), []);
  assert.deepEqual(seen, {errors: [], requests: []});
  await page.close();
});
