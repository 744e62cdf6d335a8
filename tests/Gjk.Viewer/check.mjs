// A minimal test runner. It runs named checks in order, says how long each took, and prints a line with their counts.

/** Whether there is time for the same checks on more of the same kind: each page that draws costs seconds to open. */
export const isLong = process.env.GJK_LONG === '1';

let passed = 0,
  failed = 0;

export async function check(name, body) {
  const start = Date.now();
  try {
    await body();
    passed++;
    console.log(`ok ${name}, ${Date.now() - start} ms`);
  } catch (error) {
    failed++;
    console.log(`FAILED ${name}: ${error.message}`);
  }
}

export function finish() {
  console.log(`${passed} passed, ${failed} failed`);
  process.exitCode = failed || !passed ? 1 : 0;
}
