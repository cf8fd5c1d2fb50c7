// SPDX-License-Identifier: BSD-3-Clause
// A design that is served for a test, and its page.
import {spawn} from 'node:child_process';
import {mkdtempSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {createInterface} from 'node:readline';

/** A design in a folder of its own, and the address that it prints. */
export async function serveDesign(text) {
  const cwd = mkdtempSync(join(tmpdir(), 'netloft-design-test-'));
  writeFileSync(join(cwd, 'own.toml'), text);
  const program = spawn(process.env.NETLOFT_PROGRAM, ['design', 'own.toml', '--json'], {cwd, stdio: ['ignore', 'pipe', 'ignore']});
  const line = await new Promise((done) => createInterface({input: program.stdout}).once('line', done));
  const end = () => { program.kill('SIGINT'); rmSync(cwd, {recursive: true, force: true}); };
  return {address: JSON.parse(line).address, file: join(cwd, 'own.toml'), process: program, end};
}

/** Opens the page of a design; `seen` keeps errors, and requests to anything but the program. */
export async function openDesign(context, address, {width = 1400, height = 900, scheme = 'light'} = {}) {
  const page = await context.newPage(), seen = {errors: [], requests: []};
  await page.setViewportSize({width, height});
  await page.emulateMedia({colorScheme: scheme});
  page.on('console', (message) => { if (message.type() === 'error') seen.errors.push(message.text()); });
  page.on('pageerror', (error) => seen.errors.push(error.message));
  page.on('request', (request) => { if (!request.url().startsWith(address) && !/^(data|blob):/.test(request.url())) seen.requests.push(request.url()); });
  await page.goto(address);
  await page.waitForFunction(() => document.documentElement.dataset.ready, null, {timeout: 60000});
  return {page, seen};
}
