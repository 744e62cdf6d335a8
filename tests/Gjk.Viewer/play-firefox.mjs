// Firefox is given the pairs of the scene, too, where it is installed. It is driven by its own remote protocol,
// Marionette: messages of JSON with their length before them.
import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { createConnection } from 'node:net';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { PATIENCE_MS } from './browser.mjs';
import { check } from './check.mjs';
import { readCsv } from './csv.mjs';
import { assertSame, distanceRow } from './play-answers.mjs';

const PORT = 2871;

const SCRIPT = `const [pairs, done] = arguments;
  const ask = () => {
    if (window.__gjk) done(JSON.stringify(window.__gjk.answers('distance', JSON.parse(pairs))));
    else setTimeout(ask, 50);
  };
  ask();`;

export async function checkFirefox(folder) {
  const program = process.env.FIREFOX ?? find('firefox-esr') ?? find('firefox');
  if (!program) return console.log('skipped: Firefox is not installed');
  const profile = mkdtempSync(join(tmpdir(), 'gjk-firefox-'));
  writeFileSync(join(profile, 'user.js'), `user_pref("marionette.port", ${PORT});\n`);
  const flags = ['--headless', '--marionette', '--no-remote', '--profile', profile];
  const browser = spawn(program, flags, { stdio: 'ignore' });
  try {
    await check('play: Firefox answers with the same bits', async () => {
      const rows = readCsv(join(folder, 'shapes.csv'));
      const remote = await connect(browser);
      await remote('WebDriver:NewSession', {});
      await remote('WebDriver:SetTimeouts', { script: PATIENCE_MS, pageLoad: PATIENCE_MS });
      await remote('WebDriver:Navigate', { url: pathToFileURL(resolve(folder, 'play-shapes.html')).href });
      const pairs = JSON.stringify(rows.map(({ a, b }) => [a, b]));
      const { value } = await remote('WebDriver:ExecuteAsyncScript', { script: SCRIPT, args: [pairs] });
      assertSame(rows, JSON.parse(value), distanceRow);
      const { value: picture } = await remote('WebDriver:TakeScreenshot', { full: false });
      writeFileSync(join(folder, 'play-firefox.png'), Buffer.from(picture, 'base64'));
    });
  } finally {
    browser.kill('SIGKILL');
    if (browser.exitCode === null) await new Promise((done) => { browser.once('exit', done); });
    rmSync(profile, { recursive: true, force: true, maxRetries: 10, retryDelay: 200 });
  }
}

function find(name) {
  try {
    return execFileSync('which', [name], { encoding: 'utf8' }).trim();
  } catch {
    return undefined;
  }
}

/** A function that sends a command and gives its result. */
async function connect(browser) {
  const end = Date.now() + PATIENCE_MS;
  let socket = null;
  while (!socket) {
    assert.ok(Date.now() < end && browser.exitCode === null, 'Firefox does not start');
    socket = await new Promise((done) => {
      const attempt = createConnection(PORT, '127.0.0.1', () => done(attempt));
      attempt.once('error', () => setTimeout(() => done(null), 200));
    });
  }
  let received = Buffer.alloc(0), next = 1;
  const waiting = new Map();
  socket.on('data', (data) => {
    received = Buffer.concat([received, data]);
    for (let colon = received.indexOf(':'); colon > 0; colon = received.indexOf(':')) {
      const from = colon + 1, to = from + Number(received.subarray(0, colon));
      if (received.length < to) return;
      const message = JSON.parse(received.subarray(from, to));
      received = received.subarray(to);
      const [, id, error, result] = Array.isArray(message) ? message : [1, 0];
      waiting.get(id)?.(error, result);
    }
  });
  return (command, parameters) => new Promise((done, fail) => {
    const id = next++, text = JSON.stringify([0, id, command, parameters]);
    waiting.set(id, (error, result) => (error ? fail(new Error(error.message)) : done(result)));
    socket.write(`${Buffer.byteLength(text)}:${text}`);
  });
}
