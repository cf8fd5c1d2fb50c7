// SPDX-License-Identifier: BSD-3-Clause
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {pathToFileURL} from 'node:url';
import {chromium} from 'playwright-core';
import {PNG} from 'pngjs';

// Chrome 144 and newer give software WebGL only to those who ask for it.
const WITH_WEBGL = ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist'];
const WITHOUT_WEBGL = ['--disable-3d-apis'];
const QUIET = ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'];

export async function launch({webgl = true} = {}) {
  const profile = mkdtempSync(join(tmpdir(), 'netloft-browser-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.NETLOFT_BROWSER, viewport: {width: 1200, height: 800}, args: [...QUIET, ...(webgl ? WITH_WEBGL : WITHOUT_WEBGL)],
  });
  return {context, close: async () => { await context.close(); rmSync(profile, {recursive: true, force: true}); }};
}

/** Opens a file and waits until it is ready; `seen` keeps errors and requests for anything but the file. */
export async function open(context, file, {scripts = true, scheme = 'light'} = {}) {
  const page = await context.newPage();
  await page.emulateMedia({colorScheme: scheme});
  const seen = {errors: [], requests: []};
  page.on('console', (message) => { if (message.type() === 'error') seen.errors.push(message.text()); });
  page.on('pageerror', (error) => seen.errors.push(error.message));
  page.on('dialog', (dialog) => { seen.errors.push(`a dialog: ${dialog.message()}`); dialog.dismiss(); });
  page.on('request', (request) => { if (!/^(file|data|blob):/.test(request.url())) seen.requests.push(request.url()); });
  await page.goto(pathToFileURL(file).href);
  if (scripts) await page.waitForFunction(() => document.documentElement.dataset.ready, null, {timeout: 60000});
  return {page, seen};
}

/** The next frame is drawn, and the one after it. */
export async function drawn(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));
}

/** The pixels of the canvas of the page's viewer. */
export async function canvasPixels(page) {
  const url = await page.evaluate(() => { window.netloftViewer.drawNow(); return document.getElementById('canvas').toDataURL('image/png'); });
  return PNG.sync.read(Buffer.from(url.split(',')[1], 'base64'));
}

export function luminances(png) {
  const all = [];
  for (let i = 0; i < png.data.length; i += 4) all.push(0.299 * png.data[i] + 0.587 * png.data[i + 1] + 0.114 * png.data[i + 2]);
  return all;
}

export function variance(values) {
  const mean = values.reduce((a, b) => a + b, 0) / values.length;
  return values.reduce((sum, v) => sum + (v - mean) ** 2, 0) / values.length;
}

/** A picture a quarter as wide and high, every pixel the mean of sixteen: small enough to be kept. */
export function quarter(png) {
  const small = new PNG({width: Math.floor(png.width / 4), height: Math.floor(png.height / 4)});
  for (let y = 0; y < small.height; ++y)
    for (let x = 0; x < small.width; ++x)
      for (let k = 0; k < 4; ++k) {
        let sum = 0;
        for (let j = 0; j < 16; ++j) sum += png.data[4 * ((4 * y + (j >> 2)) * png.width + 4 * x + (j & 3)) + k];
        small.data[4 * (y * small.width + x) + k] = Math.round(sum / 16);
      }
  return small;
}

/** Mean luminances of blocks of `size` pixels: what remains of a picture when thin lines may lie a pixel aside. */
export function blocks(png, size) {
  const columns = Math.floor(png.width / size), rows = Math.floor(png.height / size), sums = new Array(columns * rows).fill(0), light = luminances(png);
  for (let y = 0; y < rows * size; ++y) for (let x = 0; x < columns * size; ++x) sums[Math.floor(y / size) * columns + Math.floor(x / size)] += light[y * png.width + x] / size ** 2;
  return sums;
}
