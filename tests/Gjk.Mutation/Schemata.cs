using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using static Microsoft.CodeAnalysis.CSharp.SyntaxFactory;

namespace Gjk.Mutation;

/// <summary>Writes all mutants of a file into it at once: each place becomes a choice between its original and its
/// changes, by a number that is set while the tests run. So one build serves them all.</summary>
/// <remarks>Only the original carries the mutants of its own parts, or nested places would grow exponentially. A
/// condition that declares variables is changed by the operators ^, | and &amp;, of which the original is a part; one
/// that joins two loses the right one. What the compiler refuses (a constant where one must be, a variable that is not
/// always set) is left out: see <see cref="MutatedBuild"/>.</remarks>
internal sealed class Schemata(
    string file, SemanticModel model, bool onlyConstants, HashSet<int> refused, List<Mutant> mutants)
    : CSharpSyntaxRewriter
{
    /// <summary>Marks a place with the numbers of its mutants.</summary>
    public const string Mark = "mutants";

    /// <summary>Of the last comment: constants that share a declaration share it.</summary>
    private string[] _pins = [];

    public override SyntaxNode? VisitFieldDeclaration(FieldDeclarationSyntax node)
    {
        string type = node.Declaration.Type.ToString();
        string comment = node.GetLeadingTrivia().ToFullString();
        if (comment.Length > 0) _pins = PinnedBy(comment);
        string[] pins = _pins;
        bool isConstant = node.Modifiers.Any(SyntaxKind.ConstKeyword)
            && (type is "double" || (type is "int" or "float" && pins.Length > 0));
        if (!isConstant)
            return node.Modifiers.Any(SyntaxKind.ConstKeyword) ? node : base.VisitFieldDeclaration(node);

        // A constant cannot change while the tests run, a property can.
        VariableDeclaratorSyntax constant = node.Declaration.Variables[0];
        string value = constant.Initializer!.Value.ToString(), name = constant.Identifier.ValueText;
        int larger = Add("constant x 4", constant, constant.ToString(), $"{name} x 4", pins);
        int smaller = Add("constant / 4", constant, constant.ToString(), $"{name} / 4", pins);
        if (refused.Contains(larger)) return node;
        string modifiers = string.Join(" ", node.Modifiers.Where(m => !m.IsKind(SyntaxKind.ConstKeyword)));
        string choice = $"{Is(larger)} ? ({value}) * 4 : {Is(smaller)} ? ({value}) / 4 : ({value})";
        return Marked(
            ParseMemberDeclaration($"{modifiers} static {type} {name} => {choice};")!.WithTriviaFrom(node),
            [larger, smaller]);
    }

    /// <summary>Parts the constants that share a declaration; lines and comments stay as they are.</summary>
    public static SyntaxNode Parted(SyntaxNode root)
    {
        while (true)
        {
            FieldDeclarationSyntax? shared = root.DescendantNodes().OfType<FieldDeclarationSyntax>().FirstOrDefault(
                f => f.Declaration.Variables.Count > 1 && f.Modifiers.Any(SyntaxKind.ConstKeyword));
            if (shared is null) return root;
            root = root.ReplaceNode(shared, shared.Declaration.Variables.Select((v, i) => Part(shared, v, i)));
        }
    }

    private static FieldDeclarationSyntax Part(FieldDeclarationSyntax shared, VariableDeclaratorSyntax one, int index)
    {
        var variables = SingletonSeparatedList(one.WithoutTrivia());
        FieldDeclarationSyntax part = shared.WithDeclaration(shared.Declaration.WithVariables(variables));
        bool isLast = index == shared.Declaration.Variables.Count - 1;
        return part.WithLeadingTrivia(index == 0 ? shared.GetLeadingTrivia() : [])
            .WithTrailingTrivia(isLast ? shared.GetTrailingTrivia() : []);
    }

    public override SyntaxNode? VisitAttributeList(AttributeListSyntax node) => node;

    public override SyntaxNode? VisitCaseSwitchLabel(CaseSwitchLabelSyntax node) => node;

    public override SyntaxNode? VisitConstantPattern(ConstantPatternSyntax node) => node;

    public override SyntaxNode? VisitRelationalPattern(RelationalPatternSyntax node) => node;

    public override SyntaxNode? VisitParameterList(ParameterListSyntax node) => node;

    public override SyntaxNode? VisitEnumDeclaration(EnumDeclarationSyntax node) => node;

    public override SyntaxNode? VisitLocalDeclarationStatement(LocalDeclarationStatementSyntax node) =>
        node.IsConst ? node : base.VisitLocalDeclarationStatement(node);

    public override SyntaxNode? VisitBinaryExpression(BinaryExpressionSyntax node)
    {
        var original = (ExpressionSyntax)base.VisitBinaryExpression(node)!;
        string l = node.Left.ToString(), r = node.Right.ToString();
        ITypeSymbol? type = model.GetTypeInfo(node.Left).Type;
        bool isReal = type?.SpecialType is SpecialType.System_Double or SpecialType.System_Single;
        string edge = isReal ? "edge of reals" : "edge of integers";
        var changes = new List<(string, string)>();
        switch (node.Kind())
        {
            case SyntaxKind.LessThanExpression: changes.Add((edge, $"{l} <= {r}")); break;
            case SyntaxKind.LessThanOrEqualExpression: changes.Add((edge, $"{l} < {r}")); break;
            case SyntaxKind.GreaterThanExpression: changes.Add((edge, $"{l} >= {r}")); break;
            case SyntaxKind.GreaterThanOrEqualExpression: changes.Add((edge, $"{l} > {r}")); break;
            case SyntaxKind.EqualsExpression: changes.Add(("negate", $"{l} != {r}")); break;
            case SyntaxKind.NotEqualsExpression: changes.Add(("negate", $"{l} == {r}")); break;
            case SyntaxKind.LogicalAndExpression: changes.Add(("logic", Declares(node) ? l : $"({l}) || ({r})")); break;
            case SyntaxKind.LogicalOrExpression: changes.Add(("logic", Declares(node) ? l : $"({l}) && ({r})")); break;
            case SyntaxKind.BitwiseAndExpression: changes.Add(("logic", $"({l}) | ({r})")); break;
            case SyntaxKind.BitwiseOrExpression: changes.Add(("logic", $"({l}) & ({r})")); break;
            case SyntaxKind.AddExpression: changes.Add(("arithmetic", $"({l}) - ({r})")); break;
            case SyntaxKind.SubtractExpression: changes.Add(("arithmetic", $"({l}) + ({r})")); break;
            case SyntaxKind.MultiplyExpression: changes.Add(("arithmetic", $"({l}) / ({r})")); break;
            case SyntaxKind.DivideExpression: changes.Add(("arithmetic", $"({l}) * ({r})")); break;
        }

        if (changes is [(var kind, _)] && kind == edge) changes.Add(("negate", $"!({node})"));
        return Choice(node, original, changes);
    }

    public override SyntaxNode? VisitPrefixUnaryExpression(PrefixUnaryExpressionSyntax node)
    {
        if (node.Operand is LiteralExpressionSyntax) return node;
        var original = (ExpressionSyntax)base.VisitPrefixUnaryExpression(node)!;
        if (node.Kind() is not (SyntaxKind.UnaryMinusExpression or SyntaxKind.LogicalNotExpression)) return original;
        return Choice(node, original, [("sign", node.Operand.ToString())]);
    }

    public override SyntaxNode? VisitLiteralExpression(LiteralExpressionSyntax node)
    {
        if (!node.IsKind(SyntaxKind.NumericLiteralExpression)) return node;
        if (node.Token.Value is int n) return Choice(node, node, [("literal", $"{n + 1L}")]);
        return node.Token.Value is double ? Choice(node, node, [("literal", $"({node} * 4)")]) : node;
    }

    public override SyntaxNode? VisitInvocationExpression(InvocationExpressionSyntax node)
    {
        var original = (ExpressionSyntax)base.VisitInvocationExpression(node)!;
        string arguments = node.ArgumentList.ToString();
        return node.Expression.ToString() switch
        {
            "Math.Min" => Choice(node, original, [("bound", "Math.Max" + arguments)]),
            "Math.Max" => Choice(node, original, [("bound", "Math.Min" + arguments)]),
            "Math.Abs" => Choice(node, original, [("sign", arguments)]),
            _ => original,
        };
    }

    public override SyntaxNode? VisitAssignmentExpression(AssignmentExpressionSyntax node)
    {
        var now = (AssignmentExpressionSyntax)base.VisitAssignmentExpression(node)!;
        if (node.Kind() is not (SyntaxKind.AddAssignmentExpression or SyntaxKind.SubtractAssignmentExpression))
            return now;
        ExpressionSyntax right = Choice(node.Right, now.Right, [("arithmetic", $"-({node.Right})")]);
        return now.WithRight(right);
    }

    public override SyntaxNode? VisitIfStatement(IfStatementSyntax node)
    {
        var now = (IfStatementSyntax)base.VisitIfStatement(node)!;
        return now.WithCondition(Condition(node.Condition, now.Condition));
    }

    public override SyntaxNode? VisitConditionalExpression(ConditionalExpressionSyntax node)
    {
        var now = (ConditionalExpressionSyntax)base.VisitConditionalExpression(node)!;
        return now.WithCondition(Condition(node.Condition, now.Condition));
    }

    public override SyntaxNode? VisitReturnStatement(ReturnStatementSyntax node)
    {
        var now = (ReturnStatementSyntax)base.VisitReturnStatement(node)!;
        return node.Expression is null ? now : now.WithExpression(Answer(node.Expression, now.Expression!));
    }

    public override SyntaxNode? VisitArrowExpressionClause(ArrowExpressionClauseSyntax node)
    {
        var now = (ArrowExpressionClauseSyntax)base.VisitArrowExpressionClause(node)!;
        return now.WithExpression(Answer(node.Expression, now.Expression));
    }

    /// <summary>Statements that can be left out: calls, assignments, steps.</summary>
    public override SyntaxNode? VisitExpressionStatement(ExpressionStatementSyntax node)
    {
        var now = (ExpressionStatementSyntax)base.VisitExpressionStatement(node)!;
        if (onlyConstants || Declares(node)) return now;
        int number = Add("drop", node, node.ToString(), ";", []);
        if (refused.Contains(number)) return now;
        return Marked(Block(IfStatement(ParseExpression("!" + Is(number)), now)), [number]);
    }

    private ExpressionSyntax Condition(ExpressionSyntax node, ExpressionSyntax now) =>
        node is BinaryExpressionSyntax { RawKind: not ((int)SyntaxKind.LogicalAndExpression) }
            || node is PrefixUnaryExpressionSyntax
            ? now
            : Flipped(node, now);

    private ExpressionSyntax Answer(ExpressionSyntax node, ExpressionSyntax now)
    {
        if (model.GetTypeInfo(node).Type?.SpecialType != SpecialType.System_Boolean) return now;
        if (node is LiteralExpressionSyntax) return Flipped(node, now);
        return Choice(node, now, [("answer", "true"), ("answer", "false")]);
    }

    /// <summary>The other truth value, without a second copy of what may declare variables.</summary>
    private ExpressionSyntax Flipped(ExpressionSyntax node, ExpressionSyntax now)
    {
        if (onlyConstants) return now;
        int number = Add("negate", node, node.ToString(), $"!({node})", []);
        if (refused.Contains(number)) return now;
        return Marked(Joined(SyntaxKind.ExclusiveOrExpression, now, Is(number)), [number]);
    }

    private ExpressionSyntax Choice(
        ExpressionSyntax node, ExpressionSyntax original, IEnumerable<(string Operator, string Changed)> changes)
    {
        if (onlyConstants) return original;
        var numbers = new List<int>();
        ExpressionSyntax choice = original.WithoutTrivia();
        bool declares = Declares(node);
        foreach ((string kind, string changed) in changes)
        {
            int number = Add(kind, node, node.ToString(), changed, []);
            ExpressionSyntax? next = declares
                ? InPlace(kind, changed, choice, number)
                : ConditionalExpression(ParseExpression(Is(number)), ParseExpression(changed), choice);
            if (next is null) refused.Add(number);
            if (refused.Contains(number)) continue;
            numbers.Add(number);
            choice = next!;
        }

        if (numbers.Count == 0) return original;
        return Marked(ParenthesizedExpression(choice).WithTriviaFrom(original), numbers);
    }

    /// <summary>The change of a condition that declares variables, which a second copy would declare again; null where
    /// there is none.</summary>
    private static ExpressionSyntax? InPlace(string kind, string changed, ExpressionSyntax now, int number) =>
        (kind, now) switch
        {
            ("logic", BinaryExpressionSyntax both) => both.WithRight(
                Forced(both.Right, both.IsKind(SyntaxKind.LogicalAndExpression), number)),
            ("answer", _) => Forced(now, changed == "true", number),
            ("negate", _) or ("sign", PrefixUnaryExpressionSyntax { RawKind: (int)SyntaxKind.LogicalNotExpression }) =>
                Joined(SyntaxKind.ExclusiveOrExpression, now, Is(number)),
            _ => null,
        };

    private static ExpressionSyntax Forced(ExpressionSyntax now, bool value, int number) => value
        ? Joined(SyntaxKind.BitwiseOrExpression, now, Is(number))
        : Joined(SyntaxKind.BitwiseAndExpression, now, "!" + Is(number));

    private static ExpressionSyntax Joined(SyntaxKind kind, ExpressionSyntax now, string with) =>
        ParenthesizedExpression(BinaryExpression(kind, ParenthesizedExpression(now), ParseExpression(with)));

    private int Add(string kind, SyntaxNode node, string original, string changed, string[] pins)
    {
        int line = node.GetLocation().GetLineSpan().StartLinePosition.Line + 1;
        mutants.Add(new Mutant(mutants.Count + 1, kind, file, line, OneLine(original), OneLine(changed), pins));
        return mutants.Count;
    }

    private static T Marked<T>(T node, IEnumerable<int> numbers)
        where T : SyntaxNode =>
        node.WithAdditionalAnnotations(new SyntaxAnnotation(Mark, string.Join(",", numbers)));

    private static bool Declares(SyntaxNode node) =>
        node.DescendantNodes().Any(n => n is DeclarationExpressionSyntax or SingleVariableDesignationSyntax);

    private static string Is(int number) => $"global::Gjk.Core.Mutation.Is({number})";

    private static string OneLine(string text) => Regex.Replace(text, @"\s+", " ");

    private static string[] PinnedBy(string comment)
    {
        Match text = Regex.Match(Regex.Replace(comment, @"\s*///\s*|\s+", " "), @"Pinned by ([^<]*)");
        return [.. Regex.Matches(text.Groups[1].Value, @"\b[A-Z]\w*[a-z]\w*").Select(m => m.Value)];
    }
}
