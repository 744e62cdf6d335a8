using System.Globalization;
using System.IO;
using System.Security.Cryptography;
using System.Text;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using Microsoft.CodeAnalysis.Text;

namespace Gjk.Mutation;

/// <summary>Compiles the library with all of its mutants, which a static field turns on one at a time.</summary>
internal sealed class MutatedBuild
{
    /// <summary>The switch. A recording build also notes which places were reached.</summary>
    private const string Switch = """
        namespace Gjk.Core;

        internal static class Mutation
        {
            public static int Active;
        #if RECORD
            public static readonly byte[] Reached = new byte[1 << 17];

            public static bool Told(int number, bool value)
            {
                Reached[number] |= value ? (byte)1 : (byte)2;
                return value;
            }
        #endif

            [System.Runtime.CompilerServices.MethodImpl(
                System.Runtime.CompilerServices.MethodImplOptions.AggressiveInlining)]
            public static bool Is(int number)
            {
        #if RECORD
                Reached[number] = 1;
        #endif
                return Active == number;
            }
        }
        """;

    private static readonly string[] Symbols =
    [
        "TRACE", "RELEASE", "NET", "NETCOREAPP", "NET10_0", "NET5_0_OR_GREATER", "NET6_0_OR_GREATER",
        "NET7_0_OR_GREATER", "NET8_0_OR_GREATER", "NET9_0_OR_GREATER", "NET10_0_OR_GREATER",
        "NETCOREAPP3_0_OR_GREATER", "NETCOREAPP3_1_OR_GREATER",
    ];

    private readonly string _root;
    private readonly Regex _folders;
    private readonly string _refusedFile, _key;
    private readonly HashSet<int> _refused = [];

    /// <param name="root">The folder src/Gjk.Core.</param>
    /// <param name="folders">Where all mutants are made; elsewhere only those of constants.</param>
    /// <param name="work">Keeps what did not compile, while the sources stay as they are.</param>
    public MutatedBuild(string root, Regex folders, string work)
    {
        (_root, _folders) = (root, folders);
        Directory.CreateDirectory(work);
        _refusedFile = Path.Combine(work, "refused.txt");
        string text = folders + string.Concat(Sources().Select(File.ReadAllText));
        _key = Convert.ToHexString(SHA256.HashData(Encoding.UTF8.GetBytes(text)));
        if (File.Exists(_refusedFile) && File.ReadLines(_refusedFile).First() == _key)
            _refused = [.. File.ReadLines(_refusedFile).Skip(1).Select(Number)];
    }

    /// <summary>All that compile.</summary>
    public List<Mutant> Mutants { get; private set; } = [];

    /// <summary>How many do not.</summary>
    public int Refused => _refused.Count;

    /// <summary>Writes Gjk.Core.dll.</summary>
    /// <param name="path">Where.</param>
    /// <param name="isRecording">Whether it notes what is reached.</param>
    /// <param name="onlyBranches">No mutants: conditions tell which way they went.</param>
    public void Write(string path, bool isRecording, bool onlyBranches = false)
    {
        CSharpParseOptions options = CSharpParseOptions.Default.WithLanguageVersion(LanguageVersion.CSharp13)
            .WithPreprocessorSymbols(isRecording ? [.. Symbols, "RECORD"] : Symbols);
        SyntaxTree Parse(string text, string file) =>
            CSharpSyntaxTree.ParseText(SourceText.From(text, Encoding.UTF8), options, file);
        List<SyntaxTree> extra =
            [Parse(Switch, "Mutation.cs"), Parse(Attributes(), "Attributes.cs"), Parse(Usings(), "Usings.cs")];
        List<SyntaxTree> trees = Sources().Select(file => Parse(File.ReadAllText(file), file)).ToList();
        trees = trees.Select(t => t.WithRootAndOptions(Schemata.Parted(t.GetRoot()), options)).ToList();
        CSharpCompilation original = Compilation([.. trees, .. extra]);
        while (true)
        {
            var mutants = new List<Mutant>();
            List<SyntaxTree> changed = trees.Select(
                t => onlyBranches ? Telling(t, mutants, options) : Rewritten(t, original, mutants, options)).ToList();
            using var image = new MemoryStream();
            var result = Compilation([.. changed, .. extra]).Emit(image);
            if (result.Success)
            {
                Mutants = mutants.Where(m => !_refused.Contains(m.Id)).ToList();
                RequireAll(changed);
                File.WriteAllBytes(path, image.ToArray());
                File.WriteAllLines(_refusedFile, _refused.Select(n => $"{n}").Prepend(_key));
                return;
            }

            int before = _refused.Count;
            foreach (Diagnostic error in result.Diagnostics.Where(d => d.Severity == DiagnosticSeverity.Error))
                Refuse(error, mutants);
            if (_refused.Count == before)
                throw new InvalidOperationException(string.Join('\n', result.Diagnostics.Take(20)));
        }
    }

    /// <summary>A mutant that is listed and stands in no source would count as one that no test reaches.</summary>
    private void RequireAll(IEnumerable<SyntaxTree> changed)
    {
        HashSet<int> written = [.. changed.SelectMany(t => t.GetRoot().GetAnnotatedNodes(Schemata.Mark)).SelectMany(
            n => n.GetAnnotations(Schemata.Mark)).SelectMany(m => m.Data!.Split(',')).Select(Number)];
        Mutant[] lost = [.. Mutants.Where(m => !written.Contains(m.Id))];
        if (lost.Length > 0)
            throw new InvalidOperationException($"{lost.Length} are in no source:\n{string.Join('\n', lost.Take(20))}");
    }

    /// <summary>The directives that the project file has for all files.</summary>
    private string Usings() => string.Concat(
        XDocument.Load(Path.Combine(_root, "Gjk.Core.csproj")).Descendants("Using")
            .Select(u => $"global using {u.Attribute("Include")!.Value};\n"));

    /// <summary>The name by which the tests refer to the library: its version, its key, and theirs.</summary>
    private string Attributes()
    {
        XDocument shared = XDocument.Load(Path.Combine(_root, "..", "..", "Directory.Build.props"));
        string version = shared.Descendants("Version").Single().Value.Split('-')[0];
        string key = shared.Descendants("InternalsVisibleTo").Single().Attribute("Key")!.Value;
        return $"""
            [assembly: System.Runtime.CompilerServices.InternalsVisibleTo("Gjk.Core.Tests, PublicKey={key}")]
            [assembly: System.Reflection.AssemblyVersion("{version}.0")]
            [assembly: System.Runtime.Versioning.TargetFramework(".NETCoreApp,Version=v10.0")]
            """;
    }

    private IEnumerable<string> Sources() =>
        Directory.EnumerateFiles(_root, "*.cs", SearchOption.AllDirectories)
            .Where(f => !Regex.IsMatch(Path.GetRelativePath(_root, f), @"^(obj|bin)[\\/]"))
            .Order(StringComparer.Ordinal);

    private SyntaxTree Rewritten(
        SyntaxTree tree, CSharpCompilation original, List<Mutant> mutants, CSharpParseOptions options)
    {
        string file = Path.GetRelativePath(_root, tree.FilePath).Replace('\\', '/');
        var schemata = new Schemata(file, original.GetSemanticModel(tree), !_folders.IsMatch(file), _refused, mutants);
        return tree.WithRootAndOptions(schemata.Visit(tree.GetRoot()), options);
    }

    private SyntaxTree Telling(SyntaxTree tree, List<Mutant> branches, CSharpParseOptions options)
    {
        string file = Path.GetRelativePath(_root, tree.FilePath).Replace('\\', '/');
        if (!_folders.IsMatch(file)) return tree;
        return tree.WithRootAndOptions(new Branches(file, _refused, branches).Visit(tree.GetRoot()), options);
    }

    /// <summary>Leaves out what an error comes from: the place around it, a constant in it, or a variable's.</summary>
    private void Refuse(Diagnostic error, List<Mutant> mutants)
    {
        SyntaxNode node = error.Location.SourceTree!.GetRoot().FindNode(error.Location.SourceSpan, false, true);
        SyntaxNode? place = node.AncestorsAndSelf().FirstOrDefault(n => n.HasAnnotations(Schemata.Mark));
        SyntaxNode? method = node.AncestorsAndSelf().FirstOrDefault(n => n is MemberDeclarationSyntax);
        bool isFlow = error.Id is "CS0165" or "CS0269" or "CS0177" or "CS0171" or "CS0170" or "CS0161";
        if (isFlow && method is not null)
        {
            string name = Regex.Match(error.GetMessage(), "'([^'.]*)").Groups[1].Value;
            foreach (SyntaxNode marked in method.GetAnnotatedNodes(Schemata.Mark))
                if (Regex.IsMatch(marked.ToString(), $@"\b{Regex.Escape(name)}\b")) Refuse(marked);
            return;
        }

        if (place is not null and not PropertyDeclarationSyntax)
        {
            Refuse(place);
            return;
        }

        foreach (IdentifierNameSyntax name in node.DescendantNodesAndSelf().OfType<IdentifierNameSyntax>())
        {
            string text = name.Identifier.ValueText;
            foreach (Mutant m in mutants.Where(m => m.Operator.StartsWith("constant", StringComparison.Ordinal)))
                if (m.Changed.StartsWith(text + " ", StringComparison.Ordinal)) _refused.Add(m.Id);
        }

        foreach (SyntaxNode part in place is null ? node.GetAnnotatedNodes(Schemata.Mark) : [place]) Refuse(part);
    }

    private void Refuse(SyntaxNode place)
    {
        foreach (SyntaxAnnotation mark in place.GetAnnotations(Schemata.Mark))
            foreach (string number in mark.Data!.Split(',')) _refused.Add(Number(number));
    }

    private static int Number(string text) => int.Parse(text, CultureInfo.InvariantCulture);

    private CSharpCompilation Compilation(IEnumerable<SyntaxTree> trees)
    {
        string platform = (string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!;
        string runtime = Path.GetDirectoryName(typeof(object).Assembly.Location)!;
        IEnumerable<MetadataReference> references = platform.Split(Path.PathSeparator)
            .Where(p => p.StartsWith(runtime, StringComparison.Ordinal))
            .Select(p => MetadataReference.CreateFromFile(p));
        var options = new CSharpCompilationOptions(
            OutputKind.DynamicallyLinkedLibrary,
            optimizationLevel: OptimizationLevel.Release,
            allowUnsafe: true,
            cryptoKeyFile: Path.GetFullPath(Path.Combine(_root, "..", "..", "Gjk.snk")),
            publicSign: true,
            deterministic: true,
            nullableContextOptions: NullableContextOptions.Enable,
            generalDiagnosticOption: ReportDiagnostic.Suppress);
        return CSharpCompilation.Create("Gjk.Core", trees, references, options);
    }
}
