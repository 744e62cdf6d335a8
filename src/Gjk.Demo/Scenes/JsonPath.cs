namespace Gjk.Demo.Scenes;

/// <summary>The place of the reader in the document, such as $.objects[3].shape.radius. It becomes text only when
/// something is refused.</summary>
internal sealed class JsonPath
{
    private readonly List<(string? Field, int Index)> _steps = [];

    public void Enter(string field) => _steps.Add((field, 0));

    public void Enter(int index) => _steps.Add((null, index));

    public void MoveTo(int index) => _steps[^1] = (null, index);

    public void Leave() => _steps.RemoveAt(_steps.Count - 1);

    public override string ToString()
    {
        var text = new StringBuilder("$");
        foreach ((string? field, int index) in _steps)
        {
            if (field is null) text.Append('[').Append(index).Append(']');
            else if (IsPlain(field)) text.Append('.').Append(field);
            else text.Append("['").Append(field.Replace("\\", "\\\\").Replace("'", "\\'")).Append("']");
        }

        return text.ToString();
    }

    private static bool IsPlain(string field)
    {
        foreach (char c in field)
        {
            if (!char.IsLetterOrDigit(c) && c != '_') return false;
        }

        return field.Length > 0 && !char.IsDigit(field[0]);
    }
}
