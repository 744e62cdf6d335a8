namespace Gjk.Demo.Queries;

/// <summary>Writes the contact points of every pair of a scene, in the poses of its first frame, as CSV.</summary>
internal static class ContactsCommand
{
    /// <param name="scene">The scene.</param>
    /// <param name="table">The table to write.</param>
    /// <param name="maxGap">Points with a wider gap are left out.</param>
    /// <param name="cancel">Ends the work. No file is left then.</param>
    /// <returns>The exit code.</returns>
    public static int Run(Scene scene, PairTable table, float maxGap, CancellationToken cancel)
    {
        SceneObject[] objects = scene.Objects;
        var scratch = new ConcaveScratch();
        var contacts = new List<PairContacts>();
        return table.Write(
            CsvWriter.Contacts,
            (rows, a, b) =>
            {
                ConcaveQuery.FindContacts(
                    objects[a].Any, objects[a].Pose, objects[b].Any, objects[b].Pose, maxGap, scratch, contacts);
                foreach (PairContacts pair in contacts)
                {
                    for (int i = 0; i < pair.Manifold.Count; i++) rows.Write(a, b, pair, i);
                }
            },
            cancel,
            "contact point");
    }
}
