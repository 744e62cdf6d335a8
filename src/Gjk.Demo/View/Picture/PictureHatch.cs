namespace Gjk.Demo.View;

/// <summary>Stripes over the bodies that intersect, so that their colour is not all that tells them from the others.
/// Their faces clip one striped rectangle, so the stripes repeat no outline.</summary>
internal sealed class PictureHatch
{
    private const string Pattern =
        "<pattern id=\"hatch\" width=\"9\" height=\"9\" patternUnits=\"userSpaceOnUse\" "
        + "patternTransform=\"rotate(-45)\"><path stroke=\"#0a0d12\" stroke-opacity=\".5\" stroke-width=\"6\" "
        + "d=\"M0 0V9\"/></pattern>";

    private readonly List<string> _faces = [];

    /// <summary>Names the next visible surface of a body that intersects.</summary>
    /// <returns>The attribute of its path.</returns>
    public string Next()
    {
        _faces.Add($"hit{_faces.Count}");
        return $" id=\"{_faces[^1]}\"";
    }

    /// <summary>Writes the stripes over all surfaces that were named.</summary>
    public void Write(TextWriter writer)
    {
        if (_faces.Count == 0) return;
        writer.Write($"<defs>{Pattern}<clipPath id=\"hit\">");
        foreach (string face in _faces) writer.Write($"<use href=\"#{face}\"/>");
        writer.WriteLine("</clipPath></defs>");
        writer.WriteLine(
            "<rect class=\"hatch\" width=\"100%\" height=\"100%\" fill=\"url(#hatch)\" clip-path=\"url(#hit)\"/>");
    }
}
