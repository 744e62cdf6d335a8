import { number } from './data.js';
import { element, player, swatch } from './dom.js';
import { Stage } from './stage.js';
import { TraceModel } from './trace-model.js';
import { COLORS, DifferenceView, ShapesView } from './trace-view.js';

const STEP_MS = 1400;

const COLUMNS = ['step', 'lower bound', '|v|', 'gap', 'simplex'];

export function tracePage(json) {
  const model = new TraceModel(json);
  const main = new Stage(), small = new Stage();
  document.body.classList.add('trace');
  small.root.classList.add('small');
  const story = element('section', { className: 'story', 'aria-live': 'polite' });
  const rows = model.steps.map((step, i) => element('tr', { onclick: () => show(i) }, ...cells(step, i).map((textContent) => element('td', { textContent }))));
  const table = element('table', {},
    element('thead', {}, element('tr', {}, ...COLUMNS.map((textContent) => element('th', { textContent })))), element('tbody', {}, ...rows));
  const steps = player('step', model.steps.length, show, STEP_MS);
  main.root.append(
    element('div', { className: 'caption', textContent: 'the Minkowski difference A − B of the cores: the shapes intersect where it holds the origin' }),
    element('div', { className: 'legend' }, swatch(css('vertex'), 'new vertex w, search against n'), swatch(css('simplex'), 'what is kept'), swatch(css('old'), 'simplex before'),
      swatch(css('plane'), 'support plane'), swatch(css('nearest'), 'origin and v')));
  small.root.append(element('div', { className: 'legend' }, swatch(css('a'), `A: ${model.nameA}`), swatch(css('b'), `B: ${model.nameB}`)));
  document.body.append(
    element('main', { className: 'stage' }, main.root, steps.root),
    element('aside', { className: 'side' },
      element('header', {}, element('h1', { textContent: `${model.nameA} – ${model.nameB}` }), element('div', { className: 'summary', textContent: model.answer() })),
      small.root, story, element('div', { className: 'steps' }, table)));
  const difference = new DifferenceView(main, model), shapes = new ShapesView(small, model);
  let current = 0;

  function cells(step, i) {
    const bound = step.bound === 0 ? '0' : Number.isFinite(step.bound) ? number(step.bound) : '–';
    const gap = step.best > 0 && Number.isFinite(step.bound) ? number(Math.max(step.bound - step.best, 0)) : '–';
    return [`${i + 1}${step.extended ? ' ×2' : ''}`, step.best > 0 ? number(step.best) : '–', bound, gap, step.after ? model.feature(step.after) : 'proved'];
  }

  function show(at) {
    current = at;
    steps.show(at);
    rows.forEach((row, i) => row.classList.toggle('current', i === at));
    rows[at]?.scrollIntoView({ block: 'nearest' });
    story.replaceChildren(...model.story(at).map(([kind, text]) => paragraph(kind, text)));
    difference.show(at);
    shapes.show(at);
  }

  show(0);
  return {
    kind: 'trace', model, show,
    counts: () => ({ steps: model.steps.length, step: current, iterations: model.result.iterations, status: model.result.status }),
    originAt: () => main.project(difference.changing.position),
    drawNow: () => { main.drawNow(); small.drawNow(); },
  };
}

const css = (name) => `#${COLORS[name].toString(16).padStart(6, '0')}`;

/** Makes the word before the colon bold. */
function paragraph(kind, text) {
  const [, head, rest] = /^([^:]{1,12}:)?(.*)$/s.exec(text);
  return element('p', { className: kind === 'answer' ? 'answer' : '' }, ...(head ? [element('b', { textContent: head })] : []), rest);
}
