#!/usr/bin/env bash
# Opens the pages that the demo writes in headless Chromium and uses them. It installs what it needs if it can.
# Otherwise it prints that it was skipped and exits with 0. Screenshots are kept in TestResults/ beside this script.
set -euo pipefail
cd "$(dirname "$0")"

skip() {
  echo "skipped: $1"
  exit 0
}

install_packages() {
  command -v apt-get > /dev/null || return 1
  apt-get install -y --no-install-recommends "$@" > /dev/null 2>&1 && return 0
  apt-get update > /dev/null 2>&1 && apt-get install -y --no-install-recommends "$@" > /dev/null 2>&1
}

find_browser() {
  CHROMIUM=${CHROMIUM:-$(command -v chromium || command -v chromium-browser || command -v google-chrome || true)}
  [ -n "$CHROMIUM" ]
}

command -v node > /dev/null && command -v npm > /dev/null || install_packages nodejs npm \
  || skip "Node.js is not installed and cannot be installed here"
[ "$(node -p 'process.versions.node.split(".")[0]')" -ge 18 ] \
  || skip "Node.js here is older than playwright-core needs (18)"
find_browser || { install_packages chromium && find_browser; } \
  || skip "Chromium is not installed and cannot be installed here"
[ -d node_modules/playwright-core ] || npm ci --silent > /dev/null 2>&1 \
  || skip "playwright-core cannot be installed from npm here"
export CHROMIUM

dotnet build -c Release -v quiet ../../src/Gjk.Demo/Gjk.Demo.csproj
demo() { dotnet ../../src/Gjk.Demo/bin/Release/net10.0/gjk-demo.dll "$@"; }

rm -rf TestResults
mkdir TestResults

# The bundle that the demo embeds is checked in. It must equal the bundle that its sources make.
viewer=../../src/Gjk.Demo/viewer
if [ -d $viewer/node_modules/esbuild ] || (cd $viewer && npm ci --silent > /dev/null 2>&1); then
  (cd $viewer && node build.mjs "$OLDPWD/TestResults/viewer.js") > /dev/null
else
  echo "skipped: esbuild cannot be installed from npm here, so the bundle is not compared with its sources"
fi

node scenes.mjs TestResults
demo view --builtin cubes --out TestResults/cubes.html
demo view --builtin spheres --out TestResults/spheres.html
for scene in moving many; do
  demo view "TestResults/$scene.json" --out "TestResults/$scene.html"
  demo query "TestResults/$scene.json" --out "TestResults/$scene.csv"
done
for scene in empty two; do
  demo view "TestResults/$scene.json" --out "TestResults/$scene.html"
done
demo view TestResults/sweep.json --out TestResults/sweep.html
demo trace --builtin cubes --pair 0,5 --out TestResults/trace-apart.html
demo trace --builtin cubes --pair 10,11 --out TestResults/trace-hit.html
demo trace TestResults/moving.json --pair 2,5 --out TestResults/trace-round.html
demo trace TestResults/deep.json --pair 0,1 --out TestResults/trace-deep.html
demo trace TestResults/deep.json --pair 0,2 --out TestResults/trace-margin.html
demo trace TestResults/two.json --pair 0,1 --out TestResults/trace-one.html
demo trace TestResults/huge.json --pair 0,1 --out TestResults/trace-huge.html
for example in loop wrong; do
  demo trace --example $example --out TestResults/$example.html
done
demo query TestResults/deep.json --depth --out TestResults/deep.csv
exec node pages.mjs TestResults
