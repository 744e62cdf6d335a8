import { button, element, player, swatch, tabs } from './dom.js';
import { onKeys, stageKeys } from './keys.js';
import { Stage } from './stage.js';
import { theme } from './theme.js';
import { TraceModel } from './trace-model.js';
import { CodePanel, TextbookPanel } from './trace-panels.js';
import { regionsOf } from './trace-regions.js';
import { cells, depthCells, paragraph, reveal, table } from './trace-table.js';
import { DifferenceView, ShapesView } from './trace-view.js';
import { words } from './trace-words.js';

const STEP_MS = 1400;

const COLUMNS = ['step', 'lower bound', '|v|', 'gap', 'simplex'];

const DEPTH_COLUMNS = ['step', 'at least', 'at most', 'gap', 'surface'];

const CAPTIONS = {
  distance: 'the Minkowski difference A − B of the cores: the shapes intersect where it holds the origin',
  textbook: 'the same A − B, walked by the textbook’s GJK in float',
  depth: 'a surface grows inside A − B: where it ends, the nearest way out of A − B is the depth',
};

/** What a picture shows after each line of the code: nothing, the vertex, its plane, the walls, the rest, v. */
const STAGES = { start: 0, repeat: 0, support: 1, bound: 2, join: 3, inside: 4, region: 4 };

const ALL = 5;

export function tracePage(json) {
  const model = new TraceModel(json),
    { textbook } = model;
  const main = new Stage(),
    small = new Stage();
  document.body.classList.add('trace');
  small.root.classList.add('small');
  const places = { exact: 0, textbook: 0 };
  let tab = 'steps',
    line = 0;
  const steps = player('step', model.count, show, STEP_MS);
  const caption = element('div', { className: 'caption' });
  const legends = { distance: distanceLegend(), depth: depthLegend() };
  const told = new StepsPanel(model, show),
    code = new CodePanel(model, goLine);
  const book = new TextbookPanel(model, show);
  const difference = new DifferenceView(main, model),
    shapes = new ShapesView(small, model);
  const panels = [
    ['steps', 'steps', told.root],
    ['code', 'code', code.root],
    ['textbook', 'textbook', book.root],
    ['words', 'A − B', words(model)],
  ];
  const chosen = tabs('panels', panels, 'steps', choose);
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

  /** Which algorithm is shown: the one of the chosen panel. */
  function run() {
    return tab === 'textbook' ? 'textbook' : 'exact';
  }

  function choose(name) {
    tab = name;
    document.body.dataset.tab = name;
    steps.stop();
    steps.resize(run() === 'exact' ? model.count : textbook.count);
    show(places[run()]);
  }

  /** Goes to the end of a step. */
  function show(at) {
    line = Math.max(0, model.lines(at).length - 1);
    draw(at);
  }

  /** Goes to the line before or after, of this step or the next one. */
  function goLine(by) {
    const at = places.exact,
      next = line + by;
    if (next >= 0 && next < model.lines(at).length) line = next;
    else if (next < 0 && at > 0) return show(at - 1);
    else if (by > 0 && at + 1 < model.count) line = 0;
    else return;
    draw(by > 0 && next > 0 && line === 0 ? at + 1 : at);
  }

  function draw(at) {
    const isExact = run() === 'exact',
      walk = isExact ? model : textbook;
    places[run()] = at;
    steps.show(at);
    const phase = walk.isDepth(at) ? 'depth' : 'distance';
    caption.textContent = isExact ? CAPTIONS[phase] : CAPTIONS.textbook;
    for (const [name, legend] of Object.entries(legends)) legend.hidden = name !== phase;
    if (!isExact) book.show(at);
    else if (tab === 'code') code.show(at, line);
    else told.show(at);
    const stage = tab === 'code' ? (STAGES[model.lines(at)[line]] ?? ALL) : ALL;
    const walls = tab === 'code' && stage > 2 ? regionsOf(model, at).corners : [];
    difference.show(walk, at, stage, walls);
    shapes.show(walk, at);
  }

  onKeys({
    ...stageKeys(main, () => [difference, shapes].forEach((view) => view.reset())),
    ArrowLeft: () => steps.go(-1),
    ArrowRight: () => steps.go(1),
    ArrowUp: () => (tab === 'code' ? goLine(-1) : steps.go(-1)),
    ArrowDown: () => (tab === 'code' ? goLine(1) : steps.go(1)),
    Home: () => show(0),
    End: () => show(Math.max((run() === 'exact' ? model : textbook).count - 1, 0)),
    ' ': steps.toggle,
    t: () => theme.toggle(),
  });
  theme.onChange(() => draw(places[run()]));
  if (json.isExample) {
    // On the failure, which is the textbook's last step.
    places.textbook = textbook.count - 1;
    chosen.show('textbook');
  } else show(0);
  const now = () => ({ step: places[run()], tab, line: tab === 'code' ? model.lines(places.exact)[line] : null });
  return handle(model, { main, small, difference, show, now });
}

/** The steps in words and numbers. */
class StepsPanel {
  constructor(model, show) {
    this.model = model;
    this.story = element('section', { className: 'story', 'aria-live': 'polite' });
    const row = (at, texts) =>
      element('tr', { onclick: () => show(at) }, ...texts.map((textContent) => element('td', { textContent })));
    const distance = model.steps.map((step, i) => row(i, cells(model, step, i)));
    const depth = model.depthSteps.map((step, i) => {
      const at = model.steps.length + i;
      return row(at, depthCells(step, at));
    });
    this.rows = [...distance, ...depth];
    const list = element('div', { className: 'steps' }, table(COLUMNS, distance));
    if (depth.length) list.append(table(DEPTH_COLUMNS, depth));
    this.root = element('div', { className: 'tab' }, this.story, list);
  }

  show(at) {
    this.rows.forEach((each, i) => each.classList.toggle('current', i === at));
    this.story.replaceChildren(...this.model.story(at).map(([kind, text]) => paragraph(kind, text)));
    this.story.scrollTop = 0;
    if (this.rows[at]) reveal(this.rows[at]);
  }
}

/** What a test or a developer can query about the page. */
function handle(model, { main, small, difference, show, now }) {
  return {
    kind: 'trace',
    model,
    show,
    counts: () => ({
      steps: model.count,
      depthSteps: model.depthSteps.length,
      textbookSteps: model.textbook.count,
      textbookEnding: model.textbook.json.ending,
      ...now(),
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
