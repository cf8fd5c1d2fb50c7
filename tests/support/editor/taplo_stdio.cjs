// SPDX-License-Identifier: BSD-3-Clause
// The language server of the npm package @taplo/lsp over standard streams: node taplo_stdio.cjs FOLDER_OF_NODE_MODULES
const fs = require('fs');
const path = require('path');
const { TaploLsp } = require(path.join(process.argv[2], '@taplo/lsp'));

function send(message) {
  const body = Buffer.from(JSON.stringify(message));
  process.stdout.write(`Content-Length: ${body.length}\r\n\r\n`);
  process.stdout.write(body);
}

const environment = {
  now: () => new Date(),
  envVar: (name) => process.env[name],
  envVars: () => Object.entries(process.env),
  stdErrAtty: () => false,
  stdin: process.stdin,
  stdout: process.stderr,  // the protocol has standard output for itself
  stderr: process.stderr,
  glob: () => [],
  readFile: (file) => fs.promises.readFile(file),
  writeFile: (file, bytes) => fs.promises.writeFile(file, bytes),
  urlToFilePath: (url) => decodeURIComponent(new URL(url).pathname),
  isAbsolute: (file) => path.isAbsolute(file),
  cwd: () => process.cwd(),
  findConfigFile: (from) => ['.taplo.toml', 'taplo.toml'].map((f) => path.join(from, f)).find((f) => fs.existsSync(f)),
};

function serve(server) {
  let waiting = Buffer.alloc(0);
  process.stdin.on('data', (chunk) => {
    waiting = Buffer.concat([waiting, chunk]);
    for (;;) {
      const end = waiting.indexOf('\r\n\r\n');
      const length = end < 0 ? NaN : Number(/content-length: *(\d+)/i.exec(waiting.subarray(0, end))[1]);
      if (!(waiting.length >= end + 4 + length)) return;
      server.send(JSON.parse(waiting.subarray(end + 4, end + 4 + length)));
      waiting = waiting.subarray(end + 4 + length);
    }
  });
  process.stdin.on('end', () => process.exit(0));
}

TaploLsp.initialize(environment, { onMessage: send }).then(serve);
