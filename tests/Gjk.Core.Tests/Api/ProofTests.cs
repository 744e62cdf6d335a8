using System.Globalization;
using System.Reflection;
using System.Text.RegularExpressions;

namespace Gjk.Core.Tests.Api;

/// <summary>The proofs of proofs/ are about the constants that the library has: a script says which in a comment, and
/// begins with the same number. proofs/run.sh has them proved.</summary>
public partial class ProofTests
{
    private const BindingFlags Constants =
        BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    /// <summary>What is smaller is not about rounding in double, what is larger neither.</summary>
    private const double LeastError = 1e-33, MostError = 1e-12;

    private static readonly string Folder = Path.Combine(ProjectFolder.Root, "proofs");

    public static TheoryData<string> Scripts =>
        [.. Directory.GetFiles(Folder, "*.g").Select(f => Path.GetFileName(f)).Order(StringComparer.Ordinal)];

    [Theory]
    [MemberData(nameof(Scripts))]
    public void TheScriptHasTheLibrarysConstant(string script)
    {
        string text = File.ReadAllText(Path.Combine(Folder, script));
        Match[] said = [.. ConstantLine().Matches(text).Cast<Match>()];
        bool isStep = text.Contains("# supports: ", StringComparison.Ordinal);
        Assert.True(said.Length > 0 || isStep, "It names no constant.");
        foreach (Match m in said)
        {
            Group given = m.Groups["variable"];
            string name = given.Success ? given.Value : FirstDefinition().Match(text).Groups[1].Value;
            double constant = ValueOf(m.Groups["type"].Value, m.Groups["name"].Value);
            Assert.True(constant == Number(m.Groups["value"].Value), $"{m.Value}: the library has {constant:R}.");
            Match definition = Regex.Match(text, $@"^{name} = (?<value>[^;]+);", RegexOptions.Multiline);
            Assert.True(constant == Number(definition.Groups["value"].Value), $"{m.Value}: {definition.Value}");
        }
    }

    [Theory]
    [MemberData(nameof(Scripts))]
    public void TheScriptSaysWhatItIsAbout(string script)
    {
        string text = File.ReadAllText(Path.Combine(Folder, script));
        Assert.Matches("(?m)^# assumed: ", text);
        Assert.Matches(@"(?m)^# control: (\w+) = [^;]+;$", text);
        string code = Regex.Match(text, "(?m)^# code: (.*(\n#   .*)*)").Groups[1].Value;
        string[] files = [.. Regex.Matches(code, @"\w+(\.\w+)?\.cs").Select(m => m.Value)];
        Assert.NotEmpty(files);
        string[] sources = [.. ProjectFolder.Sources("src/Gjk.Core").Select(f => Path.GetFileName(f))];
        Assert.All(files, f => Assert.Contains(f, sources));
        Assert.Contains($"[{script}]({script})", File.ReadAllText(Path.Combine(Folder, "README.md")));
        foreach (string line in text.Split('\n')) Assert.True(line.Length <= 120, line);
    }

    /// <summary>Every constant that is as small as a few roundings has a proof, or a line that says why it has
    /// none.</summary>
    [Fact]
    public void EveryErrorConstantIsNamed()
    {
        string page = File.ReadAllText(Path.Combine(Folder, "README.md"));
        string[] errors = [.. from t in BuildUnderTest.Library.GetTypes()
                              from f in t.GetFields(Constants)
                              where f.IsLiteral && f.FieldType == typeof(double)
                              where IsError((double)f.GetRawConstantValue()!)
                              select $"{NameOf(t)}.{f.Name}"];
        Assert.True(errors.Length > 30, $"only {errors.Length} constants were found");
        Assert.All(errors, e => Assert.Contains($"`{e}`", page));
    }

    [Theory]
    [InlineData("16 * 2^-53", 16.0 / (1L << 53))]
    [InlineData("16b-53", 16.0 / (1L << 53))]
    [InlineData("1 + 32b-53", 1 + 32.0 / (1L << 53))]
    [InlineData("1e7 * 64b-53", 1e7 * (64.0 / (1L << 53)))]
    [InlineData("1e-5", 1e-5)]
    public void NumbersAreReadAsTheyAreMeant(string text, double value) => Assert.Equal(value, Number(text));

    private static bool IsError(double value)
    {
        double error = value is > 0.5 and < 1.5 ? Math.Abs(value - 1) : value;
        return error is > LeastError and < MostError;
    }

    private static double ValueOf(string type, string name)
    {
        FieldInfo field = BuildUnderTest.Library.GetTypes().Where(t => NameOf(t) == type)
            .Select(t => t.GetField(name, Constants)).Single(f => f is not null)!;
        return (double)field.GetRawConstantValue()!;
    }

    private static string NameOf(Type type) => type.Name.Split('`')[0];

    /// <summary>Sums of products of decimal numbers and of n times a power of two, as comments and Gappa write
    /// them.</summary>
    private static double Number(string text) => text.Split(" + ").Sum(
        term => term.Split(" * ").Select(Factor).Aggregate((a, b) => a * b));

    private static double Factor(string text)
    {
        Match power = PowerOfTwo().Match(text);
        return power.Success
            ? Math.ScaleB(Decimal(power.Groups["mantissa"].Value), -Exponent(power.Groups["exponent"].Value))
            : Decimal(text);
    }

    private static double Decimal(string text) =>
        text == "2^" ? 1 : double.Parse(text, NumberStyles.Float, CultureInfo.InvariantCulture);

    private static int Exponent(string text) => int.Parse(text, CultureInfo.InvariantCulture);

    [GeneratedRegex(
        @"^# constant: (?<type>\w+)\.(?<name>\w+) = (?<value>[^(\n]+?)( \((?<variable>\w+)\))?$",
        RegexOptions.Multiline)]
    private static partial Regex ConstantLine();

    [GeneratedRegex(@"^(\w+) = ", RegexOptions.Multiline)]
    private static partial Regex FirstDefinition();

    [GeneratedRegex(@"^(?<mantissa>2\^|\d+)b?-(?<exponent>\d+)$")]
    private static partial Regex PowerOfTwo();
}
