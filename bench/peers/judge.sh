#!/usr/bin/env bash
# Asks the engines that build.sh builds for the pairs of tests/Cases, judges their answers and this library's, and prints
# a table: engine, question, pairs, wrong, of these without an answer, wrong beyond 1e-5 of the size. Expects a Release
# build of bench and src/Gjk.Demo. The engines' own answers go to the folder that is given.
set -euo pipefail
out=$(mkdir -p "${1:?usage: judge.sh FOLDER}" && cd "$1" && pwd)
cd "$(dirname "$0")/../.."
demo() { dotnet src/Gjk.Demo/bin/Release/net10.0/gjk-demo.dll "$@"; }
families() { (cd tests/Cases && ls ./*.expected.csv | sed 's|^./||; s|.expected.csv$||' | grep -vE '^(concave|cast)_'); }

dotnet bench/bin/Release/net10.0/Gjk.Bench.dll --peers --answers "$out"
for family in $(families); do
  depth=()
  case $family in depth_*) depth=(--depth) ;; esac
  demo query "tests/Cases/$family.json" "${depth[@]}" --out "$out/gjk.$family.csv"
done

# The last line of a table: | all | pairs | wrong | no row | no answer | ...
judge() { demo judge "$1" "$2.json" "$2.expected.csv" --lines 0 "${@:3}" | tail -n 1 | tr -d ' ' | cut -d '|' -f 3,4,6; }
for answers in "$out"/*.csv; do
  name=$(basename "$answers" .csv)
  case $name in *.depth_*) question=depth ;; *) question=distance ;; esac
  strict=$(judge "$answers" "tests/Cases/${name#*.}" || true)
  loose=$(judge "$answers" "tests/Cases/${name#*.}" --tolerance 1e-5 || true)
  echo "${name%%.*} $question $strict|$loose"
done | tr '|' ' ' | awk '
  { key = $1 "," $2; pairs[key] += $3; wrong[key] += $4; none[key] += $5; loose[key] += $7 }
  END { for (key in pairs) print key "," pairs[key] "," wrong[key] "," none[key] "," loose[key] }' | sort |
  sed '1i # tests/Cases; Bullet 3.24, libccd 2.1, FCL 0.7 and ODE 0.16 as Debian 12 packages them\nengine,question,pairs,wrong,no_answer,wrong_1e-5'
