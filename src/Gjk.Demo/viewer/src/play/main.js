import { floats, ints } from '../data.js';
import { Engine, MOTION, wordsOf } from '../engine.js';
import { element } from '../dom.js';
import { planePage } from '../plane/plane-page.js';
import { givenBodies } from './world-model.js';
import { worldPage } from './world-page.js';

const data = JSON.parse(document.getElementById('data').textContent);
const motions = floats(data.motions), shapeOf = ints(data.shapeOf);
const words = data.shapes.map(wordsOf);
const wait = element('p', { className: 'wait', role: 'status', textContent: 'Starting the library …' });
document.body.append(wait);

/** The answers of all bodies that the page was given, for a test. */
function answers(engine, question, pairs) {
  engine.reserve(shapeOf.length, pairs.length);
  shapeOf.forEach((shape, i) => {
    engine.set(i, engine.shape(words[shape]), motions.subarray(MOTION * i, MOTION * (i + 1)));
  });
  const result = engine.ask(question, pairs);
  engine.reserve(2, 1);
  return result;
}

try {
  const engine = await Engine.start();
  wait.remove();
  const bodies = givenBodies(data, motions, shapeOf);
  const parameters = new URLSearchParams(location.hash.slice(1));
  const page = parameters.has('plane')
    ? planePage(engine, parameters)
    : worldPage(engine, bodies.length ? [{ label: data.name, bodies }] : [], parameters.has('embed'));
  // The other mode, or another figure, is another page.
  window.addEventListener('hashchange', () => location.reload());
  // What a test or a developer can query about the page.
  window.__gjk = Object.assign(page, {
    engine, bodies, answers: (question, pairs) => answers(engine, question, pairs),
  });
} catch (error) {
  wait.textContent = `The library does not start in this browser: ${error.message}`;
  throw error;
}
