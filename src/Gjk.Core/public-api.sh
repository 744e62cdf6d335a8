#!/usr/bin/env bash
# Writes PublicAPI.Unshipped.txt anew from what the compiler says is public and not in PublicAPI.Shipped.txt.
set -euo pipefail
cd "$(dirname "$0")"
echo '#nullable enable' > PublicAPI.Unshipped.txt
log=$(mktemp)
trap 'rm -f "$log"' EXIT
dotnet build -c Release -f net10.0 --no-incremental -v quiet -p:TreatWarningsAsErrors=false -p:ErrorLog="$log" > /dev/null
sed -n 's/^.*"APIName": "\(.*\)",$/\1/p' "$log" | sed 's/\\"/"/g; s/\\u0026/\&/g; s/\\u003c/</g; s/\\u003e/>/g' | LC_ALL=C sort -u >> PublicAPI.Unshipped.txt
