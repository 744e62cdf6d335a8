// Does with the pages what a user does: reads the counts, looks at colours, hovers, clicks, sorts, drags, zooms, and
// plays the frames.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { colorsAt, isGreen, isRed, openPage, startBrowser, until } from './browser.mjs';
import { check, finish } from './check.mjs';
import { readCsv } from './csv.mjs';

const folder = process.argv[2];
const bundle = join(folder, 'viewer.js');
if (existsSync(bundle)) {
  const checkedIn = readFileSync('../../src/Gjk.Demo/viewer/dist/viewer.js');
  await check('the bundle is what its sources make', async () => assert.ok(readFileSync(bundle).equals(checkedIn)));
}

const { browser, context } = await startBrowser();
const open = (name) => openPage(context, join(folder, `${name}.html`));
const keep = (page, name) => page.screenshot({ path: join(folder, `${name}.png`) });
const counts = (page) => page.evaluate(() => window.__gjk.counts());
const text = (page, selector) => page.locator(selector).innerText();
const rows = (page) => page.locator('.rows .row')
  .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));

async function builtIn(name, intersecting, free, contacts) {
  const page = await open(name);
  await check(`${name}: the counts are the report's`, async () => {
    const expected = { objects: 20, pairs: 190, frames: 1, frame: 0, overlapping: 5, lines: 185, arrows: 5, contacts, paths: 0, impacts: 0 };
    assert.deepEqual(await counts(page), expected);
    assert.match(await text(page, '.summary'), /^20 objects, 190 pairs, 5 intersecting$/);
    const { objects, pairs, overlapping } = await page.evaluate(() => ({ ...document.body.dataset }));
    assert.deepEqual([objects, pairs, overlapping], ['20', '190', '5']);
  });
  await check(`${name}: what intersects is red on the screen, and the rest green`, async () => {
    await page.locator('button', { hasText: 'none' }).click();
    const asked = [...intersecting, ...free];
    const places = await page.evaluate((objects) => objects.map((o) => window.__gjk.positionOf(o)), asked);
    const colors = await colorsAt(context, page, places);
    intersecting.forEach((object, i) => assert.ok(isRed(colors[i]), `object ${object} is ${colors[i]}`));
    free.forEach((object, i) => {
      const color = colors[intersecting.length + i];
      assert.ok(isGreen(color), `object ${object} is ${color}`);
    });
    const shown = await counts(page);
    assert.deepEqual([shown.lines, shown.arrows, shown.contacts], [0, 0, 0]);
    await page.locator('button', { hasText: 'all' }).first().click();
  });
  await keep(page, name);
  await check(`${name}: no error, nothing fetched`, async () => assert.deepEqual(page.complaints, []));
  return page;
}

const cubes = await builtIn('cubes', [11, 19], [1, 9], 19);
await (await builtIn('spheres', [11, 19], [1, 9], 18)).close();

await check('the list is sorted by distance, and turns round', async () => {
  const distances = async () => (await rows(cubes)).map((cells) => Number(cells[2].replace('depth ', '-')));
  const rising = await distances();
  assert.ok(rising.length > 10);
  assert.deepEqual(rising, [...rising].sort((x, y) => x - y));
  assert.equal(rising.filter((d) => d < 0).length, 5);
  await cubes.locator('.head button', { hasText: 'distance' }).click();
  const falling = await distances();
  assert.deepEqual(falling, [...falling].sort((x, y) => y - x));
  assert.ok(falling[0] > rising.at(-1));
  await cubes.locator('.head button', { hasText: 'distance' }).click();
});

await check('a row selects its pair in the view', async () => {
  const row = cubes.locator('.rows .row').nth(6);
  const pair = Number(await row.getAttribute('data-pair'));
  await row.click();
  assert.equal(await cubes.evaluate(() => window.__gjk.selected()), pair);
  assert.match(await text(cubes, '.detail'), /distance\s+0\.\d+\s+normal\s+\(.*\)\s+iterations\s+\d+/);
  await keep(cubes, 'cubes-selected');
  await cubes.locator('.rows').press('Escape');
  assert.equal(await cubes.evaluate(() => window.__gjk.selected()), -1);
});

await check('hovering over a way out shows the depth, and the arrow is on the screen', async () => {
  const row = cubes.locator('.rows .row').first();
  const pair = Number(await row.getAttribute('data-pair'));
  const shown = await row.locator('span').nth(2).innerText();
  assert.match(shown, /^depth 0\.\d{3,6}$/);
  const along = (share) => cubes.evaluate(([p, s]) => {
    window.__gjk.drawNow();
    return window.__gjk.lineAt(p, s);
  }, [pair, share]);
  const [from, to, head] = [await along(0), await along(1), await along(0.75)];
  assert.ok(Math.hypot(to.x - from.x, to.y - from.y) > 15, JSON.stringify([from, to]));
  const [[r, g, b]] = await colorsAt(context, cubes, [head]);
  assert.ok(b > 1.2 * r && b > g, `the arrow is ${[r, g, b]}`);
  const middle = await along(0.5);
  await cubes.mouse.move(middle.x, middle.y);
  const tip = await text(cubes, '.tip');
  assert.match(tip, /^Cube \(\d+\) – Cube \(\d+\)\s+depth\s+0\.\d+\s+way out\s+\(.*\)\s+contact points\s+4\s+gaps\s+.*\s+iterations\s+\d+/);
  assert.ok(tip.replace(/\s+/g, ' ').includes(shown), tip);
  await keep(cubes, 'cubes-hover');
  const body = await cubes.evaluate((p) => window.__gjk.positionOf(window.__gjk.model.a[p]), pair);
  await cubes.mouse.move(body.x, body.y);
  assert.match(await text(cubes, '.tip'), /intersects Cube \(\d+\) \(depth 0\.\d+\)/);
});

await check('the contact points are on the screen, and hovering over one shows its pair', async () => {
  const row = cubes.locator('.rows .row').first();
  const pair = Number(await row.getAttribute('data-pair'));
  const places = await cubes.evaluate((p) => {
    window.__gjk.drawNow();
    return window.__gjk.model.contacts(p).map((_, i) => window.__gjk.contactAt(p, i));
  }, pair);
  assert.equal(places.length, 4);
  const colors = await colorsAt(context, cubes, places);
  const seen = colors.findIndex(([r, g, b]) => b > 1.2 * g && r > 1.2 * g && b > 0.9 * r);
  assert.ok(seen >= 0, `the points are ${JSON.stringify(colors)}`);
  await cubes.mouse.move(places[seen].x, places[seen].y);
  const names = await row.locator('span').allInnerTexts();
  assert.ok((await text(cubes, '.tip')).startsWith(`${names[0]} – ${names[1]}`));
});

await check('a click on a body lists its pairs', async () => {
  const at = await cubes.evaluate(() => window.__gjk.positionOf(9));
  await cubes.locator('button', { hasText: 'none' }).click();
  await cubes.mouse.click(at.x, at.y);
  const names = await rows(cubes);
  const name = await text(cubes, '.chip strong');
  assert.equal(names.length, 19);
  assert.ok(names.every(([a, b]) => a === name || b === name), name);
  await cubes.locator('button', { hasText: 'show all' }).click();
});

await check('dragging turns the view, the wheel zooms, reset brings it back', async () => {
  const where = () => cubes.evaluate(() => {
    window.__gjk.drawNow();
    return [0, 19].map((o) => window.__gjk.positionOf(o));
  });
  const span = ([a, b]) => Math.hypot(a.x - b.x, a.y - b.y);
  const first = await where();
  await cubes.mouse.move(450, 60);
  await cubes.mouse.down();
  await cubes.mouse.move(610, 110, { steps: 6 });
  await cubes.mouse.up();
  const turned = await where();
  assert.ok(Math.hypot(turned[0].x - first[0].x, turned[0].y - first[0].y) > 30);
  await cubes.mouse.wheel(0, -600);
  await cubes.waitForTimeout(300);
  assert.ok(span(await where()) > 1.1 * span(turned));
  await cubes.locator('button', { hasText: 'reset view' }).click();
  const last = await where();
  assert.ok(Math.hypot(last[0].x - first[0].x, last[0].y - first[0].y) < 2, JSON.stringify([first[0], last[0]]));
});
await cubes.close();

const moving = await open('moving');
const answers = readCsv(join(folder, 'moving.csv'));
await check('moving: hovering over a line shows distance, normal and iterations as query has them', async () => {
  const pair = answers.findIndex((row) => row.a === 3 && row.b === 4);
  const { distance, nx, ny, nz, iterations } = answers[pair];
  const at = await moving.evaluate((p) => { window.__gjk.drawNow(); return window.__gjk.lineAt(p, 0.5); }, pair);
  await moving.mouse.move(at.x, at.y);
  const tip = await text(moving, '.tip');
  const entries = [...tip.matchAll(/(distance|normal|iterations)\s+(.*)/g)];
  const shown = Object.fromEntries(entries.map((m) => [m[1], m[2].replaceAll('−', '-')]));
  assert.match(tip, /^cylinder – cone/);
  assert.ok(Math.abs(Number(shown.distance) - distance) <= 1e-5 * distance, `${shown.distance} for ${distance}`);
  const rounded = [nx, ny, nz].map((n) => Number((Math.abs(n) < 5e-5 ? 0 : n).toFixed(4)));
  assert.deepEqual(shown.normal.match(/-?[\d.]+/g).map(Number), rounded);
  assert.equal(Number(shown.iterations), iterations);
  await keep(moving, 'moving-hover');
});

await check('moving: the slider replays the frames, and what meets turns red', async () => {
  const show = async (frame) => {
    await moving.locator('input[type=range]').fill(String(frame));
    return {
      ...(await counts(moving)),
      colors: await moving.evaluate(() => [0, 1].map((o) => window.__gjk.colorOf(o))),
      at: await moving.evaluate(() => window.__gjk.positionOf(1)),
    };
  };
  const first = await show(0), before = await show(7), met = await show(8);
  assert.deepEqual([first.frame, before.frame, met.frame], [0, 7, 8]);
  assert.deepEqual([first.overlapping, before.overlapping, met.overlapping], [0, 0, 1]);
  assert.deepEqual([first.contacts, before.contacts, met.contacts], [0, 0, 1]);
  assert.ok(met.at.x < first.at.x - 50);
  assert.deepEqual(first.colors, ['#38a873', '#38a873']);
  assert.deepEqual(met.colors, ['#e5484d', '#e5484d']);
  assert.match(await text(moving, '.summary'), /1 intersecting/);
  assert.match((await rows(moving))[0][2], /^depth /);
  await keep(moving, 'moving-met');
  await moving.locator('button[aria-label=play]').click();
  await until(moving, () => window.__gjk.counts().frame !== 8);
  await moving.locator('button[aria-label=pause]').click();
});
await check('moving: no error, nothing fetched', async () => assert.deepEqual(moving.complaints, []));
await moving.close();

const sweep = await open('sweep');
await check('sweep: the list says when the pairs meet, and what turns is not cast', async () => {
  const found = Object.fromEntries((await rows(sweep)).map(([a, b, , impact]) => [`${a} ${b}`, impact]));
  assert.equal(found['crate ball'], '0.5');
  assert.equal(found['crate passer'], 'miss');
  assert.equal(found['crate inside'], 'at start');
  assert.equal(found['crate turner'], '');
  const { paths, impacts } = await counts(sweep);
  assert.deepEqual([paths, impacts], [4, 1]);
});
await check('sweep: the impact is on the screen, with its facts, and a button hides it', async () => {
  const pair = await sweep.evaluate(() => {
    window.__gjk.drawNow();
    const { a, b } = window.__gjk.model;
    return a.findIndex((first, i) => first === 0 && b[i] === 1);
  });
  const at = await sweep.evaluate((p) => window.__gjk.impactAt(p), pair);
  const [[r, g, b]] = await colorsAt(context, sweep, [at]);
  assert.ok(r > 1.2 * g && g > 1.2 * b, `the impact is ${[r, g, b]}`);
  await sweep.mouse.move(at.x, at.y);
  assert.match(await text(sweep, '.tip'), /impact after\s+0\.5 of a frame\s+impact at\s+\(−1, 0, 0\)\s+impact normal\s+\(−1\.0000, 0\.0000, 0\.0000\)/);
  await keep(sweep, 'sweep');
  await sweep.locator('button', { hasText: 'hidden' }).click();
  const { paths, impacts } = await counts(sweep);
  assert.deepEqual([paths, impacts], [0, 0]);
  await sweep.locator('button', { hasText: 'shown' }).click();
});
await check('sweep: sorted by impact; a selected pair shows only its own', async () => {
  await sweep.locator('.head button', { hasText: 'impact' }).click();
  const impacts = (await rows(sweep)).map((cells) => cells[3]);
  assert.deepEqual(impacts.slice(0, 2), ['at start', '0.5']);
  await sweep.locator('.rows .row').nth(1).click();
  const shown = await counts(sweep);
  assert.deepEqual([shown.paths, shown.impacts], [1, 1]);
  await sweep.setViewportSize({ width: 390, height: 844 });
  const list = await sweep.locator('.rows').boundingBox(), row = await sweep.locator('.rows .row').first().boundingBox();
  assert.ok(list.height > 27 && row.x + row.width <= 390, JSON.stringify([list, row]));
  await keep(sweep, 'sweep-small');
  assert.deepEqual(sweep.complaints, []);
});
await sweep.close();

await check('many: two thousand objects open, select and sort in seconds', async () => {
  const start = Date.now();
  const many = await open('many');
  const expected = readCsv(join(folder, 'many.csv')).filter((row) => row.overlap === 'true').length;
  const { objects, overlapping } = await counts(many);
  assert.deepEqual([objects, overlapping], [2000, expected]);
  assert.match(await text(many, '.summary'), /^2000 objects, 1999000 pairs/);
  const row = many.locator('.rows .row').nth(3);
  const pair = Number(await row.getAttribute('data-pair'));
  await row.click();
  assert.equal(await many.evaluate(() => window.__gjk.selected()), pair);
  await many.locator('.head button', { hasText: 'iter.' }).click();
  await keep(many, 'many');
  assert.deepEqual(many.complaints, []);
  const seconds = (Date.now() - start) / 1000;
  console.log(`many: ${seconds.toFixed(1)} s`);
  assert.ok(seconds < 150, `${seconds} s`);
  await many.close();
});

async function traced(name, status) {
  const page = await open(name);
  await check(`${name}: every step is told and drawn`, async () => {
    const { steps, depthSteps, iterations, status: found } = await counts(page);
    assert.equal(found, status);
    assert.equal(steps, iterations + depthSteps);
    assert.equal(await page.locator('tbody tr').count(), steps);
    for (let step = 0; step < steps; step++) {
      await page.locator('input[type=range]').fill(String(step));
      assert.equal((await counts(page)).step, step);
      const story = await text(page, '.story');
      const isDepth = step >= iterations;
      assert.match(story, isDepth ? /^Surface: [\s\S]*Search: [\s\S]*(Growth|End): / : /^Search: [\s\S]*Bound: [\s\S]*Region: /);
      assert.doesNotMatch(story, /NaN|undefined|null/);
      assert.equal(story.includes('Answer:'), step === iterations - 1 || step === steps - 1);
      const label = isDepth ? /^p\d+$/ : new RegExp(`^w${step + 1}$`);
      const labels = await page.locator('.label').allInnerTexts();
      assert.ok(labels.some((each) => label.test(each)), labels.join());
      assert.equal(labels.includes('way out'), found === 'Overlapping' && step === steps - 1);
      assert.equal(await page.locator('tr.current td').first().innerText(), String(step + 1));
    }
    assert.deepEqual(page.complaints, []);
  });
  await keep(page, name);
  return page;
}

const apart = await traced('trace-apart', 'Separated');
await check('trace: the bounds close in from both sides, and meet at the distance', async () => {
  const table = await apart.locator('tbody tr')
    .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => Number(cell.textContent))));
  for (let i = 1; i < table.length; i++) {
    assert.ok(table[i][1] >= table[i - 1][1] && table[i][2] <= table[i - 1][2], JSON.stringify(table));
  }
  assert.equal(table.at(-1)[1], table.at(-1)[2]);
  assert.ok((await text(apart, '.story')).includes(`distance ${table.at(-1)[1]}`));
});
await check('trace: the origin is a white ball on the screen', async () => {
  await apart.locator('tbody tr').first().click();
  const [color] = await colorsAt(context, apart, [await apart.evaluate(() => window.__gjk.originAt())]);
  assert.ok(color.every((channel) => channel > 230), String(color));
});
await apart.close();
const hit = await traced('trace-hit', 'Overlapping');
await check('trace: the last simplex holds the origin', async () => {
  const { iterations } = await counts(hit);
  await hit.locator('input[type=range]').fill(String(iterations - 1));
  assert.match(await text(hit, '.story'), /the origin is inside the tetrahedron/);
});
await hit.close();
await (await traced('trace-round', 'Separated')).close();

const depths = readCsv(join(folder, 'deep.csv'));
for (const [name, b] of [['trace-deep', 1], ['trace-margin', 2]]) {
  const deep = await traced(name, 'Overlapping');
  const depth = -depths.find((row) => row.a === 0 && row.b === b).distance;
  await check(`${name}: the depth is that of query`, async () => {
    const shown = Number(/Answer: depth ([\d.]+)/.exec(await text(deep, '.story'))[1]);
    assert.ok(Math.abs(shown - depth) <= 1e-5 * depth, `${shown} for ${depth}`);
  });
  if (b === 1) await check(`${name}: the bounds of the depth close in and meet, on a small screen too`, async () => {
    await deep.setViewportSize({ width: 390, height: 780 });
    const { steps, depthSteps } = await counts(deep);
    assert.ok(depthSteps > 2);
    const bounds = await deep.locator('table').nth(1).locator('tbody tr')
      .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => Number(cell.textContent))));
    for (let i = 1; i < bounds.length; i++) assert.ok(bounds[i][1] >= bounds[i - 1][1] && bounds[i][2] <= bounds[i - 1][2], JSON.stringify(bounds));
    assert.equal(bounds.at(-1)[1], bounds.at(-1)[2]);
    const place = await deep.locator('.story').boundingBox(), player = await deep.locator('.player').boundingBox();
    assert.ok(place.y > player.y && place.y < 500 && player.x + player.width <= 390, JSON.stringify([place, player]));
    await keep(deep, `${name}-small`);
    assert.equal((await counts(deep)).step, steps - 1);
  });
  await deep.close();
}

await browser.close();
finish();
