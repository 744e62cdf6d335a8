// Runs the demo, or any other program of .NET.
import { execFileSync } from 'node:child_process';

export const dotnet = (...args) => execFileSync('dotnet', args, { encoding: 'utf8' });

export const demo = (...args) => dotnet('../../src/Gjk.Demo/bin/Release/net10.0/gjk-demo.dll', ...args);
