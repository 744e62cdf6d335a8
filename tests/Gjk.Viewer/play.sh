#!/usr/bin/env bash
# The playground's part of run.sh, which has built the demo and found the browser.
set -euo pipefail
cd "$(dirname "$0")"
demo() { dotnet ../../src/Gjk.Demo/bin/Release/net10.0/gjk-demo.dll "$@"; }

node play-scenes.mjs TestResults
demo play --out TestResults/play.html
demo play --scene TestResults/shapes.json --out TestResults/play-shapes.html
demo play --mesh TestResults/parts.obj --out TestResults/play-parts.html
demo view TestResults/moving.json --live --out TestResults/live.html
demo query TestResults/shapes.json --out TestResults/shapes.csv
demo query TestResults/shapes.json --depth --out TestResults/shapes-depth.csv
demo cast TestResults/shapes.json --out TestResults/shapes-cast.csv
exec node play.mjs TestResults
