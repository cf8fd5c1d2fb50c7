// SPDX-License-Identifier: BSD-3-Clause
// npm ci && npm run build: writes libraries.js, uPlot.css and SHA256SUMS again; the same versions give the same bytes.
import {createHash} from 'node:crypto';
import {readFileSync, writeFileSync} from 'node:fs';
import {buildSync} from 'esbuild';

const licence = (name) => readFileSync(`node_modules/${name}/LICENSE`, 'utf8').trim();
const version = (name) => JSON.parse(readFileSync(`node_modules/${name}/package.json`, 'utf8')).version;
const banner = ['three', 'uplot'].map((name) => `/*! ${name} ${version(name)}\n${licence(name)}\n*/`).join('\n');

buildSync({entryPoints: ['entry.js'], bundle: true, minify: true, format: 'iife', globalName: 'Libraries', charset: 'ascii',
  legalComments: 'none', banner: {js: banner}, outfile: 'libraries.js'});
writeFileSync('uPlot.css', `/*! uplot ${version('uplot')}, MIT, Leon Sorokin */\n` + readFileSync('node_modules/uplot/dist/uPlot.min.css', 'utf8').trim() + '\n');
const sums = ['libraries.js', 'uPlot.css'].map((name) => `${createHash('sha256').update(readFileSync(name)).digest('hex')}  ${name}\n`);
writeFileSync('SHA256SUMS', sums.join(''));
