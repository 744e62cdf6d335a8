// A study in one page. jsPsych runs the trials in order and keeps the progress; what a trial shows is in tasks.js.
import { initJsPsych, ParameterType } from 'jspsych';
import { element } from '../dom.js';
import { Engine } from '../engine.js';
import { App } from './app.js';
import * as screens from './screens.js';
import * as tasks from './tasks.js';
import { blocksOf } from './trials.js';

const plan = JSON.parse(document.getElementById('data').textContent);
const wait = element('p', { className: 'wait', role: 'status', textContent: 'Starting the library …' });
const root = element('main', { hidden: true });
document.body.append(wait, root);

/** A plugin whose trial is a function of the element to fill and of what to call with the data. */
class RunPlugin {
  static info = {
    name: 'gjk-run', version: '1.0.0', parameters: { run: { type: ParameterType.FUNCTION } }, data: {},
  };

  constructor(jsPsych) {
    this.jsPsych = jsPsych;
  }

  trial(display, { run }) {
    run(display, (data = {}) => this.jsPsych.finishTrial(data));
  }
}

const step = (run, more = {}) => ({ type: RunPlugin, run, ...more });

/** The screens before the trials, for somebody new. */
const beginning = ({ store }) => [
  step(screens.consent(plan)), step(screens.questions(plan, store)), step(screens.calibration(plan, store)),
];

/** The trials that are not done yet, with instructions before each task, and breaks. */
function trialsOf(app, jsPsych) {
  const { store } = app, blocks = blocksOf(plan, store.person), timeline = [];
  const done = new Set(store.trials.map(({ trial }) => trial));
  const total = blocks.reduce((sum, { trials }) => sum + trials.length, 0);
  let isFirst = true;
  for (const { task, trials } of blocks) {
    const rest = trials.filter(({ number }) => !done.has(number));
    if (rest.length === 0) continue;
    timeline.push(step(screens.instructions(plan, task, isFirst)));
    isFirst = false;
    rest.forEach((trial, i) => {
      if (i && plan.breakEvery && trial.number % plan.breakEvery === 0) timeline.push(step(screens.pause()));
      timeline.push(step(tasks[task](app, trial), {
        on_finish: (row) => {
          const { time_elapsed, trial_index, trial_type, plugin_version, ...own } = row;
          store.add(own);
          jsPsych.progressBar.progress = store.trials.length / total;
        },
      }));
    });
  }
  return { timeline: [...timeline, step(screens.end(store))], total };
}

/** Runs a timeline in an element of its own, by a jsPsych of its own. */
async function run(make) {
  const display_element = element('div', { className: 'run' });
  root.replaceChildren(display_element);
  const jsPsych = initJsPsych({
    display_element, show_progress_bar: true, auto_update_progress_bar: false, message_progress_bar: '',
  });
  await jsPsych.run(make(jsPsych));
}

async function start() {
  const app = new App(await Engine.start(), plan), { store } = app;
  wait.remove();
  root.hidden = false;
  // What a test or a developer can ask the page.
  window.__gjk = { app, store, plan };
  // The order of the trials follows from the person's code, which is known only after the first screens.
  const isNew = !store.state.pixelsPerMillimetre;
  if (isNew) await run(() => beginning(app));
  await run((jsPsych) => {
    const { timeline, total } = trialsOf(app, jsPsych);
    return [...(isNew ? [] : [step(screens.resume(store, total, screens.another(store)))]), ...timeline];
  });
}

start().catch((error) => {
  wait.textContent = `The study does not start in this browser: ${error.message}`;
  document.body.append(wait);
  throw error;
});
