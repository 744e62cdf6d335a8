import { number } from './data.js';
import { element, player, swatch } from './dom.js';
import { COLORS } from './marks.js';
import { Stage } from './stage.js';
import { TraceModel } from './trace-model.js';
import { DifferenceView, ShapesView } from './trace-view.js';

const STEP_MS = 1400;

const COLUMNS = ['step', 'lower bound', '|v|', 'gap', 'simplex'];

const DEPTH_COLUMNS = ['step', 'at least', 'at most', 'gap', 'surface'];

const CAPTIONS = {
  distance: 'the Minkowski difference A − B of the cores: the shapes intersect where it holds the origin',
  depth: 'a surface grows inside A − B: where it ends, the nearest way out of A − B is the depth',
};

export function tracePage(json) {
  const model = new TraceModel(json);
  const main = new Stage(), small = new Stage();
  document.body.classList.add('trace');
  small.root.classList.add('small');
  const story = element('section', { className: 'story', 'aria-live': 'polite' });
  const distance = model.steps.map((step, i) => row(i, cells(step, i)));
  const depth = (model.depth?.steps ?? []).map((step, i) => row(model.steps.length + i, depthCells(step, model.steps.length + i)));
  const rows = [...distance, ...depth];
  const steps = player('step', model.count, show, STEP_MS);
  const caption = element('div', { className: 'caption' });
  const legends = {
    distance: element('div', { className: 'legend' }, swatch(css('vertex'), 'new vertex w, search against n'), swatch(css('simplex'), 'what is kept'),
      swatch(css('old'), 'simplex before'), swatch(css('plane'), 'support plane'), swatch(css('nearest'), 'origin and v')),
    depth: element('div', { className: 'legend' }, swatch(css('simplex'), 'the surface'), swatch(css('lowest'), 'its lowest triangle'), swatch(css('vertex'), 'new point p, search along n'),
      swatch(css('plane'), 'support plane'), swatch(css('nearest'), 'origin, and the ball that fits inside'), swatch(css('out'), 'the way out')),
  };
  main.root.append(caption, ...Object.values(legends));
  small.root.append(element('div', { className: 'legend' }, swatch(css('a'), `A: ${model.nameA}`), swatch(css('b'), `B: ${model.nameB}`)));
  document.body.append(
    element('main', { className: 'stage' }, main.root, steps.root),
    element('aside', { className: 'side' },
      element('header', {}, element('h1', { textContent: `${model.nameA} – ${model.nameB}` }), element('div', { className: 'summary', textContent: model.depth ? `${model.answer().replace(/\.$/, '')}, ${model.depth.summary()}.` : model.answer() })),
      small.root, story, element('div', { className: 'steps' }, table(COLUMNS, distance), ...(depth.length ? [table(DEPTH_COLUMNS, depth)] : []))));
  const difference = new DifferenceView(main, model), shapes = new ShapesView(small, model);
  let current = 0;

  function row(at, texts) {
    return element('tr', { onclick: () => show(at) }, ...texts.map((textContent) => element('td', { textContent })));
  }

  function depthCells({ below, above, count, outcome }, at) {
    const least = Math.max(below ?? 0, 0);
    return [String(at + 1), number(least), above === null ? '–' : number(above), above === null ? '–' : number(Math.max(above - least, 0)),
      count ? `${count} triangles` : outcome === 'Flat' ? 'none' : 'no room'];
  }

  function cells(step, i) {
    const bound = step.bound === 0 ? '0' : Number.isFinite(step.bound) ? number(step.bound) : '–';
    const gap = step.best > 0 && Number.isFinite(step.bound) ? number(Math.max(step.bound - step.best, 0)) : '–';
    return [`${i + 1}${step.extended ? ' ×2' : ''}`, step.best > 0 ? number(step.best) : '–', bound, gap, step.after ? model.feature(step.after) : 'proved'];
  }

  function show(at) {
    current = at;
    steps.show(at);
    const phase = model.isDepth(at) ? 'depth' : 'distance';
    caption.textContent = CAPTIONS[phase];
    for (const [name, legend] of Object.entries(legends)) legend.hidden = name !== phase;
    rows.forEach((row, i) => row.classList.toggle('current', i === at));
    story.replaceChildren(...model.story(at).map(([kind, text]) => paragraph(kind, text)));
    if (rows[at]) reveal(rows[at]);
    difference.show(at);
    shapes.show(at);
  }

  show(0);
  return {
    kind: 'trace', model, show,
    counts: () => ({ steps: model.count, depthSteps: model.depth?.steps.length ?? 0, step: current, iterations: model.result.iterations, status: model.result.status }),
    originAt: () => main.project(difference.changing.position),
    drawNow: () => { main.drawNow(); small.drawNow(); },
  };
}

/** Scrolls the list, and nothing around it, until a row is in view below the list's head. */
function reveal(row) {
  const list = row.closest('.steps'), box = list.getBoundingClientRect(), { top, bottom } = row.getBoundingClientRect();
  const head = row.closest('table').tHead.getBoundingClientRect().height;
  if (top < box.top + head) list.scrollTop -= box.top + head - top;
  else if (bottom > box.bottom) list.scrollTop += bottom - box.bottom;
}

function table(columns, rows) {
  return element('table', {},
    element('thead', {}, element('tr', {}, ...columns.map((textContent) => element('th', { textContent })))), element('tbody', {}, ...rows));
}

const css = (name) => `#${COLORS[name].toString(16).padStart(6, '0')}`;

/** Makes the word before the colon bold. */
function paragraph(kind, text) {
  const [, head, rest] = /^([^:]{1,12}:)?(.*)$/s.exec(text);
  return element('p', { className: kind === 'answer' ? 'answer' : '' }, ...(head ? [element('b', { textContent: head })] : []), rest);
}
