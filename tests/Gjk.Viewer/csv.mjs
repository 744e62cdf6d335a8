import { readFileSync } from 'node:fs';

/** The rows of `gjk-demo query`, each cell a number where it is one. */
export function readCsv(file) {
  const [head, ...lines] = readFileSync(file, 'utf8').trimEnd().split('\n');
  const names = head.split(',');
  const value = (cell) => (cell !== '' && !Number.isNaN(Number(cell)) ? Number(cell) : cell);
  return lines.map((line) => Object.fromEntries(line.split(',').map((cell, i) => [names[i], value(cell)])));
}
