namespace Gjk.Docs.Tests;

/// <summary>What a page shows is what happens. A block of <c>csharp</c> is compiled and run, in order;
/// <c>csharp unity</c> is compiled against stubs of the engine. A block of <c>json</c> is a scene. A block of <c>sh</c>
/// is run. The block <c>text output</c> behind one of them is what it prints.</summary>
public class PageTests
{
    private const int Columns = 120;

    private static readonly string[] Languages = ["csharp", "csv", "json", "sh", "text", "bash"];

    /// <summary>Whether what the pages show is written anew, for a reviewer to look at.</summary>
    internal static bool UpdateOutputs => Environment.GetEnvironmentVariable("GJK_UPDATE_DOCS") == "1";

    public static TheoryData<string> All => Page.All;

    public static TheoryData<string> WithCSharp => Page.WithBlocks("csharp");

    public static TheoryData<string> WithCommands => Page.WithBlocks("sh");

    public static TheoryData<string> WithScenes => Page.WithBlocks("json");

    [Theory, MemberData(nameof(All))]
    public void BlocksHaveALanguageThatIsTested(string page) =>
        Assert.All(CodeBlock.Of(Page.Read(page)), b => Assert.Contains(b.Language, Languages));

    /// <summary>Only a block that prints has an output: another one would not be compared with anything.</summary>
    [Theory, MemberData(nameof(All))]
    public void OutputsStandBehindWhatPrints(string page)
    {
        IReadOnlyList<CodeBlock> blocks = CodeBlock.Of(Page.Read(page));
        for (int i = 0; i < blocks.Count; i++)
        {
            if (!blocks[i].Has("output")) continue;
            bool printed = i > 0 && (IsProgram(blocks[i - 1]) || blocks[i - 1].Language == "sh");
            Assert.True(printed, $"line {blocks[i].Line}");
        }
    }

    [Theory, MemberData(nameof(WithCSharp))]
    public void ProgramsCompileAndPrintWhatThePageShows(string page)
    {
        IReadOnlyList<CodeBlock> blocks = CodeBlock.Of(Page.Read(page));
        List<CodeBlock> engine = blocks.Where(b => b.Language == "csharp" && b.Has("unity")).ToList();
        if (engine.Count > 0) PageProgram.CompileOnly(engine);
        List<CodeBlock> program = blocks.Where(IsProgram).ToList();
        if (program.Count == 0) return;
        using var folder = new PageFolder(blocks);
        IReadOnlyList<string> outputs = PageProgram.Run(program, folder.Name);
        for (int i = program.Count - 1; i >= 0; i--) AssertOutput(page, program[i], outputs[i]);
    }

    [Theory, MemberData(nameof(WithCommands))]
    public void CommandsRunAndPrintWhatThePageShows(string page)
    {
        IReadOnlyList<CodeBlock> blocks = CodeBlock.Of(Page.Read(page));
        using var folder = new PageFolder(blocks);
        List<CodeBlock> commands = blocks.Where(b => b.Language == "sh").ToList();
        List<string> outputs = commands.Select(b => folder.Run(b.Text)).ToList();
        for (int i = commands.Count - 1; i >= 0; i--) AssertOutput(page, commands[i], outputs[i]);
    }

    [Theory, MemberData(nameof(WithScenes))]
    public void ScenesAreRead(string page)
    {
        foreach (CodeBlock scene in CodeBlock.Of(Page.Read(page)).Where(b => b.Language == "json"))
        {
            using var folder = new PageFolder([]);
            File.WriteAllText(Path.Combine(folder.Name, "scene.json"), scene.Text);
            folder.Run("gjk-demo query scene.json");
        }
    }

    /// <summary>Tables and links cannot be broken; what is made from comments is not wrapped.</summary>
    [Theory, MemberData(nameof(All))]
    public void TextIsWrapped(string page)
    {
        if (page.StartsWith("docs/api/", StringComparison.Ordinal)) return;
        string[] lines = Page.Read(page).Split('\n');
        Assert.DoesNotContain(lines, l => l.Length > Columns && !l.StartsWith('|') && !l.Contains("]("));
    }

    private static bool IsProgram(CodeBlock block) => block.Language == "csharp" && !block.Has("unity");

    private static void AssertOutput(string page, CodeBlock block, string output)
    {
        CodeBlock? next = CodeBlock.Of(Page.Read(page)).FirstOrDefault(b => b.Line > block.Line);
        if (next is null || !next.Has("output") || next.Text == output) return;
        Assert.True(UpdateOutputs, $"line {next.Line} of {page} shows\n{next.Text}\nbut the program prints\n{output}");
        List<string> lines = [.. Page.Read(page).Split('\n')];
        lines.RemoveRange(next.Line, next.Text.Count(c => c == '\n'));
        lines.InsertRange(next.Line, output.TrimEnd('\n').Split('\n'));
        File.WriteAllText(Page.PathOf(page), string.Join('\n', lines));
    }
}
