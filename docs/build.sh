#!/usr/bin/env bash
# Builds the site of the book into docs/site: the playground, made by the demo, and the pages, made by VitePress.
# --no-build takes the Release build of the demo that is there.
# Needs Node.js 18 or later. After the first run, which restores the packages, it needs no network.
# GJK_SITE_BASE: the folder that the site is served from, with slashes (default /).
# GJK_REPOSITORY_URL: where the sources can be read on the web; without it, links to sources are plain names.
set -euo pipefail
cd "$(dirname "$0")"

command -v npm > /dev/null || { echo "build.sh: Node.js is missing" >&2; exit 2; }
[ -d node_modules/vitepress ] || npm ci --silent
if [ "${1:-}" != --no-build ]; then
  dotnet build -c Release -v quiet --nologo ../src/Gjk.Demo/Gjk.Demo.csproj
  dotnet build -c Release -v quiet --nologo ../src/Gjk.Web/Gjk.Web.csproj
fi
mkdir -p public
cp ../src/Gjk.Core/Package/icon.svg example.scene.json scene.schema.json public/
dotnet ../src/Gjk.Demo/bin/Release/net10.0/gjk-demo.dll play --out public/play.html
npx --no-install vitepress build .
echo "The site is in docs/site. To look at it: npx --prefix docs vitepress preview docs"
