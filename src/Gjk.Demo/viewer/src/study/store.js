// What a person has answered. Every trial is in the browser's storage before the next one begins.

/** The columns of the data, as Study/Data/Trial.cs has them. */
const COLUMNS = [
  'plan', 'participant', 'trial', 'task', 'kind', 'pair', 'view', 'collider', 'start', 'gap', 'distance', 'answer',
  'seconds', 'pixels', 'arcminutes', 'record',
];

const field = (value) => {
  const text = value === null || value === undefined ? '' : String(value);
  return /[",\n\r]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

export class Store {
  constructor(plan) {
    this.plan = plan;
    this.key = `gjk-study ${plan.id}`;
    this.state = this.read() ?? { trials: [] };
  }

  /** What is stored, or null. */
  read() {
    try {
      return JSON.parse(localStorage.getItem(this.key));
    } catch {
      return null;
    }
  }

  get person() {
    return this.state.person;
  }

  get trials() {
    return this.state.trials;
  }

  /** Keeps facts about the person and the screen. Throws where the browser stores nothing. */
  keep(facts) {
    Object.assign(this.state, facts);
    localStorage.setItem(this.key, JSON.stringify(this.state));
  }

  add(row) {
    this.keep({ trials: [...this.trials, { plan: this.plan.id, participant: this.person, ...row }] });
  }

  clear() {
    localStorage.removeItem(this.key);
    this.state = { trials: [] };
  }

  csv() {
    return [COLUMNS, ...this.trials.map((row) => COLUMNS.map((name) => row[name]))]
      .map((row) => `${row.map(field).join(',')}\n`).join('');
  }

  json() {
    return JSON.stringify({ study: this.plan.name, ...this.state }, null, 1);
  }

  /** Saves both files through the browser's own dialog or folder. */
  save() {
    const name = `${this.plan.name} ${this.person}`.replace(/[^\w-]+/g, '-');
    download(`${name}.csv`, 'text/csv', this.csv());
    download(`${name}.json`, 'application/json', this.json());
  }
}

function download(name, type, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
