// Bundles the scripts of the pages, without imports. What they take of three.js is one script, which stands before
// theirs in each page; its licence goes beside it. Given a folder, it writes only the scripts, and there.
import { build } from 'esbuild';
import { copyFileSync, readFileSync } from 'node:fs';

const folder = process.argv[2] ?? 'dist';
const script = {
  bundle: true, minify: true, charset: 'utf8', legalComments: 'inline', format: 'iife', target: 'es2020',
};
const module = { ...script, format: 'esm', target: 'es2022' };

/** Takes from the script before a page's own what the page imports from three.js: a missing name stops the build. */
const shared = {
  name: 'shared',
  setup({ onResolve, onLoad }) {
    const lists = [...readFileSync('src/three.js', 'utf8').matchAll(/\{([^}]*)\}/g)].map(([, list]) => list);
    onResolve({ filter: /^three(\/|$)/ }, () => ({ path: 'three', namespace: 'shared' }));
    onLoad({ filter: /^/, namespace: 'shared' }, () => ({ contents: `export const {${lists}} = gjkThree;` }));
  },
};

await build({ ...script, entryPoints: ['src/three.js'], outfile: `${folder}/three.js`, globalName: 'gjkThree' });
for (const [entry, name, form] of [['src/main.js', 'viewer.js', script], ['src/play/main.js', 'play.js', module],
  ['src/live.js', 'live.js', module], ['src/study/main.js', 'study.js', module]]) {
  await build({ ...form, entryPoints: [entry], outfile: `${folder}/${name}`, plugins: [shared] });
}
if (!process.argv[2]) copyFileSync('node_modules/three/LICENSE', 'dist/three.LICENSE.txt');
