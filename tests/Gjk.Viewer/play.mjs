// Uses the playground as a user does, and compares what the library answers inside the page with what the demo wrote
// as CSV, bit for bit.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { openPage, startBrowser } from './browser.mjs';
import { check, finish } from './check.mjs';
import { readCsv } from './csv.mjs';
import { answersOf, assertSame, distanceRow, impactRow } from './play-answers.mjs';

const folder = process.argv[2];
const bundle = join(folder, 'play.js');
if (existsSync(bundle)) {
  const checkedIn = readFileSync('../../src/Gjk.Demo/viewer/dist/play.js');
  await check('play: the bundle is what its sources make', () => assert.ok(readFileSync(bundle).equals(checkedIn)));
}

const { browser, context } = await startBrowser();
const open = (name) => openPage(context, join(folder, `${name}.html`));

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
await check('play: no error, nothing fetched', () => assert.deepEqual(shapes.complaints, []));
await shapes.close();

await browser.close();
finish();
