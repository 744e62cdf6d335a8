#!/usr/bin/env bash
# Builds the site of the book and opens every page of it in headless Chromium. It installs what it needs if it can.
# Otherwise it prints that it was skipped and exits with 0. Screenshots are kept in TestResults/site beside this script.
# --no-build takes the Release build of the demo that is there.
set -euo pipefail
cd "$(dirname "$0")"
source ./tools.sh

[ -d ../../docs/node_modules/vitepress ] || (cd ../../docs && npm ci --silent > /dev/null 2>&1) \
  || skip "VitePress cannot be installed from npm here"
../../docs/build.sh "$@"
rm -rf TestResults/site
mkdir -p TestResults/site
exec node site.mjs ../../docs/site TestResults/site
