#!/usr/bin/env bash
# The study's part of run.sh, which has built the demo and found the browser.
set -euo pipefail
cd "$(dirname "$0")"
demo() { dotnet ../../src/Gjk.Demo/bin/Release/net10.0/gjk-demo.dll "$@"; }

# The default study, whole, but nobody needs to see each view for so long.
short='s|"cross": 300, "milliseconds": 500, "mask": 300|"cross": 0, "milliseconds": 20, "mask": 0|'
demo study plan | sed "$short" > TestResults/study-plan.json
demo study page --plan TestResults/study-plan.json --out TestResults/study.html
# The same with one answer to each gap, where a whole study would show no more.
sed '/"constant": {/s/"repeats": 4/"repeats": 1/' TestResults/study-plan.json > TestResults/study-short-plan.json
demo study page --plan TestResults/study-short-plan.json --out TestResults/study-short.html
# Two looks that the default plan does not have: its views, one with a texture and a camera that turns.
node study-looks.mjs < TestResults/study-plan.json > TestResults/study-looks.json
demo study page --plan TestResults/study-looks.json --out TestResults/study-looks.html
exec node study.mjs TestResults
