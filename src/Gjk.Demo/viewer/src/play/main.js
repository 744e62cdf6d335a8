import { Engine, MOTION, wordsOf } from '../engine.js';
import { floats, ints } from '../data.js';

const data = JSON.parse(document.getElementById('data').textContent);
const given = { words: data.shapes.map(wordsOf), shapeOf: ints(data.shapeOf), motions: floats(data.motions) };
const engine = await Engine.start();

/** The answers of all bodies that the page was given, for a test. */
function answers(question, pairs) {
  engine.reserve(given.shapeOf.length, pairs.length);
  given.shapeOf.forEach((shape, i) => {
    engine.set(i, engine.shape(given.words[shape]), given.motions.subarray(MOTION * i, MOTION * (i + 1)));
  });
  return engine.ask(question, pairs);
}

window.__gjk = { engine, data, answers };
