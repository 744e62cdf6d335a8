import { defineConfig } from 'vitepress'
import { sourceLinks } from './source-links.mjs'
import { labelledCells } from './labelled-cells.mjs'

const base = process.env.GJK_SITE_BASE ?? '/'

const book = [
  { text: 'Contents', link: '/book/' },
  { text: '1. The origin', link: '/book/01-the-origin' },
  { text: '2. The simplex', link: '/book/02-the-simplex' },
  { text: '3. The end', link: '/book/03-the-end' },
]

const questions = [
  { text: 'Is A - B ever built?', link: '/book/difference' },
  { text: 'Why one support per step?', link: '/book/support' },
  { text: 'Why are vertices dropped?', link: '/book/dropping' },
  { text: 'Why may regions be skipped?', link: '/book/regions' },
  { text: 'How far apart?', link: '/book/distance' },
  { text: 'When will they touch?', link: '/book/casting' },
  { text: 'Where are the closest points?', link: '/book/closest-points' },
  { text: 'Why does my GJK loop for ever?', link: '/book/looping' },
  { text: 'Is touching a hit?', link: '/book/touching' },
  { text: 'Which epsilon?', link: '/book/epsilon' },
  { text: 'How deep, and why EPA?', link: '/book/depth' },
  { text: 'Spheres and scaled shapes', link: '/book/round-and-scaled' },
  { text: 'Concave meshes, and speed', link: '/book/concave' },
  { text: 'Who sees that they touch?', link: '/book/nearly-touching' },
]

const tasks = [
  { text: 'All queries', link: '/queries' },
  { text: 'The nearest obstacle', link: '/tasks/nearest-obstacle' },
  { text: 'Clearance of parts', link: '/tasks/clearance' },
  { text: 'A character that sweeps', link: '/tasks/character-sweep' },
  { text: 'Real meshes', link: '/tasks/meshes' },
  { text: 'A scene of 100,000', link: '/tasks/large-scene' },
  { text: 'More than one machine', link: '/tasks/many-machines' },
  { text: 'CAD and robotics', link: '/tasks/cad-robotics' },
  { text: 'Coming from another engine', link: '/tasks/coming-from' },
  { text: 'A perceptual study', link: '/study' },
  { text: 'Unity', link: '/tasks/unity' },
]

const reference = [
  { text: 'API', link: '/api/' },
  { text: 'Scene files', link: '/scene-format' },
  { text: 'The command gjk-demo', link: '/command' },
  { text: 'How right', link: '/exactness' },
  { text: 'Judge any engine', link: '/cases' },
  { text: 'How fast', link: '/performance' },
  { text: 'The experiment', link: '/experiment' },
  { text: 'The playground as a file', link: '/playground' },
  { text: 'Questions and answers', link: '/faq' },
]

export default defineConfig({
  title: 'Gjk',
  description: 'Exact distances, depths, contacts and casts between convex shapes, for .NET and Unity.',
  outDir: 'site',
  base,
  srcExclude: ['node_modules/**', 'Gjk.Pages/**', 'site/**'],
  head: [['link', { rel: 'icon', type: 'image/svg+xml', href: `${base}icon.svg` }]],
  lastUpdated: false,
  markdown: {
    // Every colour of these is legible on the blocks' own background.
    theme: { light: 'github-light-high-contrast', dark: 'github-dark-high-contrast' },
    config(markdown) {
      sourceLinks(markdown)
      labelledCells(markdown)
    },
  },
  vue: { template: { compilerOptions: { whitespace: 'preserve' } } },
  themeConfig: {
    search: { provider: 'local' },
    outline: { level: [2, 3] },
    nav: [
      { text: 'Book', link: '/book/' },
      { text: 'Playground', link: '/play.html', target: '_self', rel: '' },
      { text: 'Tasks', link: '/queries' },
      { text: 'API', link: '/api/' },
    ],
    sidebar: [
      { text: 'The book', items: book },
      { text: 'Questions', items: questions },
      { text: 'Playground', link: '/play.html', target: '_self', rel: '' },
      { text: 'Tasks', items: tasks },
      { text: 'Look up', items: reference },
    ],
  },
})
