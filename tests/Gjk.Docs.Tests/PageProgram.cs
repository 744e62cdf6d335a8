using System.Globalization;
using System.Reflection;
using System.Text;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;

namespace Gjk.Docs.Tests;

/// <summary>The C# blocks of a page as one program, in the order in which they are printed: a reader who copies them
/// one after the other gets the same. Only types move, to the end, where C# wants them.</summary>
internal static class PageProgram
{
    /// <summary>Printed after each block, so that the output falls into the parts that the page shows.</summary>
    private const char BlockEnd = '\u001e';

    /// <summary>Programs print to the one standard output of the process and stand in its one working folder: one runs
    /// at a time. They are compiled, and commands run, side by side.</summary>
    private static readonly object Process = new();

    /// <summary>The usings of a new console project, which a reader need not write.</summary>
    private const string ImplicitUsings =
        "using System; using System.Collections.Generic; using System.IO; using System.Linq;";

    /// <summary>What is read of them is kept in them, so they are the same for all programs.</summary>
    private static readonly MetadataReference[] References =
    [
        .. ((string)AppContext.GetData("TRUSTED_PLATFORM_ASSEMBLIES")!).Split(Path.PathSeparator)
            .Select(p => MetadataReference.CreateFromFile(p)),
    ];

    /// <summary>Compiles the blocks and returns what each of them prints.</summary>
    /// <param name="blocks">The blocks of one page.</param>
    /// <param name="folder">The working folder, in which the page's own files lie.</param>
    public static IReadOnlyList<string> Run(IReadOnlyList<CodeBlock> blocks, string folder)
    {
        MethodInfo main = Compile(blocks, OutputKind.ConsoleApplication, Join(blocks))!.EntryPoint!;
        var output = new StringWriter(CultureInfo.InvariantCulture) { NewLine = "\n" };
        lock (Process) Run(main, folder, output);
        return output.ToString().Split(BlockEnd)[..blocks.Count];
    }

    private static void Run(MethodInfo main, string folder, TextWriter output)
    {
        TextWriter console = Console.Out;
        string before = Environment.CurrentDirectory;
        try
        {
            Environment.CurrentDirectory = folder;
            Console.SetOut(output);
            main.Invoke(null, main.GetParameters().Length == 0 ? [] : [Array.Empty<string>()]);
        }
        finally
        {
            Console.SetOut(console);
            Environment.CurrentDirectory = before;
        }
    }

    /// <summary>Compiles blocks that need an engine to run: each is a file of its own.</summary>
    public static void CompileOnly(IReadOnlyList<CodeBlock> blocks) =>
        Compile(blocks, OutputKind.DynamicallyLinkedLibrary, blocks.Select(b => Script(b.Text)).ToArray());

    /// <summary>Lines without a type of their own stand in a frame of a script with two colliders.</summary>
    private static string Script(string text) =>
        SyntaxFactory.ParseCompilationUnit(text).Members.Any(m => m is not GlobalStatementSyntax)
            ? text
            : $"using Gjk.Unity; using UnityEngine; class Script : MonoBehaviour {{ Collider colliderA = null!, "
                + $"colliderB = null!; void Update() {{ {text} }} }}";

    private static string[] Join(IReadOnlyList<CodeBlock> blocks)
    {
        StringBuilder usings = new(ImplicitUsings + "\n"), statements = new(), types = new();
        foreach (CodeBlock block in blocks)
        {
            CompilationUnitSyntax unit = SyntaxFactory.ParseCompilationUnit(block.Text);
            foreach (UsingDirectiveSyntax directive in unit.Usings) usings.Append(directive.ToFullString());
            foreach (MemberDeclarationSyntax member in unit.Members)
                (member is GlobalStatementSyntax ? statements : types).Append(member.ToFullString());
            statements.Append($"\nConsole.Write('\\u{(int)BlockEnd:x4}');\n");
        }

        return [$"{usings}\n{statements}\n{types}"];
    }

    private static Assembly? Compile(IReadOnlyList<CodeBlock> blocks, OutputKind kind, string[] sources)
    {
        var options = new CSharpCompilationOptions(kind, nullableContextOptions: NullableContextOptions.Enable);
        CSharpCompilation compilation = CSharpCompilation.Create(
            "page",
            sources.Select(s => CSharpSyntaxTree.ParseText(s)),
            References,
            options);
        using var image = new MemoryStream();
        var result = compilation.Emit(image);
        var errors = result.Diagnostics.Where(d => d.Severity == DiagnosticSeverity.Error).ToList();
        Assert.True(errors.Count == 0, $"{string.Join("\n", errors)}\n{string.Join("\n---\n", sources)}");
        Assert.NotEmpty(blocks);
        return kind == OutputKind.ConsoleApplication ? Assembly.Load(image.ToArray()) : null;
    }
}
