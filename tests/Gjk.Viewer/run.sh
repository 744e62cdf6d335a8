#!/usr/bin/env bash
# Opens the pages that the demo writes in headless Chromium and uses them. It installs what it needs if it can.
# Otherwise it prints that it was skipped and exits with 0. --no-build takes the Release build of the demo that is there.
# With GJK_LONG=1 also in Firefox, with pictures to look at, two whole studies and more traces. Screenshots are kept in
# TestResults/ beside this script.
set -euo pipefail
cd "$(dirname "$0")"

source ./tools.sh
# Firefox is a second opinion, and can be missing.
if [ "${GJK_LONG:-}" = 1 ]; then command -v firefox-esr firefox > /dev/null || ../install.sh firefox-esr || true; fi

if [ "${1:-}" != --no-build ]; then
  dotnet build -c Release -v quiet ../../src/Gjk.Demo/Gjk.Demo.csproj
  dotnet build -c Release -v quiet ../../src/Gjk.Web/Gjk.Web.csproj
fi
demo() { dotnet ../../src/Gjk.Demo/bin/Release/net10.0/gjk-demo.dll "$@"; }

# Those of the site may just be made.
mkdir -p TestResults
find TestResults -mindepth 1 -maxdepth 1 ! -name site -exec rm -rf {} +

# The bundles that the demo embeds are checked in. They must equal the bundles that their sources make.
viewer=../../src/Gjk.Demo/viewer
if [ -d $viewer/node_modules/esbuild ] || (cd $viewer && npm ci --silent > /dev/null 2>&1); then
  (cd $viewer && node build.mjs "$OLDPWD/TestResults") > /dev/null
else
  echo "skipped: esbuild cannot be installed from npm here, so the bundles are not compared with their sources"
fi

node scenes.mjs TestResults
trap 'kill $(jobs -p) 2> /dev/null || true' EXIT
# One browser looks at the views and traces, two beside it play and do the studies, while the views are being made.
bash play.sh > TestResults/play.log 2>&1 &
play=$!
bash study.sh > TestResults/study.log 2>&1 &
study=$!
{
  demo view --builtin cubes --out TestResults/cubes.html
  for scene in moving many; do
    demo view "TestResults/$scene.json" --out "TestResults/$scene.html"
    demo query "TestResults/$scene.json" --out "TestResults/$scene.csv"
  done
  demo view --builtin spheres --out TestResults/spheres.html
  for scene in empty two sweep; do
    demo view "TestResults/$scene.json" --out "TestResults/$scene.html"
  done
} &
views=$!
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
wait $views

status=0
node pages.mjs TestResults | tee TestResults/pages.log || status=1
wait $play || status=1
wait $study || status=1
cat TestResults/play.log TestResults/study.log
awk '/^[0-9]+ passed, [0-9]+ failed$/ { p += $1; f += $3 } END { print p " passed, " f " failed" }' TestResults/*.log
exit $status
