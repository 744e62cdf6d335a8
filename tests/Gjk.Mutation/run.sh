#!/usr/bin/env bash
# Would the tests notice a wrong line? Changes the library one place at a time; see Program.cs for the options.
# All of Solvers, Simplex, Contacts and Minkowski, for hours, with GJK_LONG=1; a sample of 300 without.
set -euo pipefail
cd "$(dirname "$0")"

sample=()
if [ "${GJK_LONG:-}" != 1 ]; then sample=(--sample 300); fi
dotnet build -c Release -v quiet ../Gjk.Core.Tests/Gjk.Core.Tests.csproj -p:RunAnalyzers=false
dotnet build -c Release -v quiet Gjk.Mutation.csproj
exec bin/Release/net10.0/gjk-mutation run --repository ../.. "${sample[@]}" "$@"
