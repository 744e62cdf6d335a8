#!/usr/bin/env bash
# Writes a package's PublicAPI.Unshipped.txt anew (public-api.sh Gjk.Core): what the compiler says is public and not in
# its PublicAPI.Shipped.txt.
set -euo pipefail
cd "$(dirname "$0")/$1"
[ -f PublicAPI.Shipped.txt ] || echo '#nullable enable' > PublicAPI.Shipped.txt
echo '#nullable enable' > PublicAPI.Unshipped.txt
log=$(mktemp)
trap 'rm -f "$log"' EXIT
dotnet build -c Release -f net10.0 --no-incremental -v quiet -p:TreatWarningsAsErrors=false -p:ErrorLog="$log" > /dev/null
sed -n 's/^.*"APIName": "\(.*\)",$/\1/p' "$log" | sed 's/\\"/"/g' | LC_ALL=C sort -u >> PublicAPI.Unshipped.txt
