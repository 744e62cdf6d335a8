// Reads the default plan and writes one of a pair in two views: plain and still, and with a texture and turning.
import { readFileSync, writeFileSync } from 'node:fs';

const plan = JSON.parse(readFileSync(0, 'utf8'));
const [view] = plan.views;
Object.assign(plan, {
  name: 'looks', pairs: plan.pairs.slice(0, 1), practice: 0, catch: { trials: 0, gap: 0.3 },
  views: [{ ...view, name: 'plain', camera: 'fixed', texture: false, shadow: false },
    { ...view, name: 'turning', camera: 'turning', texture: true, shadow: false }],
});
delete plan.constant;
delete plan.mismatch;
writeFileSync(1, JSON.stringify(plan));
