#!/usr/bin/env bash
# Makes all packages with pack.sh and checks them as their users meet them: what is in them, what their fields say, that
# a new project that has only the package compiles and runs the snippets of its README, and that the tool can be
# installed and used. --no-build packs the Release build of the solution that is there.
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD
export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

fail() { echo "package: $1" >&2; exit 1; }
unpack() { mkdir -p "$2" && { python3 -m zipfile -e "$1" "$2" 2> /dev/null || unzip -q "$1" -d "$2"; }; }
has_line() { grep -qF -- "$2" "$1" || fail "$(basename "$1") lacks $2"; }

# The contents and the fields of a package: its name and its targets.
check_package() {
  local name=$1 target file
  shift
  local package=$work/$name.package nuspec=$work/$name.package/$name.nuspec
  unpack "$(ls "$work"/feed/"$name".*.nupkg)" "$package"
  [ $# -eq 0 ] || unpack "$(ls "$work"/feed/"$name".*.snupkg)" "$work/$name.symbols"
  for target in "$@"; do
    for file in package/lib/$target/$name.{dll,xml} symbols/lib/$target/$name.pdb; do
      [ -s "$work/$name.$file" ] || fail "$name: $file is missing"
    done
  done
  [ -s "$package/icon.png" ] || fail "$name: the icon is missing"
  for field in '<title>' '<readme>README.md</readme>' '<icon>icon.png</icon>' '<license type="expression">MIT</license>' \
    "<releaseNotes>## [$version]" '<tags>' '<description>' '<repository type="git"'; do
    has_line "$nuspec" "$field"
  done

  local notes
  notes=$(sed -n '/<releaseNotes>/,/<\/releaseNotes>/p' "$nuspec" | wc -c)
  [ "$notes" -le 2000 ] || fail "$name: the release notes have $notes bytes, more than anybody reads"

  local readme=$package/README.md relative
  [ "$(wc -l < "$readme")" -le 80 ] || fail "$name: the README has more than 80 lines"
  relative=$(grep -nE '\]\(|<img|<a ' "$readme" | grep -vE '\]\(https://' || true)
  [ -z "$relative" ] || fail "$name: the README has links that only work in the repository: $relative"
}

version=$(dotnet msbuild src/Gjk.Core -getProperty:Version)
./pack.sh "$work/feed" "$@" > /dev/null
check_package Gjk.Core netstandard2.0 netstandard2.1 net10.0
check_package Gjk.Import netstandard2.1 net10.0
check_package gjk-demo
# A commit's packages have a version that those of the one before had not, and name each other by it.
packed=$(basename "$work"/feed/Gjk.Core.[0-9]*.nupkg .nupkg)
packed=${packed#Gjk.Core.}
if git describe --exact-match --tags --match 'v*' > /dev/null 2>&1; then
  [ "$packed" = "$version" ] || fail "the version is $packed on a tag"
else
  [[ "$packed" =~ -.*\.$(git rev-list --count HEAD)(\.[0-9]+)?$ ]] || fail "the version $packed is not that of this commit"
fi
has_line "$work/Gjk.Import.package/Gjk.Import.nuspec" "<dependency id=\"Gjk.Core\" version=\"$packed\""
for word in depth contacts casts rays concave; do has_line "$work/Gjk.Core.package/Gjk.Core.nuspec" "$word"; done
[ -s "$work/feed/com.gjk.core-$version.tgz" ] || fail "the package for Unity is missing"

# No path of this machine, in the fields or in the symbols.
leaks=$(grep -rlaF -- "$PWD" "$work"/*.package "$work"/*.symbols || true)
[ -z "$leaks" ] || fail "the folder of the repository is named in $leaks"

# The fields that follow the clone's remote, in a repository with nothing but the project file.
clone=$work/clone
mkdir -p "$clone/src/Gjk.Core"
cp Directory.*.props global.json "$clone"
cp src/Package.props "$clone/src"
cp src/Gjk.Core/Gjk.Core.csproj "$clone/src/Gjk.Core"
git -C "$clone" init -q
git -C "$clone" add .
git -C "$clone" -c user.name=check -c user.email=check@example.org commit -qm check
git -C "$clone" remote add origin unset

# Whether a package of the clone would publish this address if the remote were that one.
expect_published() {
  git -C "$clone" remote set-url origin "$1"
  local said
  said=$(dotnet msbuild "$clone/src/Gjk.Core/Gjk.Core.csproj" -nologo -p:TargetFramework=net10.0 -warnAsError \
    -t:GenerateSourceLinkFile -getProperty:PackageProjectUrl -getProperty:PublishRepositoryUrl | tr -d ' \n') \
    || fail "a warning or an error with the remote $1"
  [ "$said" = "{\"Properties\":{\"PackageProjectUrl\":\"$2\",\"PublishRepositoryUrl\":\"$3\"}}" ] \
    || fail "with the remote $1 the package says $said"
}

mkdir -p "$clone/src/Gjk.Core/obj/Debug/net10.0"
expect_published "$PWD" '' ''
expect_published https://user:secret@github.com/example/gjk.git https://github.com/example/gjk true
link=$(cat "$clone"/src/Gjk.Core/obj/*/net10.0/*.sourcelink.json)
commit=$(git -C "$clone" rev-parse HEAD)
[ "$link" = '{"documents":{"/_/*":"https://raw.githubusercontent.com/example/gjk/'"$commit"'/*"}}' ] \
  || fail "the symbols would find their sources by $link"

# A new project that knows the packed feed, and what is downloaded already for what a package needs.
downloads=$(dotnet nuget locals global-packages --list --force-english-output | sed 's/^[^:]*: //')
export NUGET_PACKAGES=$work/packages
run_readme() {
  local name=$1 app=$work/$1.app
  dotnet new console -o "$app" --no-restore > /dev/null
  cat > "$app/nuget.config" << CONFIG
<configuration>
  <packageSources><clear /><add key="pack" value="$work/feed" /><add key="downloads" value="$downloads" /></packageSources>
</configuration>
CONFIG
  awk '/^```/ { inside = /csharp/; next } inside' "$work/$name.package/README.md" > "$app/Program.cs"
  (
    cd "$app"
    dotnet add package "$name" --prerelease > add.log || { cat add.log >&2; fail "dotnet add package $name failed"; }
    dotnet run -c Release > run.log || { cat run.log >&2; fail "the snippets of $name's README do not compile or run"; }
  )
}

run_readme Gjk.Core
has_line "$work/Gjk.Core.app/run.log" 'Separated: 1.25 from <0.5, '
has_line "$work/Gjk.Core.app/run.log" ': they touch'
has_line "$work/Gjk.Core.app/run.log" '(0, 1): Separated, 0.25 from '
run_readme Gjk.Import
has_line "$work/Gjk.Import.app/run.log" 'left, right: 2'

# The tool, from a folder that is not this one, with all that it carries.
(
  mkdir "$work/tool" && cd "$work/tool"
  cp "$work/Gjk.Core.app/nuget.config" .
  dotnet tool install gjk-demo --tool-path . --prerelease > install.log || { cat install.log >&2; fail "no tool"; }
  ./gjk-demo example > scene.json
  ./gjk-demo query scene.json --names --out answers.csv 2> wrote
  has_line wrote ' pairs to answers.csv'
  [[ "$(./gjk-demo --version)" = "$version"* ]] || fail "the tool's version is $(./gjk-demo --version)"
  ./gjk-demo play --out play.html 2> /dev/null || fail "the tool lacks the library for browsers"
)

# The package for npm in Node.js, where that is there.
if command -v npm > /dev/null; then
  (
    mkdir "$work/npm" && cd "$work/npm"
    echo '{ "type": "module" }' > package.json
    npm install --silent --offline --no-audit --no-fund "$work/feed/gjk-core-$packed.tgz" || fail "npm install failed"
    cp "$root/tests/Gjk.Package/npm.mjs" .
    node npm.mjs || fail "the package for npm does not work"
  )
else
  echo "package: no npm, so gjk-core was not tried"
fi
(unset NUGET_PACKAGES; bash "$root/tests/Gjk.Package/baseline.sh" "$work/feed")
echo "package: $(cd "$work/feed" && ls -- *.nupkg *.tgz | xargs) are complete and work"
