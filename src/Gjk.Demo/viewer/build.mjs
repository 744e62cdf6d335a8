// Bundles src/main.js and three.js into dist/viewer.js, one script without imports; the licence of what is in it goes beside it. Given a file, it writes only
// the script, and there.
import { build } from 'esbuild';
import { copyFileSync } from 'node:fs';

await build({
  entryPoints: ['src/main.js'],
  bundle: true,
  minify: true,
  format: 'iife',
  target: 'es2020',
  charset: 'utf8',
  legalComments: 'inline',
  outfile: process.argv[2] ?? 'dist/viewer.js',
});
if (!process.argv[2]) copyFileSync('node_modules/three/LICENSE', 'dist/three.LICENSE.txt');
