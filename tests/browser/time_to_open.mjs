// SPDX-License-Identifier: BSD-3-Clause
// node time_to_open.mjs PAGE NODES: seconds from opening the file to a drawn picture, the best of three.
import {statSync} from 'node:fs';
import {launch, open} from './browser.mjs';

const [, , file, nodes] = process.argv;
const browser = await launch();
const seconds = [];
for (let i = 0; i < 3; ++i) {
  const begin = performance.now();
  const {page} = await open(browser.context, file);
  seconds.push((performance.now() - begin) / 1000);
  await page.close();
}
await browser.close();
console.log(`${nodes} nodes: page of ${(statSync(file).size / 1e6).toFixed(2)} MB opens in ${Math.min(...seconds).toFixed(2)} s`);
