// Drags a body of a page of `gjk-demo view --live`, and compares all answers with the demo's for the scene as it is
// then.
import assert from 'node:assert/strict';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { openPage, until } from './play-browser.mjs';
import { check } from './check.mjs';
import { readCsv } from './csv.mjs';
import { demo } from './play-demo.mjs';

const BOX = 0, OBJECT = 1;

export async function checkLive(context, folder) {
  const page = await openPage(context, join(folder, 'live.html'));
  await until(page, () => Boolean(window.__gjk.live));
  await check('live: a dragged body has the answers of the demo, and the others keep theirs', async () => {
    const before = await answers(page);
    const [from, to] = await page.evaluate((objects) => {
      window.__gjk.drawNow();
      return objects.map((object) => window.__gjk.positionOf(object));
    }, [OBJECT, BOX]);
    await page.mouse.move(from.x, from.y);
    await page.mouse.down();
    await page.mouse.move(to.x + 20, to.y + 10, { steps: 6 });
    await page.mouse.up();
    await until(page, () => Boolean(window.__gjk.live.hasMoved));
    const after = await answers(page);
    assert.notDeepEqual(after.position, before.position);
    assertSame(after, asked(folder, after.position));
    assert.equal(after.shown, after.rows.filter(({ overlaps }) => overlaps).length);
    assert.notEqual(after.shown, before.shown);
    await page.screenshot({ path: join(folder, 'live.png') });
    assert.match(await page.locator('.legend').innerText(), /drag a body/);
    assert.deepEqual(page.complaints, []);
  });
  await page.close();
}

function answers(page) {
  return page.evaluate((object) => {
    const { model } = window.__gjk;
    const rows = Array.from({ length: model.pairs }, (_, pair) => ({
      pair: [model.a[pair], model.b[pair]], distance: model.distance(pair), normal: model.normal(pair),
      pointA: Array.from(model.pointsA.subarray(3 * pair, 3 * pair + 3)), overlaps: model.overlaps(pair),
    }));
    const position = Array.from(model.poses.subarray(7 * object + 4, 7 * object + 7));
    return { rows, position, shown: Number(document.body.dataset.overlapping) };
  }, OBJECT);
}

/** What the demo answers when the body is where it was dragged to. */
function asked(folder, position) {
  const scene = JSON.parse(readFileSync(join(folder, 'moving.json')));
  scene.objects[OBJECT].position = position;
  const moved = join(folder, 'live-moved.json');
  writeFileSync(moved, JSON.stringify(scene));
  demo('query', moved, '--depth', '--out', join(folder, 'live.csv'));
  return readCsv(join(folder, 'live.csv'));
}

function assertSame({ rows }, expected) {
  assert.equal(rows.length, expected.length);
  rows.forEach(({ pair, distance, pointA, normal }, i) => {
    const row = expected[i], float = (x) => Math.fround(x) + 0;
    assert.deepEqual(pair, [row.a, row.b]);
    assert.deepEqual([distance, ...pointA, ...normal].map(float),
      [row.distance, row.ax, row.ay, row.az, row.nx, row.ny, row.nz].map(float), `pair ${pair}`);
  });
}
