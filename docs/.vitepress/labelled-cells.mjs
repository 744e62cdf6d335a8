/** A Markdown plugin: each cell of a table gets the name of its column, which it says on a phone. */
export function labelledCells(markdown) {
  markdown.core.ruler.push('labelled_cells', ({ tokens }) => {
    let heads = [], column = 0
    tokens.forEach((token, i) => {
      if (token.type === 'table_open') heads = []
      if (token.type === 'tr_open') column = 0
      if (token.type === 'th_open') heads.push(plain(tokens[i + 1]))
      if (token.type === 'td_open') token.attrSet('data-label', heads[column++] ?? '')
    })
  })
}

const plain = ({ children }) => (children ?? []).map(({ content }) => content).join('')
