import { element } from '../dom.js';
import { button, themeButton } from '../play/parts.js';
import { setTheme } from '../play/theme.js';
import { length, minus, plus } from './geometry.js';
import { KINDS } from './kinds.js';
import { ROOM } from './lesson.js';
import { PlaneModel } from './plane-model.js';
import { walker } from './walker.js';
import { Picture } from './svg.js';
import { lights, marked } from './lights.js';

/** In CSS pixels: how near a finger or the mouse must come to a handle. */
const REACH = 24;

/** How far a key moves a polygon, and how far it turns it, in radians. */
const STEP = 0.1, KEY_TURN = Math.PI / 36;

/** Of how many steps, at least, the text is measured. */
const MEASURED = 20;

const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };

const HELP = 'Keys: A, B choose a shape, arrows move it, with Shift they turn it; Page Down and Page Up walk the steps.';

/**
 * The page of two polygons in the plane. Its address chooses the figure: #plane=depth, and &embed leaves out
 * everything but the figure.
 */
export function planePage(engine, parameters) {
  const model = new PlaneModel(engine);
  const world = new Picture('both shapes'), difference = new Picture('A − B and the origin');
  const page = { kind: 'plane', model, world, difference, show, go, choose, lesson: null };
  let active = 1, tallest = 0;
  const told = element('p', { className: 'story' });
  const head = element('p', { className: 'headline', role: 'status' });
  const walk = walker(go, () => page.lesson);
  const help = element('p', { className: 'quiet help' });
  const select = element('select', { 'aria-label': 'figure', onchange: () => choose(select.value) },
    ...Object.entries(KINDS).map(([value, { name }]) => element('option', { value, textContent: name })));
  const isEmbedded = parameters.has('embed');
  document.body.className = isEmbedded ? 'plane embed' : 'plane';
  const away = new URLSearchParams(parameters);
  document.body.append(
    element('header', { className: 'bar' }, element('h1', { textContent: 'GJK in the plane' }), select, themeButton(),
      element('a', { className: 'button', href: '#', textContent: 'in space' })),
    element('main', {},
      element('div', { className: 'view' }, head, element('div', { className: 'frame' }, world.root)),
      element('div', { className: 'view' },
        element('p', { className: 'caption', textContent: 'A − B and the origin' }),
        element('div', { className: 'frame' }, difference.root))),
    element('div', { className: 'steps' }, walk.root, told), help);
  const light = lights(document.body);

  function choose(name) {
    walk.stop();
    model.load(KINDS[name].shapes);
    page.lesson = KINDS[name].make(model);
    page.lesson.changed();
    help.textContent = `${page.lesson.help} ${HELP}`;
    away.set('plane', name);
    history.replaceState(null, '', `#${String(away).replace('embed=', 'embed')}`);
    select.value = name;
    resized();
  }

  function go(step) {
    page.lesson.step = Math.max(0, Math.min(page.lesson.count - 1, step));
    show();
  }

  function show() {
    const { lesson } = page;
    // First what the pictures leave room for.
    told.replaceChildren(...marked(lesson.told()));
    head.textContent = lesson.headline();
    walk.show();
    grow();
    lesson.drawWorld(world, active);
    lesson.drawDifference(difference);
    light.again();
  }

  /** The text keeps the height of its longest step, so that nothing below it moves while the steps are walked. */
  function grow() {
    if (told.offsetHeight <= tallest) return;
    tallest = told.offsetHeight;
    told.style.minHeight = `${tallest}px`;
    tellHeight();
  }

  function resized() {
    const { lesson } = page, { step } = lesson;
    tallest = 0;
    told.style.minHeight = '';
    const last = Math.min(lesson.count, MEASURED * 4) - 1, stride = Math.max(1, Math.floor(last / MEASURED));
    for (lesson.step = 0; lesson.step <= last; lesson.step += stride) {
      told.replaceChildren(...marked(lesson.told()));
      tallest = Math.max(tallest, told.offsetHeight);
    }
    lesson.step = step;
    told.style.minHeight = `${tallest}px`;
    show();
    tellHeight();
  }

  /** Tells the page around an embedded figure how tall it is. */
  function tellHeight() {
    if (isEmbedded) window.parent.postMessage({ figureHeight: Math.ceil(document.body.scrollHeight) }, '*');
  }

  function changed() {
    model.ask();
    page.lesson.changed();
    show();
  }

  watchPointer(page, (index) => { active = index; }, changed);
  window.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || event.target.closest?.('select, input')) return;
    const letter = 'ab'.indexOf(event.key.toLowerCase()), arrow = ARROWS[event.key];
    if (letter >= 0) active = letter;
    else if (event.key === 'PageDown') return go(page.lesson.step + 1);
    else if (event.key === 'PageUp') return go(page.lesson.step - 1);
    else if (arrow && event.shiftKey && page.lesson.turns) model.turn(active, -(arrow[0] + arrow[1]) * KEY_TURN);
    else if (arrow && !event.shiftKey) move(page, active, arrow.map((x) => x * STEP));
    else return;
    event.preventDefault();
    changed();
  });
  window.addEventListener('message', ({ data }) => {
    if (typeof data?.theme === 'string') setTheme(data.theme);
    if (typeof data?.part === 'string') light.show(data.part);
    if (data?.isAsked) tellHeight();
  });
  choose(KINDS[parameters.get('plane')] ? parameters.get('plane') : Object.keys(KINDS)[0]);
  for (const picture of [world, difference]) picture.onResize = resized;
  return page;
}

/** Moves a body, and keeps it in the picture with everything that turns with it. */
function move({ model, world, lesson }, index, by) {
  const body = model.bodies[index], most = lesson.reach(index) + ROOM;
  const to = plus(body.at, by).map((x, axis) => {
    const end = Math.max(0, (axis ? world.tall : world.wide) - most);
    return Math.max(-end, Math.min(end, x));
  });
  model.move(index, minus(to, body.at));
}

/** Lets the mouse or a finger move and turn what a figure lets them. */
function watchPointer(page, taken, changed) {
  const { world, model } = page;
  let hold = null;
  world.root.addEventListener('pointerdown', (event) => {
    hold = grab(page, world.at(event));
    if (!hold) return;
    world.root.setPointerCapture(event.pointerId);
    if (hold.body !== undefined) taken(hold.body);
    page.show();
  });
  world.root.addEventListener('pointermove', (event) => {
    const at = world.at(event);
    if (!hold) {
      world.root.classList.toggle('over', Boolean(grab(page, at)));
      return;
    }
    const angle = (p) => Math.atan2(...minus(p, model.bodies[hold.body].at).reverse());
    if (hold.handle) {
      hold.handle.move(at);
      page.show();
      return;
    }
    if (hold.isTurned) model.turn(hold.body, angle(at) - angle(hold.at));
    else move(page, hold.body, minus(at, hold.at));
    hold.at = at;
    changed();
  });
  for (const end of ['pointerup', 'pointercancel']) world.root.addEventListener(end, () => { hold = null; });
}

function grab({ world, model, lesson }, at) {
  const reach = REACH * world.unit, isNear = (p) => length(minus(p, at)) < reach;
  const handle = lesson.handles().find((each) => isNear(each.at));
  if (handle) return { handle };
  const body = [0, 1].find((i) => lesson.turns && isNear(lesson.turnedBy(i)));
  if (body !== undefined) return { body, isTurned: true, at };
  const inside = [0, 1].find((i) => isInside(model.outline(i), at));
  return inside === undefined ? null : { body: inside, at };
}

/** Whether a point lies in a convex polygon. */
function isInside(outline, at) {
  return outline.every((p, i) => {
    const [x, y] = minus(outline[(i + 1) % outline.length], p), [z, w] = minus(at, p);
    return x * w - y * z >= 0;
  });
}
