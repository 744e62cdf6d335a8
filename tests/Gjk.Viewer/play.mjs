// Uses the playground as a user does, and compares what the library answers inside the page with what the demo wrote
// as CSV, bit for bit.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { openPage, startBrowser, until } from './play-browser.mjs';
import { check, finish } from './check.mjs';
import { readCsv } from './csv.mjs';
import { answersOf, assertSame, distanceRow, impactRow } from './play-answers.mjs';
import { answersOfCode } from './play-code.mjs';
import { demo } from './play-demo.mjs';
import { checkFirefox } from './play-firefox.mjs';
import { checkLive } from './play-live.mjs';
import { checkPlane } from './play-plane.mjs';

const folder = process.argv[2];
for (const name of ['play.js', 'live.js'].filter((script) => existsSync(join(folder, script)))) {
  await check(`play: the bundle ${name} is what its sources make`, () => {
    assert.ok(readFileSync(join(folder, name)).equals(readFileSync(`../../src/Gjk.Demo/viewer/dist/${name}`)));
  });
}

const { browser, context } = await startBrowser();
const open = (name) => openPage(context, join(folder, `${name}.html`));
const keep = (page, name) => page.screenshot({ path: join(folder, `${name}.png`) });
const press = (page, text) => page.locator('button', { hasText: new RegExp(`^${text}$`) }).click();

const shapes = await open('play-shapes');
for (const [question, file, row] of [
  ['distance', 'shapes.csv', distanceRow], ['signed', 'shapes-depth.csv', distanceRow],
  ['impact', 'shapes-cast.csv', impactRow],
]) {
  await check(`play: the page's answers to ${question} are the bits of ${file}`, async () => {
    const rows = readCsv(join(folder, file));
    assert.ok(rows.length > 1000, `only ${rows.length} pairs`);
    assertSame(rows, await answersOf(shapes, question, rows), row);
    for (const status of question === 'impact' ? ['Hit', 'Miss', 'OverlappingAtStart'] : ['Separated', 'Overlapping']) {
      const share = rows.filter((r) => r.status === status).length / rows.length;
      assert.ok(share > 0.01, `only ${share} of the pairs are ${status}`);
    }
  });
}
await check('play: the bits stay the same when the code is hot', async () => {
  const rows = readCsv(join(folder, 'shapes.csv'));
  for (let round = 0; round < 4; round++) assertSame(rows, await answersOf(shapes, 'distance', rows), distanceRow);
});
await check('play: the C# of every kind of shape compiles and gives the same bits', async () => {
  const tables = [['signed', 'shapes-depth.csv', distanceRow], ['impact', 'shapes-cast.csv', impactRow]];
  const rowsOf = (file) => readCsv(join(folder, file)).filter(({ a, b }) => b === a + 1 && a < 39);
  const questions = tables.map(([question, file]) => [question, rowsOf(file)]);
  const answers = await answersOfCode(shapes, join(folder, 'code'), questions);
  tables.forEach(([, , row], i) => assertSame(questions[i][1], answers[i], row));
});
await check('play: a body of the scene can be chosen', async () => {
  await shapes.locator('select').first().selectOption({ label: 'mesh 9.3' });
  await shapes.locator('select').nth(1).selectOption({ label: 'capsule 4.1' });
  const expected = readCsv(join(folder, 'shapes-depth.csv')).find(({ a, b }) => a === 17 && b === 39);
  await until(shapes, () => window.__gjk.model.bodies[1].name === 'capsule 4.1');
  const answer = await shapes.evaluate(() => { window.__gjk.show(); return window.__gjk.model.answer; });
  assert.equal(Math.fround(expected.distance), answer.distance);
  assert.deepEqual(shapes.complaints, []);
});
await check('play: what is drawn late is of the bodies that the page shows', async () => {
  const [early, late] = await shapes.evaluate(() => {
    const { model, answers } = window.__gjk, corners = () => [...model.difference(false).vertices];
    const before = corners();
    answers('distance', [[0, 1]]);
    return [before, corners()];
  });
  assert.ok(early.length > 0);
  assert.deepEqual(late, early);
});
await shapes.close();

const page = await open('play');
const state = () => page.evaluate(() => {
  const { model, show } = window.__gjk;
  show();
  const motions = model.bodies.map((body) => [...body.motion]);
  return { answer: model.answer, impact: model.impact, record: model.record(), motions };
});

/** The page's answer is that of the demo to the record that the page shows. */
async function assertDemoAgrees(question) {
  const { answer, impact, record } = await state();
  const isImpact = question === 'impact';
  const file = join(folder, 'record.csv');
  demo(isImpact ? 'cast' : 'query', '--record', record, ...(question === 'signed' ? ['--depth'] : []), '--out', file);
  assertSame(readCsv(file), [isImpact ? impact : answer], isImpact ? impactRow : distanceRow);
}

async function drag(from, by, target = page) {
  await target.mouse.move(from.x, from.y);
  await target.mouse.down();
  await target.mouse.move(from.x + by[0], from.y + by[1], { steps: 5 });
  await target.mouse.up();
}

const at = (body) => page.evaluate((i) => { window.__gjk.drawNow(); return window.__gjk.positionOf(i); }, body);

await check('play: a drag moves a body, and the answer follows with the bits of the demo', async () => {
  const before = await state();
  await drag(await at(1), [-60, 10]);
  const after = await state();
  assert.deepEqual(after.motions[0], before.motions[0]);
  assert.deepEqual(after.motions[1].slice(0, 4), before.motions[1].slice(0, 4));
  const [from, to] = [before, after].map(({ answer }) => answer.distance);
  assert.ok(to < from - 0.1, `${from} to ${to}`);
  await assertDemoAgrees('signed');
  assert.equal(await page.locator('.segmented [aria-pressed=true]').first().innerText(), 'B');
  await keep(page, 'play-dragged');
});
await check('play: a drag turns a body', async () => {
  const before = await state();
  await press(page, 'turn');
  await drag(await at(0), [40, 25]);
  const after = await state();
  assert.notDeepEqual(after.motions[0].slice(0, 4), before.motions[0].slice(0, 4));
  assert.deepEqual(after.motions[0].slice(4), before.motions[0].slice(4));
  await assertDemoAgrees('signed');
  await press(page, 'move');
});
await check('play: keys choose, move and turn', async () => {
  const before = await state();
  await page.keyboard.press('a');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('b');
  await page.keyboard.press('Shift+PageUp');
  const { motions: [a, b] } = await state();
  const [oldA, oldB] = before.motions;
  assert.deepEqual(a.slice(0, 4), oldA.slice(0, 4));
  assert.notDeepEqual(a.slice(4, 7), oldA.slice(4, 7));
  assert.notDeepEqual(b.slice(0, 4), oldB.slice(0, 4));
  assert.deepEqual(b.slice(4, 7), oldB.slice(4, 7));
});
await check('play: overlapping bodies show the depth and contact points', async () => {
  const [a, b] = [await at(0), await at(1)];
  await drag(b, [a.x - b.x, a.y - b.y]);
  await page.locator('label', { hasText: 'contact points' }).click();
  const { answer } = await state();
  assert.equal(answer.status, 'Overlapping');
  assert.ok(answer.distance < 0);
  await assertDemoAgrees('signed');
  assert.match(await page.locator('.headline').innerText(), /^overlapping, depth \d/);
  assert.match(await page.locator('.facts').innerText(), /way out for B[\s\S]*contact points\s+[1-4]/);
  await keep(page, 'play-overlap');
  await drag(await at(1), [b.x - a.x, b.y - a.y]);
});
await check('play: the end of a velocity can be dragged, and the impact follows', async () => {
  await press(page, 'impact');
  await page.keyboard.press('a');
  const before = await state();
  assert.equal(before.impact.status, 'Hit');
  await assertDemoAgrees('impact');
  await drag(await page.evaluate(() => window.__gjk.tipOf(0)), [0, -170]);
  const after = await state();
  assert.notDeepEqual(after.motions[0].slice(7, 10), before.motions[0].slice(7, 10));
  assert.deepEqual(after.motions[0].slice(0, 7), before.motions[0].slice(0, 7));
  await assertDemoAgrees('impact');
  await page.locator('[aria-label="turn z of B"]').fill('1.5');
  await assertDemoAgrees('impact');
  await keep(page, 'play-impact');
  await press(page, 'depth');
});
await check('play: the edges of a body have its own colour, also when keys move it', async () => {
  for (const theme of ['dark', 'light']) {
    const [edge, a, b] = await page.evaluate((name) => {
      document.documentElement.dataset.theme = name;
      const style = getComputedStyle(document.documentElement);
      const rgb = (hex) => [1, 3, 5].map((i) => parseInt(hex.trim().slice(i, i + 2), 16));
      return [`#${window.__gjk.view.edge('a', true).getHexString()}`, ...['--a', '--b'].map((c) => style.getPropertyValue(c))]
        .map(rgb);
    }, theme);
    const hue = (p, q) => p.reduce((sum, x, i) => sum + (x - p[2] - q[i] + q[2]) ** 2, 0);
    assert.ok(hue(edge, a) < hue(edge, b), `${theme}: ${edge} is like ${b}`);
  }
});
await check('play: sizes change the shape, and what is no size is refused', async () => {
  const field = page.locator('.body.a input').first();
  await field.fill('0.25');
  assert.match((await state()).record, /^gjk1 box 0\.25 /);
  await field.fill('-1');
  assert.match(await page.locator('.body.a .quiet').innerText(), /x: must be a number, at least 0/);
  assert.match((await state()).record, /^gjk1 box 0\.25 /);
});
await check('play: a record is opened, and one that is none is refused', async () => {
  const record = 'gjk1 segment 0 0.5 0 0 -0.5 0 0.25 @ 0 0 0 1 10000 0 0 ~ 1 0 0 0 0 0 box 1 1 1 @ 0 0 0 1 10003 0 0';
  await page.locator('summary', { hasText: 'record' }).click();
  await page.locator('textarea').fill(record);
  await press(page, 'open');
  assert.equal((await state()).record, record);
  assert.equal((await state()).answer.distance, 1.75);
  await page.locator('textarea').fill('gjk1 bax');
  await press(page, 'open');
  assert.match(await page.locator('details .quiet').innerText(), /bax/);
  assert.equal((await state()).record, record);
  await press(page, 'record');
  assert.equal(await page.locator('.code').innerText(), record);
});
await check('play: the parts of an OBJ file are offered', async () => {
  await page.locator('input[type=file]').setInputFiles(join(folder, 'parts.obj'));
  await page.locator('select').first().selectOption({ label: 'left part' });
  await page.locator('select').nth(1).selectOption({ label: 'right part' });
  assert.match((await state()).record, /^gjk1 mesh 8 /);
  await page.locator('input[type=file]').setInputFiles({ name: 'bad.obj', mimeType: '', buffer: Buffer.from('v 1 2') });
  await until(page, () => /bad\.obj: line 1: a vertex needs/.test(document.body.innerText));
});
await check('play: the parts of a GLB are offered, in their places', async () => {
  const points = new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
  const json = JSON.stringify({
    scenes: [{ nodes: [0] }], nodes: [{ name: 'frame', translation: [5, 0, 0], children: [1] }, { name: 'wedge', mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] }], buffers: [{ byteLength: 48 }],
    accessors: [{ bufferView: 0, componentType: 5126, count: 4, type: 'VEC3' }], bufferViews: [{ buffer: 0, byteLength: 48 }],
  });
  const text = Buffer.from(json.padEnd(Math.ceil(json.length / 4) * 4));
  const words = (...numbers) => Buffer.from(Uint32Array.from(numbers).buffer);
  const buffer = Buffer.concat([words(0x46546c67, 2, 28 + text.length + 48, text.length, 0x4e4f534a), text,
    words(48, 0x004e4942), Buffer.from(points.buffer)]);
  await page.locator('input[type=file]').setInputFiles({ name: 'part.glb', mimeType: '', buffer });
  await page.locator('select').first().selectOption({ label: 'wedge' });
  assert.match((await state()).record, /^gjk1 mesh 4 5 0 0 6 0 0 5 1 0 5 0 1 @/);
  await page.locator('input[type=file]').setInputFiles({ name: 'bad.glb', mimeType: '', buffer: Buffer.from('glTF') });
  await until(page, () => /bad\.glb: it is no binary glTF/.test(document.body.innerText));
});
await check('play: a small part comes near the other body, and is not a dot', async () => {
  const small = [0, 1, 2, 3].map((i) => `v ${i & 1 ? 0.004 : 0} ${i & 2 ? 0.004 : 0} ${i === 3 ? 0.004 : 0}`);
  const buffer = Buffer.from([...small, 'f 1 2 3 4'].join('\n'));
  await page.locator('input[type=file]').setInputFiles({ name: 'small.obj', mimeType: '', buffer });
  for (const select of [0, 1]) await page.locator('select').nth(select).selectOption({ label: 'default' });
  const { apart, radius } = await page.evaluate(() => {
    const [a, b] = window.__gjk.model.bodies;
    return { apart: Math.hypot(...[4, 5, 6].map((i) => a.motion[i] - b.motion[i])), radius: a.radius };
  });
  assert.ok(apart > 0 && apart < 10 * radius, `${apart} apart, ${radius} in radius`);
  assert.match(await page.locator('.legend').innerText(), /way out[\s\S]*zoom/);
});
await check('play: no error, nothing fetched', () => assert.deepEqual(page.complaints, []));
await page.close();

const parts = await open('play-parts');
await check('play: --obj offers the parts of a file', async () => {
  const labels = await parts.locator('select').first().locator('optgroup').last().locator('option').allInnerTexts();
  assert.deepEqual(labels, ['left part', 'right part']);
});
await check('play: on a phone nothing is cut off, and every control is large enough', async () => {
  await parts.setViewportSize({ width: 390, height: 844 });
  await parts.emulateMedia({ colorScheme: 'light' });
  const faults = await parts.evaluate(() => {
    const found = document.documentElement.scrollWidth > 390 ? ['the page scrolls sideways'] : [];
    for (const each of document.querySelectorAll('button, select, input, summary, a, textarea')) {
      const box = (each.closest('label.check') ?? each.closest('label.file') ?? each).getBoundingClientRect();
      if (box.width === 0) continue;
      const name = each.outerHTML.slice(0, 80);
      if (box.height < 44 || box.width < 44) found.push(`${name} is ${box.width} x ${box.height}`);
      if (box.left < 0 || box.right > 390) found.push(`${name} is cut off`);
    }
    return found;
  });
  assert.deepEqual(faults, []);
  await keep(parts, 'play-phone');
  assert.deepEqual(parts.complaints, []);
});
await parts.close();

await checkPlane(context, folder);
await checkLive(context, folder);

await browser.close();
if (process.env.GJK_LONG === '1') await checkFirefox(folder);
finish();
