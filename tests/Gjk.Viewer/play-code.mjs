// Compiles and runs the C# that the playground shows.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { dotnet } from './play-demo.mjs';

const PROJECT = `<Project Sdk="Microsoft.NET.Sdk">
  <PropertyGroup>
    <OutputType>Exe</OutputType>
    <TargetFramework>net10.0</TargetFramework>
    <TreatWarningsAsErrors>false</TreatWarningsAsErrors>
  </PropertyGroup>
  <ItemGroup>
    <Reference Include="${resolve('../../src/Gjk.Core/bin/Release/net10.0/Gjk.Core.dll')}" />
  </ItemGroup>
</Project>
`;

/** Prints a result as JSON; NaN is null there. */
const PRINT = `System.Console.WriteLine(System.Text.Json.JsonSerializer.Serialize(new object?[]
  { result.Status.ToString(), N(result.FIRST), N(result.SECOND), V(result.POINT), V(result.OTHER), V(result.Normal),
    result.Iterations }));`;

const HELPERS = `static object? N(float x) => float.IsNaN(x) ? null : x;
static object? V(System.Numerics.Vector3 v) => new object?[] { N(v.X), N(v.Y), N(v.Z) };
`;

/** The answers of the programs that the page shows for pairs of its bodies: a list for each question with its rows. All
 * of them are one program, because a build takes longer than what it does. */
export async function answersOfCode(page, folder, questions) {
  const codes = [];
  for (const [question, rows] of questions) {
    codes.push(...(await page.evaluate(([name, pairs]) => {
      const { bodies, codeOf } = window.__gjk;
      return pairs.map(([a, b]) => codeOf(name, [bodies[a], bodies[b]]));
    }, [question, rows.map(({ a, b }) => [a, b])])).map((code) => ({ code, isImpact: question === 'impact' })));
  }
  const usings = new Set(codes.flatMap(({ code }) => code.match(/^using .*;$/gm)));
  const bodies = codes.map(({ code, isImpact }) => (
    `{\n${code.replace(/^using .*;$/gm, '').replace('Console.WriteLine(result);', printOf(isImpact))}}\n`));
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'Program.cs'), [...usings, '', ...bodies, HELPERS].join('\n'));
  writeFileSync(join(folder, 'Code.csproj'), PROJECT);
  // The folder has no part in the project's own rules.
  for (const file of ['Directory.Build.props', 'Directory.Build.targets', 'Directory.Packages.props'])
    writeFileSync(join(folder, file), '<Project />\n');
  const lines = dotnet('run', '--project', folder).split('\n').filter((line) => line.startsWith('['));
  const answers = lines.map((line, i) => answerOf(line, codes[i].isImpact));
  return questions.map(([, rows]) => answers.splice(0, rows.length));
}

function printOf(isImpact) {
  const names = isImpact ? ['Fraction', 'Fraction', 'Point', 'Point'] : ['Distance', 'LowerBound', 'PointA', 'PointB'];
  return ['FIRST', 'SECOND', 'POINT', 'OTHER'].reduce((text, word, i) => text.replace(word, names[i]), PRINT);
}

function answerOf(line, isImpact) {
  const [status, first, second, a, b, normal, iterations] = JSON.parse(line)
    .map((x) => (Array.isArray(x) ? x.map((y) => y ?? NaN) : x));
  if (isImpact) return { status, fraction: first, point: a, normal, iterations };
  return { status, distance: first, lowerBound: second, pointA: a, pointB: b, normal, iterations };
}
