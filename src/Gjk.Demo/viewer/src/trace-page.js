import { number } from './data.js';
import { button, element, player, swatch, tabs } from './dom.js';
import { onKeys, stageKeys } from './keys.js';
import { Stage } from './stage.js';
import { theme } from './theme.js';
import { TraceModel } from './trace-model.js';
import { DifferenceView, ShapesView } from './trace-view.js';
import { words } from './trace-words.js';

const STEP_MS = 1400;

const COLUMNS = ['step', 'lower bound', '|v|', 'gap', 'simplex'];

const DEPTH_COLUMNS = ['step', 'at least', 'at most', 'gap', 'surface'];

const CAPTIONS = {
  distance: 'the Minkowski difference A − B of the cores: the shapes intersect where it holds the origin',
  depth: 'a surface grows inside A − B: where it ends, the nearest way out of A − B is the depth',
};

export function tracePage(json) {
  const model = new TraceModel(json);
  const main = new Stage(),
    small = new Stage();
  document.body.classList.add('trace');
  small.root.classList.add('small');
  const story = element('section', { className: 'story', 'aria-live': 'polite' });
  const distance = model.steps.map((step, i) => row(i, cells(model, step, i)));
  const depth = model.depthSteps.map((step, i) =>
    row(model.steps.length + i, depthCells(step, model.steps.length + i)),
  );
  const rows = [...distance, ...depth];
  const list = element('div', { className: 'steps' }, table(COLUMNS, distance));
  if (depth.length) list.append(table(DEPTH_COLUMNS, depth));
  const steps = player('step', model.count, show, STEP_MS);
  const caption = element('div', { className: 'caption' });
  const legends = { distance: distanceLegend(), depth: depthLegend() };
  const told = element('div', { className: 'tab' }, story, list);
  const panels = [
    ['steps', 'steps', told],
    ['words', 'words', words(model)],
  ];
  const chosen = tabs('panels', panels, 'steps');
  document.body.append(
    element('main', { className: 'stage' }, caption, main.root, ...Object.values(legends), steps.root),
    element(
      'aside',
      { className: 'side' },
      header(model),
      small.root,
      chosen.root,
      ...panels.map(([, , panel]) => panel),
    ),
  );
  const difference = new DifferenceView(main, model),
    shapes = new ShapesView(small, model);
  let current = 0;

  function row(at, texts) {
    return element('tr', { onclick: () => show(at) }, ...texts.map((textContent) => element('td', { textContent })));
  }

  function show(at) {
    current = at;
    steps.show(at);
    const phase = model.isDepth(at) ? 'depth' : 'distance';
    caption.textContent = CAPTIONS[phase];
    for (const [name, legend] of Object.entries(legends)) legend.hidden = name !== phase;
    rows.forEach((each, i) => each.classList.toggle('current', i === at));
    story.replaceChildren(...model.story(at).map(([kind, text]) => paragraph(kind, text)));
    story.scrollTop = 0;
    if (rows[at]) reveal(rows[at]);
    difference.show(at);
    shapes.show(at);
  }

  onKeys({
    ...stageKeys(main, () => {
      difference.reset();
      shapes.reset();
    }),
    ArrowLeft: () => steps.go(-1),
    ArrowUp: () => steps.go(-1),
    ArrowRight: () => steps.go(1),
    ArrowDown: () => steps.go(1),
    Home: () => show(0),
    End: () => show(Math.max(model.count - 1, 0)),
    ' ': steps.toggle,
    t: () => theme.toggle(),
  });
  theme.onChange(() => show(current));
  show(0);
  return handle(model, { main, small, difference, show, current: () => current });
}

/** What a test or a developer can query about the page. */
function handle(model, { main, small, difference, show, current }) {
  return {
    kind: 'trace',
    model,
    show,
    counts: () => ({
      steps: model.count,
      depthSteps: model.depthSteps.length,
      step: current(),
      iterations: model.result.iterations,
      status: model.result.status,
    }),
    stages: [main, small],
    originAt: () => main.project(difference.changing.position),
    drawNow: () => {
      main.drawNow();
      small.drawNow();
    },
  };
}

function header(model) {
  const light = button('theme', () => theme.toggle(), { title: 'light or dark (T)' });
  const title = element(
    'div',
    { className: 'title' },
    element('h1', {}, swatch('a', model.nameA), ' – ', swatch('b', model.nameB)),
    light,
  );
  const answer = model.depth ? `${model.answer().replace(/\.$/, '')}, ${model.depth.summary()}.` : model.answer();
  return element('header', {}, title, element('div', { className: 'summary', textContent: answer }));
}

function distanceLegend() {
  return element(
    'div',
    { className: 'legend' },
    swatch('vertex', 'new vertex w, search direction d'),
    swatch('simplex', 'what is kept'),
    swatch('old', 'simplex before'),
    swatch('plane', 'support plane'),
    swatch('nearest', 'origin and v'),
    help(),
  );
}

function depthLegend() {
  return element(
    'div',
    { className: 'legend' },
    swatch('simplex', 'the surface'),
    swatch('lowest', 'its lowest triangle'),
    swatch('vertex', 'new point p, search along n'),
    swatch('plane', 'support plane'),
    swatch('nearest', 'origin, and the ball that fits inside'),
    swatch('out', 'the way out'),
    help(),
  );
}

const help = () =>
  element('span', { className: 'help', textContent: 'drag to turn, scroll to zoom; keys: ← → steps, space plays' });

function cells(model, step, i) {
  const bound = step.bound === 0 ? '0' : Number.isFinite(step.bound) ? number(step.bound) : '–';
  const gap = step.best > 0 && Number.isFinite(step.bound) ? number(Math.max(step.bound - step.best, 0)) : '–';
  const simplex = step.after ? model.feature(step.after) : 'proved';
  return [`${i + 1}${step.extended ? ' ×2' : ''}`, step.best > 0 ? number(step.best) : '–', bound, gap, simplex];
}

function depthCells({ below, above, count, outcome }, at) {
  const least = Math.max(below ?? 0, 0);
  const [most, gap] = above === null ? ['–', '–'] : [number(above), number(Math.max(above - least, 0))];
  return [
    String(at + 1),
    number(least),
    most,
    gap,
    count ? `${count} triangles` : outcome === 'Flat' ? 'none' : 'no room',
  ];
}

/** Scrolls the list, and nothing around it, until a row is in view below the list's head. */
function reveal(row) {
  const list = row.closest('.steps'),
    box = list.getBoundingClientRect(),
    { top, bottom } = row.getBoundingClientRect();
  const head = row.closest('table').tHead.getBoundingClientRect().height;
  if (top < box.top + head) list.scrollTop -= box.top + head - top;
  else if (bottom > box.bottom) list.scrollTop += bottom - box.bottom;
}

function table(columns, rows) {
  const head = element('tr', {}, ...columns.map((textContent) => element('th', { textContent })));
  return element('table', {}, element('thead', {}, head), element('tbody', {}, ...rows));
}

/** Makes the word before the colon bold. */
function paragraph(kind, text) {
  const [, head, rest] = /^([^:]{1,12}:)?(.*)$/s.exec(text);
  const bold = head ? [element('b', { textContent: head })] : [];
  return element('p', { className: kind === 'answer' ? 'answer' : '' }, ...bold, rest);
}
