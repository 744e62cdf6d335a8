// A minimal test runner. It runs named checks in order, says how long each took, and prints a line with their counts.
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
