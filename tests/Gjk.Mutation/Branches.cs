using System.Text.RegularExpressions;
using Microsoft.CodeAnalysis;
using Microsoft.CodeAnalysis.CSharp;
using Microsoft.CodeAnalysis.CSharp.Syntax;
using static Microsoft.CodeAnalysis.CSharp.SyntaxFactory;

namespace Gjk.Mutation;

/// <summary>Makes each condition of a file tell which way it went: those of statements and choices, and each operand of
/// <c>&amp;&amp;</c> and <c>||</c>. The cases of a switch tell that they were reached.</summary>
internal sealed class Branches(string file, HashSet<int> refused, List<Mutant> branches) : CSharpSyntaxRewriter
{
    public override SyntaxNode? VisitFieldDeclaration(FieldDeclarationSyntax node) =>
        node.Modifiers.Any(SyntaxKind.ConstKeyword) ? node : base.VisitFieldDeclaration(node);

    public override SyntaxNode? VisitIfStatement(IfStatementSyntax node)
    {
        var now = (IfStatementSyntax)base.VisitIfStatement(node)!;
        return now.WithCondition(Told(node.Condition, now.Condition));
    }

    public override SyntaxNode? VisitWhileStatement(WhileStatementSyntax node)
    {
        var now = (WhileStatementSyntax)base.VisitWhileStatement(node)!;
        return node.Condition is LiteralExpressionSyntax ? now : now.WithCondition(Told(node.Condition, now.Condition));
    }

    public override SyntaxNode? VisitForStatement(ForStatementSyntax node)
    {
        var now = (ForStatementSyntax)base.VisitForStatement(node)!;
        return node.Condition is null ? now : now.WithCondition(Told(node.Condition, now.Condition!));
    }

    public override SyntaxNode? VisitConditionalExpression(ConditionalExpressionSyntax node)
    {
        var now = (ConditionalExpressionSyntax)base.VisitConditionalExpression(node)!;
        return now.WithCondition(Told(node.Condition, now.Condition));
    }

    public override SyntaxNode? VisitBinaryExpression(BinaryExpressionSyntax node)
    {
        var now = (BinaryExpressionSyntax)base.VisitBinaryExpression(node)!;
        return node.Kind() is SyntaxKind.LogicalAndExpression or SyntaxKind.LogicalOrExpression
            ? now.WithLeft(Told(node.Left, now.Left)).WithRight(Told(node.Right, now.Right))
            : now;
    }

    public override SyntaxNode? VisitSwitchExpressionArm(SwitchExpressionArmSyntax node)
    {
        var now = (SwitchExpressionArmSyntax)base.VisitSwitchExpressionArm(node)!;
        return node.Expression is ThrowExpressionSyntax
            ? now
            : now.WithExpression(Arm(node.Expression, now.Expression));
    }

    private ExpressionSyntax Arm(ExpressionSyntax node, ExpressionSyntax now)
    {
        int number = Add(node, "arm");
        if (refused.Contains(number)) return now;
        ExpressionSyntax told = ParseExpression($"global::Gjk.Core.Mutation.Told({number}, true)");
        ExpressionSyntax choice = ConditionalExpression(told, now.WithoutTrivia(), ParseExpression("default!"));
        return Marked(ParenthesizedExpression(choice), number);
    }

    private ExpressionSyntax Told(ExpressionSyntax node, ExpressionSyntax now)
    {
        // Its operands tell.
        if (node is BinaryExpressionSyntax { RawKind: (int)SyntaxKind.LogicalAndExpression })
            return now;
        int number = Add(node, "branch");
        if (refused.Contains(number)) return now;
        InvocationExpressionSyntax told = InvocationExpression(
            ParseExpression("global::Gjk.Core.Mutation.Told"),
            ArgumentList(
                SeparatedList(
                    [Argument(ParseExpression($"{number}")), Argument(now.WithoutTrivia())])));
        return Marked(told.WithTriviaFrom(now), number);
    }

    private int Add(SyntaxNode node, string kind)
    {
        int line = node.GetLocation().GetLineSpan().StartLinePosition.Line + 1;
        string text = Regex.Replace(node.ToString(), @"\s+", " ");
        branches.Add(new Mutant(branches.Count + 1, kind, file, line, text, "", []));
        return branches.Count;
    }

    private static T Marked<T>(T node, int number)
        where T : SyntaxNode =>
        node.WithAdditionalAnnotations(new SyntaxAnnotation(Schemata.Mark, $"{number}"));
}
