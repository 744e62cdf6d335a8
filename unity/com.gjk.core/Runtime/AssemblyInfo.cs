using System.Runtime.CompilerServices;

[assembly: InternalsVisibleTo("Gjk.Unity.Tests")]
[assembly: InternalsVisibleTo("Gjk.Unity.Editor")]
