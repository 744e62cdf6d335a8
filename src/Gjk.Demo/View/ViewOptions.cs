using System.CommandLine;

namespace Gjk.Demo.View;

/// <summary>The command line of <c>view</c>.</summary>
internal static class ViewOptions
{
    public static Command Build(CancellationToken cancel)
    {
        var source = new SceneSource();
        var page = new Option<string?>("--out")
        {
            Description = "Write the page to this file. It has a 3D view, a list of pairs and, for a moving scene, its "
                + "frames, paths and impacts. In each overlap it shows the shortest way out and the contact points.",
            HelpName = "FILE.html",
        };
        var picture = new Option<string?>("--svg")
        {
            Description = "Write a still picture of the first frame to this file.",
            HelpName = "FILE.svg",
        };
        var live = new Option<bool>("--live")
        {
            Description = "Put the library into the page, too, so that bodies can be dragged and their answers follow. "
                + $"It makes the page 3 MB larger, and is for scenes of at most {LivePage.MostObjects} objects.",
        };
        var command = new Command(
            "view", "Show a scene as a page for the browser, in one file that needs no network, or as a picture.")
        {
            source.File, source.BuiltIn, page, picture, live,
        };
        source.Validate(command);
        command.Validators.Add(result =>
        {
            if (result.GetResult(page) is null && result.GetResult(picture) is null)
                result.AddError("--out or --svg is needed.");
            else if (result.GetValue(live) && result.GetResult(page) is null)
                result.AddError("--live needs --out.");
        });
        command.SetAction(r =>
        {
            string? html = r.GetValue(page), svg = r.GetValue(picture);
            TargetFiles.Check(r.GetValue(source.File), ("--out", html), ("--svg", svg));
            Scene scene = source.Load(r, cancel, out string name, onlyConvex: false);
            return ViewCommand.Run(scene, name, html, svg, r.GetValue(live), cancel);
        });
        return command;
    }
}
