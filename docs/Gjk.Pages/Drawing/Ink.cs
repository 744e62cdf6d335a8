namespace Gjk.Pages;

/// <summary>The colours of the figures. Each also has its own place, dash or label, so that grey is enough.</summary>
internal static class Ink
{
    public const string A = "#1d4ed8", B = "#c2410c", Difference = "#6d28d9", Origin = "#0f172a", Answer = "#be123c",
        Text = "#1e293b", Faint = "#94a3b8", Paper = "#ffffff", Good = "#15803d";

    /// <summary>What each of them becomes where the reader's theme is dark.</summary>
    public static readonly (string Light, string Dark)[] InTheDark =
    [
        (A, "#8ab4ff"), (B, "#fb923c"), (Difference, "#c4a5fb"), (Origin, "#f1f5f9"), (Answer, "#fb7185"),
        (Text, "#e2e8f0"), (Faint, "#7b8798"), (Paper, "#1f2430"), (Good, "#4ade80"),
    ];
}
