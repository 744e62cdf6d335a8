# What the browser tests need: Node.js, Chromium and playwright-core, installed if they can be. For other scripts, and
# by itself.
cd "$(dirname "${BASH_SOURCE[0]}")"

skip() {
  echo "skipped: $1"
  exit 0
}

find_browser() {
  CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
  [ -n "$CHROMIUM" ]
}

command -v node > /dev/null && command -v npm > /dev/null || ../install.sh nodejs npm \
  || skip "Node.js is not installed and cannot be installed here"
[ "$(node -p 'process.versions.node.split(".")[0]')" -ge 18 ] \
  || skip "Node.js here is older than playwright-core needs (18)"
find_browser || { ../install.sh chromium && find_browser; } \
  || skip "Chromium is not installed and cannot be installed here"
[ -d node_modules/playwright-core ] || npm ci --silent > /dev/null 2>&1 \
  || skip "playwright-core cannot be installed from npm here"
export CHROMIUM
