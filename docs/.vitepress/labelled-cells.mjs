/** A Markdown plugin for phones. A table of numbers gets a class, by which it scrolls beside its first column, so that
 *  its rows can be compared. In every other table each cell gets the name of its column, which it says there. A name
 *  in code may break after its points, so that a narrow cell does not break its words. */
export function labelledCells(markdown) {
  markdown.core.ruler.push('labelled_cells', ({ tokens }) => {
    let heads = [], column = 0, table
    tokens.forEach((token, i) => {
      if (token.type === 'table_open') [heads, table] = [[], token]
      if (token.type === 'tr_open') column = 0
      if (token.type === 'th_open') heads.push(plain(tokens[i + 1]))
      if (token.type === 'th_open' && /right/.test(token.attrGet('style'))) table.attrSet('class', 'numbers')
      if (token.type === 'td_open') token.attrSet('data-label', heads[column++] ?? '')
    })
  })
  const code = markdown.renderer.rules.code_inline
  markdown.renderer.rules.code_inline = (...all) => code(...all).replace(/(\w[.:_]+)(?=\w)/g, '$1<wbr>')
  // VitePress writes its own tag here, without the class.
  markdown.renderer.rules.table_open = (tokens, i, options, env, self) => {
    tokens[i].attrSet('tabindex', '0')
    return self.renderToken(tokens, i, options)
  }
}

const plain = ({ children }) => (children ?? []).map(({ content }) => content).join('')
