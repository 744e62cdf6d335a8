namespace Gjk.Pages;

/// <summary>A picture of the book.</summary>
/// <param name="Name">The file's name without its ending.</param>
/// <param name="Svg">The picture.</param>
public sealed record Figure(string Name, string Svg);
