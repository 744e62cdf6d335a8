// Bundles the scripts of the pages, each with three.js and without imports; the licence of what is in them goes beside
// them. Given a folder, it writes only the scripts, and there.
import { build } from 'esbuild';
import { copyFileSync } from 'node:fs';

const shared = { bundle: true, minify: true, charset: 'utf8', legalComments: 'inline' };
const folder = process.argv[2] ?? 'dist';
await build({
  ...shared, entryPoints: ['src/main.js'], format: 'iife', target: 'es2020', outfile: `${folder}/viewer.js`,
});
for (const [entry, name] of [['src/play/main.js', 'play.js'], ['src/live.js', 'live.js'],
  ['src/study/main.js', 'study.js']]) {
  await build({ ...shared, entryPoints: [entry], format: 'esm', target: 'es2022', outfile: `${folder}/${name}` });
}
if (!process.argv[2]) copyFileSync('node_modules/three/LICENSE', 'dist/three.LICENSE.txt');
