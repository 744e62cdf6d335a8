using Gjk.Demo.Replay;

namespace Gjk.Demo.View;

/// <summary>Queries every pair of a scene in every frame, and writes the results as a page, as a still picture, or as
/// both.</summary>
internal static class ViewCommand
{
    /// <param name="scene">The scene.</param>
    /// <param name="name">The user's name for the scene.</param>
    /// <param name="page">The HTML file, or null.</param>
    /// <param name="picture">The SVG file, or null.</param>
    /// <param name="isLive">Whether the page also holds the library.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    public static int Run(
        Scene scene, string name, string? page, string? picture, bool isLive, CancellationToken cancel)
    {
        if (picture is not null) PicturePieces.Check(scene, name);
        if (isLive) scene.Convex(name, "--live");
        ShapeRange.Check(scene, name);
        if (isLive) LivePage.Check(scene, name);
        using AtomicFile? pageFile = page is null ? null : new AtomicFile(page, cancel);
        using AtomicFile? pictureFile = picture is null ? null : new AtomicFile(picture, cancel);
        long pairs = 0;
        ProgressBar.Show(bars =>
        {
            SceneResults results = SceneResults.Of(
                scene, name, bars.Add("choice of pairs"), bars.Add(scene.Name), cancel);
            pairs = results.Pairs.Count;
            var shapes = new ShapeTable(scene);
            Action<Stream>? library = isLive ? stream => LivePage.Write(stream, scene, results.Pairs) : null;
            if (pageFile is not null) ScenePage.Write(pageFile.Stream, scene, shapes, results, library);
            if (pictureFile is not null)
                ScenePicture.Write(pictureFile.Stream, scene, shapes, results, bars.Add("picture"), cancel);
        });
        // No old file is replaced before both new files are complete on the disk.
        pageFile?.Complete();
        pictureFile?.Complete();
        pageFile?.Commit();
        pictureFile?.Commit();
        string choice = pairs == scene.Pairs.Count
            ? ""
            : $": all that intersect, and the {PairChoice.Partners} nearest of each object, "
                + $"of {scene.Pairs.Count} pairs";
        if (page is not null) StandardError.Wrote(pairs, "pair", page + choice);
        if (picture is not null) StandardError.Wrote(scene.Objects.Length, "object", picture);
        return ExitCode.Done;
    }
}
