// The trials of one person: all that the plan asks for, in an order that follows from its seed and the person's code.

/** Mulberry32: a small generator of numbers from 0 to 1. */
export function randomFrom(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}

/** A number that follows from a text (FNV-1a). */
function hash(text) {
  let value = 0x811c9dc5;
  for (const c of text) value = Math.imul(value ^ c.codePointAt(0), 0x01000193);
  return value >>> 0;
}

function shuffled(items, random) {
  const result = [...items];
  for (let i = result.length - 1; i > 0; i--) {
    const k = Math.floor(random() * (i + 1));
    [result[i], result[k]] = [result[k], result[i]];
  }
  return result;
}

const repeated = (count, items) => Array.from({ length: count }, () => items).flat();

/** Blocks of trials: {task, trials}. Each trial has its number, kind, pair, view and what its task needs. */
export function blocksOf(plan, person) {
  const random = randomFrom(hash(`${plan.seed} ${person}`));
  const conditions = plan.pairs.flatMap((pair) => plan.views.map((view) => ({ pair, view })));
  const all = (task, count, each) =>
    conditions.flatMap((c) => repeated(count, each).map((e) => ({ task, ...c, ...e })));
  const blocks = [];
  const { adjustment, constant, mismatch } = plan;
  const add = (task, trials, order = shuffled) =>
    blocks.push({ task, trials: [...practice(plan, trials), ...order(trials, random)] });
  if (adjustment) {
    const starts = adjustment.starts.map((start) => ({ start }));
    add('adjustment', all('adjustment', adjustment.repeats, starts), alternated);
  }
  if (constant) {
    const catches = Array.from({ length: plan.catchTrials }, (_, i) => ({
      task: 'constant', kind: 'catch', ...conditions[i % conditions.length],
      gap: i % 2 ? -plan.catchGap : plan.catchGap,
    }));
    const gaps = constant.gaps.map((gap) => ({ gap }));
    add('constant', [...all('constant', constant.repeats, gaps), ...catches]);
  }
  if (mismatch) {
    const colliders = mismatch.colliders.map((collider) => ({ collider }));
    add('mismatch', all('mismatch', mismatch.repeats, colliders));
  }
  let number = 0;
  for (const trial of blocks.flatMap(({ trials }) => trials)) {
    trial.number = ++number;
    trial.camera = cameraOf(trial.view, random);
  }
  return blocks;
}

/** Starts that are apart and starts that overlap take turns, each side in a random order. */
function alternated(trials, random) {
  const apart = shuffled(trials.filter(({ start }) => start > 0), random);
  const overlapping = shuffled(trials.filter(({ start }) => start <= 0), random);
  const result = [];
  while (apart.length || overlapping.length) result.push(...apart.splice(0, 1), ...overlapping.splice(0, 1));
  return result;
}

/** Practice shows the easiest trials: the largest gaps, on both sides in turn. */
function practice(plan, trials) {
  const gapOf = ({ gap, start }) => gap ?? start ?? 0;
  const easy = trials.filter(({ kind }) => !kind).sort((a, b) => Math.abs(gapOf(b)) - Math.abs(gapOf(a)));
  const sides = [easy.filter((trial) => gapOf(trial) > 0), easy.filter((trial) => gapOf(trial) <= 0)];
  return Array.from({ length: Math.min(plan.practice, easy.length) }, (_, i) => {
    const side = sides[i % 2].length ? sides[i % 2] : easy;
    return { ...side[(i >> 1) % side.length], kind: 'practice' };
  });
}

function cameraOf(view, random) {
  const [a, b] = [random(), random()];
  if (view.camera !== 'random') return { yaw: view.yaw, pitch: view.pitch };
  return { yaw: 80 * a - 40, pitch: 30 * b };
}
