/** More columns than this do not fit a phone: there each cell of a row says its column. */
const MOST_COLUMNS = 3;

/** A Markdown plugin: a wide table gets a class, and each of its cells the name of its column. */
export function wideTables(markdown) {
  markdown.core.ruler.push('wide_tables', ({ tokens }) => {
    let heads = [], table = null, column = 0
    tokens.forEach((token, i) => {
      if (token.type === 'table_open') [heads, table] = [[], token]
      if (token.type === 'tr_open') column = 0
      if (token.type === 'th_open') heads.push(plain(tokens[i + 1]))
      if (token.type === 'thead_close' && heads.length > MOST_COLUMNS) table.attrJoin('class', 'wide')
      if (token.type === 'td_open') token.attrSet('data-label', heads[column++] ?? '')
    })
  })
}

const plain = ({ children }) => (children ?? []).map(({ content }) => content).join('')
