import { number } from '../data.js';
import { element } from '../dom.js';
import { button, themeButton } from '../play/parts.js';
import { DifferenceFigure, WorldFigure } from './figures.js';
import { length, minus } from './geometry.js';
import { PlaneModel } from './plane-model.js';
import { PRESETS } from './presets.js';
import { story } from './story.js';

/** In CSS pixels: how near a finger or the mouse must come to a handle. */
const REACH = 24;

/** How far a key moves a polygon, and how far it turns it, in radians. */
const STEP = 0.1, KEY_TURN = Math.PI / 36;

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const HELP = 'Drag a polygon, or turn it by its handle. Keys: A, B choose one, arrows move it, with Shift they turn '
  + 'it; Page Down and Page Up walk the steps.';

/**
 * The page of two polygons in the plane. Its address chooses the figure: #plane=overlap, and &embed leaves out
 * everything but the figure.
 */
export function planePage(engine, parameters) {
  const model = new PlaneModel(engine);
  const world = new WorldFigure(model), difference = new DifferenceFigure(model);
  let active = 0;
  const told = element('p', { className: 'story', 'aria-live': 'polite' });
  const count = element('output', { className: 'count' });
  const head = element('p', { className: 'headline' });
  const walk = [
    ['|◀', 'first step', () => 0], ['◀', 'step back', () => model.stage - 1],
    ['▶', 'next step', () => model.stage + 1], ['▶|', 'answer', () => model.stages.length - 1],
  ].map(([text, label, to]) => {
    const root = button(text, () => go(to()));
    root.setAttribute('aria-label', label);
    root.title = label;
    return root;
  });
  const select = element('select', { 'aria-label': 'figure', onchange: () => choose(select.value) },
    ...Object.entries(PRESETS).map(([value, { name }]) => element('option', { value, textContent: name })));
  document.body.className = parameters.has('embed') ? 'plane embed' : 'plane';
  const away = new URLSearchParams(parameters);
  document.body.append(
    element('header', { className: 'bar' }, element('h1', { textContent: 'GJK in the plane' }), select, themeButton(),
      element('a', { className: 'button', href: '#', textContent: 'in space' })),
    element('main', {},
      element('div', { className: 'view' }, world.root, head),
      element('div', { className: 'view' }, difference.root,
        element('p', { className: 'caption', textContent: 'A − B and the origin' }))),
    element('div', { className: 'steps' }, element('div', { className: 'line' }, ...walk, count), told),
    element('p', { className: 'quiet help', textContent: HELP }));

  function choose(preset) {
    model.load(preset);
    away.set('plane', preset);
    history.replaceState(null, '', `#${String(away).replace('embed=', 'embed')}`);
    show();
  }

  function go(stage) {
    model.stage = Math.max(0, Math.min(model.stages.length - 1, stage));
    show();
  }

  function show() {
    world.draw(active);
    difference.draw();
    const { step, isReduced } = model.stages[model.stage];
    count.textContent = `step ${step + 1} of ${model.steps.length}, ${isReduced ? 'reduce' : 'support'}`;
    told.textContent = story(model);
    const { answer, stage, stages } = model, isApart = answer.status === 'Separated';
    head.textContent = isApart ? `apart by ${number(answer.distance)}` : 'touching or overlapping';
    walk.forEach((each, i) => { each.disabled = stage === (i < 2 ? 0 : stages.length - 1); });
  }

  function changed() {
    model.ask();
    show();
  }

  watchPointer(world, model, (index) => { active = index; }, changed);
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest?.('select')) return;
    const letter = 'ab'.indexOf(event.key.toLowerCase()), arrow = ARROWS[event.key];
    if (letter >= 0) active = letter;
    else if (event.key === 'PageDown') return go(model.stage + 1);
    else if (event.key === 'PageUp') return go(model.stage - 1);
    else if (arrow && event.shiftKey) model.turn(active, -(arrow[0] + arrow[1]) * KEY_TURN);
    else if (arrow) model.move(active, arrow.map((x) => x * STEP));
    else return;
    event.preventDefault();
    changed();
  });
  world.onResize = show;
  const preset = parameters.get('plane');
  if (PRESETS[preset]) model.load(preset);
  select.value = model.preset;
  show();
  return { kind: 'plane', model, world, difference, show, go, choose };
}

/** Moves and turns the polygons by the mouse or a finger. */
function watchPointer(figure, model, taken, changed) {
  let hold = null;
  figure.root.addEventListener('pointerdown', (event) => {
    hold = grab(figure, model, figure.at(event));
    if (!hold) return;
    figure.root.setPointerCapture(event.pointerId);
    taken(hold.body);
    changed();
  });
  figure.root.addEventListener('pointermove', (event) => {
    const at = figure.at(event);
    if (!hold) {
      figure.root.classList.toggle('over', Boolean(grab(figure, model, at)));
      return;
    }
    const angle = (p) => Math.atan2(...minus(p, model.bodies[hold.body].at).reverse());
    if (hold.isHandle) model.turn(hold.body, angle(at) - angle(hold.at));
    else model.move(hold.body, minus(at, hold.at));
    hold.at = at;
    changed();
  });
  for (const end of ['pointerup', 'pointercancel']) figure.root.addEventListener(end, () => { hold = null; });
}

function grab(figure, model, at) {
  const reach = REACH * figure.unit;
  for (const body of [0, 1]) {
    const isTurned = model.outline(body).length > 1;
    if (isTurned && length(minus(figure.handle(body), at)) < reach) return { body, isHandle: true, at };
  }
  const body = [0, 1].find((i) => isInside(model.outline(i), at, reach));
  return body === undefined ? null : { body, at };
}

/** Whether a point lies in a convex polygon, or near its only corner. */
function isInside(outline, at, reach) {
  if (outline.length < 3) return length(minus(outline[0], at)) < reach;
  return outline.every((p, i) => {
    const [x, y] = minus(outline[(i + 1) % outline.length], p), [z, w] = minus(at, p);
    return x * w - y * z >= 0;
  });
}
