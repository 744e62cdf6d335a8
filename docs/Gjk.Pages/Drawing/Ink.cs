namespace Gjk.Pages;

/// <summary>The colours of the figures. Each also has its own place, dash or label, so that grey is enough.</summary>
internal static class Ink
{
    public const string A = "#1d4ed8", B = "#c2410c", Difference = "#6d28d9", Origin = "#0f172a", Answer = "#be123c",
        Text = "#1e293b", Faint = "#94a3b8", Paper = "#ffffff", Good = "#15803d";
}
