import { Vector3 } from 'three';
import { count } from './data.js';
import { button, element, player, segmented, swatch, toggle } from './dom.js';
import { onKeys, stageKeys } from './keys.js';
import { PairList } from './pair-list.js';
import { SceneDetails } from './scene-details.js';
import { SceneModel } from './scene-model.js';
import { SceneView } from './scene-view.js';
import { Stage } from './stage.js';
import { theme } from './theme.js';

/** With more pairs than this, the page starts with only the lines to nearest partners. */
const MANY_PAIRS = 30;

const FRAME_MS = 60;

/** A pointer that moves no further than this, in pixels, clicks. */
const CLICK = 4;

export function scenePage(json) {
  const model = new SceneModel(json);
  const stage = new Stage();
  const view = new SceneView(stage, model);
  const details = new SceneDetails(model);
  if (model.pairs > MANY_PAIRS) view.lineMode = 'nearest';

  const summary = element('div', { className: 'summary' });
  const detail = element('section', { className: 'detail', hidden: true });
  const chipName = element('strong');
  const chip = element(
    'div',
    { className: 'chip', hidden: true },
    'pairs of',
    chipName,
    button('show all', () => filter(-1)),
  );
  const list = new PairList(model, select);
  const frames = player('frame', model.frames, showFrame, FRAME_MS);
  const tip = element('div', { className: 'tip', hidden: true });
  const ground = element('span', { className: 'ground', hidden: true, textContent: view.axes.text });
  stage.root.append(tip);
  if (!model.objects) stage.say('This scene has no objects.');
  const header = element('header', {}, element('h1', { textContent: model.name }), summary, ...controls());
  document.body.classList.add('scene');
  document.body.append(
    element('main', { className: 'stage' }, stage.root, legend(), frames.root),
    element('aside', { className: 'side' }, header, chip, detail, list.head, list.rows),
  );

  function controls() {
    const repaint = (change) => (value) => {
      change(value);
      view.paint();
    };
    const modes = ['all', 'nearest', 'none'].map((mode) => [mode, mode]);
    const lines = segmented(
      'lines',
      modes,
      view.lineMode,
      repaint((mode) => {
        view.lineMode = mode;
      }),
    );
    const shown = [
      [true, 'shown'],
      [false, 'hidden'],
    ];
    const casts = segmented(
      'paths and impacts',
      shown,
      true,
      repaint((isShown) => {
        view.showsCasts = isShown;
      }),
    );
    const names = toggle(
      'names',
      'show the names of the objects (N)',
      repaint((isOn) => {
        view.showsNames = isOn;
      }),
    );
    const axes = toggle('axes', 'show the axes and the ground (G)', showAxes);
    const light = button('theme', () => theme.toggle(), { title: 'light or dark (T)' });
    onKeys({
      ...stageKeys(stage, reset, model.frames > 1 ? undefined : ''),
      ...(model.frames > 1
        ? { ArrowLeft: () => frames.go(-1), ArrowRight: () => frames.go(1), ' ': frames.toggle }
        : {}),
      ArrowDown: () => list.go(1),
      ArrowUp: () => list.go(-1),
      Escape: () => select(-1),
      n: () => names.click(),
      g: () => axes.click(),
      t: () => theme.toggle(),
    });
    return [
      element('div', { className: 'controls' }, 'lines', lines.root, button('reset view', reset)),
      element('div', { className: 'controls' }, names, axes, light),
      element('div', { className: 'controls', hidden: !model.castData.isMoving }, 'paths and impacts', casts.root),
    ];
  }

  function legend() {
    const turn = model.frames > 1 ? '← → frames, Shift + arrows turn' : '← → turn';
    const help = `drag to turn, scroll to zoom, click to pick; keys: ↑ ↓ pairs, ${turn}, + − zoom`;
    return element(
      'div',
      { className: 'legend' },
      swatch('hit', 'intersecting (striped)', true),
      swatch('free', 'free'),
      swatch('line', 'closest points'),
      swatch('wayOut', 'shortest way out'),
      swatch('contact', 'contact points'),
      ...(model.castData.isMoving ? [swatch('impact', 'path of a frame, impact')] : []),
      ground,
      element('span', { className: 'help', textContent: help }),
    );
  }

  function reset() {
    stage.look = null;
    stage.fit(view.balls());
  }

  function showAxes(isOn) {
    view.axes.isShown = isOn;
    ground.hidden = !isOn;
    view.paint();
    if (stage.balls) reset();
  }

  function showFrame(frame) {
    model.show(frame);
    view.update();
    list.update();
    frames.show(frame);
    const hits = model.overlapping[frame];
    document.body.dataset.overlapping = hits;
    const listed = model.pairs < model.allPairs;
    summary.replaceChildren(
      `${count(model.objects, 'object')}, ${count(model.allPairs, 'pair')}, `,
      element('span', { className: hits ? 'hit' : '', textContent: `${hits} intersecting` }),
      listed ? `; listed: those that intersect, and each object’s nearest (${model.pairs})` : '',
    );
    showDetail();
  }

  function select(pair) {
    view.selected = pair;
    view.paint();
    showDetail();
    list.show(pair);
  }

  function filter(object) {
    list.object = object;
    chip.hidden = object < 0;
    chipName.textContent = object < 0 ? '' : model.names[object];
    list.rows.scrollTop = 0;
    list.update();
  }

  function showDetail() {
    detail.hidden = view.selected < 0;
    if (view.selected >= 0) detail.replaceChildren(...details.panel(view.selected));
  }

  watchPointer(stage, view, {
    hover(hit, x, y) {
      tip.hidden = hit.pair === undefined && hit.object === undefined;
      if (tip.hidden) return;
      tip.replaceChildren(...details.tip(hit));
      const box = stage.root.getBoundingClientRect();
      tip.style.left = `${Math.max(0, Math.min(x - box.left + 16, box.width - tip.offsetWidth - 8))}px`;
      tip.style.top = `${Math.max(0, Math.min(y - box.top + 16, box.height - tip.offsetHeight - 8))}px`;
    },
    click(hit) {
      if (hit.pair !== undefined) return select(hit.pair);
      filter(hit.object ?? -1);
      select(hit.object === undefined ? -1 : (list.order[0] ?? -1));
    },
  });
  showFrame(0);
  stage.fit(view.balls());
  return handle(model, stage, view, { select, showFrame });
}

/** What a test or a developer can query about the page. */
function handle(model, stage, view, actions) {
  return {
    kind: 'scene',
    model,
    view,
    stage,
    ...actions,
    counts: () => ({
      objects: model.objects,
      pairs: model.pairs,
      frames: model.frames,
      frame: model.frame,
      overlapping: model.overlapping[model.frame],
      lines: view.lines.pairs.length,
      arrows: view.arrows.pairs.length,
      contacts: view.contacts.points.length,
      paths: view.casts.paths,
      impacts: view.casts.impacts.length,
    }),
    colorOf: (object) => view.colorOf(object),
    positionOf: (object) => stage.project(model.position(object)),
    lineAt: (pair, share) => {
      const [from, to] = model.line(pair) ?? model.wayOut(pair);
      return stage.project(new Vector3().lerpVectors(from, to, share));
    },
    contactAt: (pair, i) => stage.project(model.contacts(pair)[i].ends[0]),
    impactAt: (pair) => stage.project(model.drawn(...model.impact(pair).point)),
    selected: () => view.selected,
    stages: [stage],
    drawNow: () => stage.drawNow(),
  };
}

/** Handles hovering, and clicks that do not end a drag. */
function watchPointer(stage, view, { hover, click }) {
  if (!stage.renderer) return;
  const canvas = stage.renderer.domElement;
  let down = null;
  canvas.addEventListener('pointerdown', (event) => {
    down = [event.clientX, event.clientY];
    hover({});
  });
  canvas.addEventListener('pointermove', (event) => {
    if (!event.buttons) hover(view.pick(event.clientX, event.clientY), event.clientX, event.clientY);
  });
  canvas.addEventListener('pointerleave', () => hover({}));
  canvas.addEventListener('pointerup', (event) => {
    const isClick = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) < CLICK;
    if (isClick) click(view.pick(event.clientX, event.clientY));
    down = null;
  });
}
