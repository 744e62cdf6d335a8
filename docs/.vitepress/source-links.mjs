import path from 'node:path'

// Where the repository can be read on the web, without a slash at the end. Unknown, a link to a source file becomes its
// name with its path.
const repository = process.env.GJK_REPOSITORY_URL

/** Turns links from a page to files outside of docs/ into links to the repository, or into plain names. */
export function sourceLinks(md) {
  md.core.ruler.push('source-links', state => {
    const page = state.env.relativePath
    if (!page) return
    for (const block of state.tokens) {
      for (const [index, token] of (block.children ?? []).entries()) {
        if (token.type === 'link_open') rewrite(token, closing(block.children, index), page)
      }
    }
  })
}

function closing(tokens, index) {
  return tokens.slice(index).find(t => t.type === 'link_close')
}

function rewrite(open, close, page) {
  const target = open.attrGet('href')
  if (/^[a-z]+:|^#/.test(target)) return
  const file = path.posix.join('docs', path.posix.dirname(page), target)
  if (file.startsWith('docs/')) return
  if (repository) {
    open.attrSet('href', `${repository}/blob/main/${file}`)
    return
  }
  open.type = close.type = 'html_inline'
  open.content = `<span class="source" title="${file}">`
  close.content = '</span>'
}
