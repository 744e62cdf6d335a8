// What the pages say, read as a user reads it.

export const counts = (page) => page.evaluate(() => window.__gjk.counts());

export const text = (page, selector) => page.locator(selector).innerText();

/** The visible rows of the list of pairs, each as its cells. */
export const rows = (page) =>
  page.locator('.rows .row').evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent)));

/** The numbers of a table of steps. */
export const numbers = (table) =>
  table
    .locator('tbody tr')
    .evaluateAll((all) => all.map((row) => [...row.children].map((cell) => Number(cell.textContent))));

export const button = (page, name) => page.getByRole('button', { name, exact: true });
