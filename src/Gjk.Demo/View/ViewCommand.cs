using System;
using System.IO;
using System.Threading;
using Gjk.Demo.Output;
using Gjk.Demo.Replay;
using Gjk.Demo.Scenes;

namespace Gjk.Demo.View;

/// <summary>Asks for every pair of a scene in every frame, and writes what was found as a page, as a still picture, or both.</summary>
internal static class ViewCommand
{
    /// <param name="scene">The scene.</param>
    /// <param name="name">What the user calls it.</param>
    /// <param name="page">The HTML file, or null.</param>
    /// <param name="picture">The SVG file, or null.</param>
    /// <param name="cancel">Ends the work; no file is left then.</param>
    public static int Run(Scene scene, string name, string? page, string? picture, CancellationToken cancel)
    {
        using AtomicFile? pageFile = page is null ? null : new AtomicFile(page);
        using AtomicFile? pictureFile = picture is null ? null : new AtomicFile(picture);
        ProgressBar.Show(OutputConsole.Create(), OutputConsole.IsPlain, bars =>
        {
            SceneResults results = SceneResults.Of(scene, name, bars.Add(scene.Name), cancel);
            var shapes = new ShapeTable(scene);
            if (pageFile is not null) Write(pageFile, page!, stream => ScenePage.Write(stream, scene, shapes, results));
            if (pictureFile is not null) Write(pictureFile, picture!, stream => ScenePicture.Write(stream, scene, shapes, results, bars.Add("picture"), cancel));
        });
        cancel.ThrowIfCancellationRequested();
        pageFile?.Commit();
        pictureFile?.Commit();
        return ExitCode.Done;
    }

    private static void Write(AtomicFile file, string name, Action<Stream> content)
    {
        try
        {
            content(file.Stream);
        }
        catch (IOException e)
        {
            throw new RefusedException(name, "cannot be written", e);
        }
    }
}
