import { number } from '../data.js';
import { definitions, element, segmented } from '../dom.js';
import { factsOf, headline } from './answer.js';
import { bodyFields } from './body-fields.js';
import { queryCode } from './code.js';
import { DifferenceView, turnTogether } from './difference-view.js';
import { partsOfGlb } from './glb.js';
import { giveHands } from './hands.js';
import { motionFields } from './motion-fields.js';
import { partsOf } from './obj.js';
import { button, copyButton, legend, notices, section, themeButton } from './parts.js';
import { setTheme } from './theme.js';
import { WorldModel } from './world-model.js';
import { WorldView } from './world-view.js';

/** The query is written out when the bodies rest for so long, in milliseconds: a mesh is a long text. */
const REST = 80;

const HELP = 'Drag a body to move or turn it, the background to look around; scroll or pinch to zoom. '
  + 'Keys: A, B choose the body, arrows and page keys move it, with Shift they do the other.';

/** How far the first body goes towards the second one when impacts are asked for: so much of the way. */
const FIRST_WAY = 1.2;

const LEGEND = [
  ['a', 'A'], ['b', 'B'], ['line', 'shortest way'], ['out', 'way out of the overlap'], ['motion', 'motion'],
];

/** The page of two bodies in space. */
export function worldPage(engine, given, isEmbedded) {
  const model = new WorldModel(engine);
  const view = new WorldView(model), difference = new DifferenceView(model);
  turnTogether(view.stage, difference.stage);
  let hand = 'move', shown = 'code', asked = 0, text = 0;

  const head = element('p', { className: 'headline' });
  const facts = element('div', { className: 'facts' });
  const bodies = [0, 1].map((i) => bodyFields(i, model, given, () => { view.fit(); changed(); }));
  const who = segmented('body to move', [['0', 'A'], ['1', 'B']], '0', (i) => choose(Number(i)));
  const how = segmented('what a drag does', [['move', 'move'], ['turn', 'turn']], hand, (mode) => { hand = mode; });
  const question = segmented('question', [['distance', 'distance'], ['signed', 'depth'], ['impact', 'impact']],
    model.question, ask);
  const contacts = element('input', {
    type: 'checkbox', onchange: () => { model.showsContacts = contacts.checked; changed(); },
  });
  const motions = [0, 1].map((i) => motionFields(model, i, () => changed()));
  const code = element('pre', { tabIndex: 0, className: 'code' });
  const language = segmented('the query as', [['code', 'C#'], ['record', 'record']], shown, (chosen) => {
    shown = chosen;
    showText();
  });

  document.body.className = isEmbedded ? 'world embed' : 'world';
  document.body.append(
    element('main', {},
      element('div', { className: 'view' }, view.stage.root, head, legend(LEGEND)),
      element('div', { className: 'view' }, difference.stage.root,
        element('p', { className: 'caption', textContent: 'A − B and the origin' }))),
    element('aside', { className: 'panel' },
      element('header', {}, element('h1', { textContent: 'Gjk playground' }), themeButton(),
        button('reset view', () => { model.measure(); view.fit(); changed(); }),
        element('a', { className: 'button', href: '#plane', textContent: 'in the plane' })),
      section('Hand', element('div', { className: 'line' }, who.root, how.root),
        element('p', { className: 'quiet', textContent: HELP })),
      section('Question', element('div', { className: 'line' }, question.root,
        element('label', { className: 'check' }, contacts, 'contact points')), ...motions.map(({ root }) => root)),
      section('Answer', facts),
      section('Bodies', ...bodies.map(({ root }) => root), fileField()),
      section('The same query',
        element('div', { className: 'line' }, language.root, copyButton(() => code.textContent)),
        code, recordField()),
      notices()));

  /** Shows every change once a frame at most. */
  function changed() {
    if (!asked) asked = requestAnimationFrame(show);
  }

  function show() {
    cancelAnimationFrame(asked);
    asked = 0;
    model.ask();
    model.answerText = Number.isFinite(model.answer.distance) ? number(model.answer.distance) : '';
    view.update();
    difference.update();
    head.textContent = headline(model);
    facts.replaceChildren(definitions(factsOf(model)));
    for (const fields of motions) fields.show(model.question === 'impact');
    clearTimeout(text);
    text = setTimeout(showText, REST);
  }

  function showText() {
    const record = model.record();
    code.textContent = shown === 'code' ? queryCode(model.question, model.bodies, record) : record;
  }

  function choose(index) {
    view.active = index;
    who.set(String(index));
    changed();
  }

  function ask(name) {
    model.question = name;
    const [a, b] = model.bodies;
    const isStill = [...a.motion.slice(7), ...b.motion.slice(7)].every((x) => x === 0);
    for (let axis = 0; axis < 3 && name === 'impact' && isStill; axis++)
      a.motion[7 + axis] = Math.fround(FIRST_WAY * (b.motion[4 + axis] - a.motion[4 + axis]));
    changed();
  }

  function fileField() {
    const message = element('p', { className: 'quiet', role: 'status' });
    const input = element('input', {
      type: 'file', accept: '.obj,.glb', onchange: async () => {
        try {
          const [file] = input.files, isGlb = file.name.toLowerCase().endsWith('.glb');
          const parts = isGlb ? partsOfGlb(await file.arrayBuffer()) : partsOf(await file.text());
          for (const part of parts) model.engine.shape(part.words);
          for (const body of bodies) body.offer(input.files[0].name, parts);
          message.textContent = `${parts.length} part${parts.length === 1 ? '' : 's'}: choose them above.`;
        } catch (error) {
          message.textContent = `${input.files[0].name}: ${error.message}`;
        }
      },
    });
    return element('div', {}, element('label', { className: 'file' }, 'parts of an OBJ or GLB file', input), message);
  }

  function recordField() {
    const message = element('p', { className: 'quiet', role: 'status' });
    const input = element('textarea', { rows: 3, spellcheck: false, 'aria-label': 'a record' });
    return element('details', {}, element('summary', { textContent: 'Open a record' }), input,
      button('open', () => {
        try {
          model.open(input.value.trim());
          for (const body of bodies) body.show();
          for (const fields of motions) fields.read();
          message.textContent = '';
          view.fit();
          changed();
        } catch (error) {
          message.textContent = error.message;
        }
      }), message);
  }

  given[0]?.bodies.slice(0, 2).forEach((body, i) => bodies[i].choose(body));
  giveHands(view, {
    mode: () => hand, taken: choose,
    moved: () => { for (const fields of motions) fields.read(); changed(); },
  });
  window.addEventListener('message', ({ data }) => { if (typeof data?.theme === 'string') setTheme(data.theme); });
  view.fit();
  show();
  return {
    kind: 'world', model, view, difference, show, choose,
    codeOf: (name, pair) => {
      pair.forEach(({ words, motion }, i) => engine.set(i, engine.shape(words), motion));
      return queryCode(name, pair, engine.record(0, 1));
    },
    drawNow: () => view.stage.drawNow(),
    positionOf: (index) => view.stage.project(model.position(index)),
    tipOf: (index) => view.stage.project(view.tip(index)),
  };
}
