using System.Globalization;

namespace Gjk.Core.Diagnostics;

/// <summary>The words of a record, one after the other; every complaint names the word and its place.</summary>
internal sealed class RecordReader(string text)
{
    private readonly string[] _words = text.Split([' ', '\t', '\r', '\n'], StringSplitOptions.RemoveEmptyEntries);
    private int _next;

    public string? Peek => _next < _words.Length ? _words[_next] : null;

    public string Word(string what) =>
        _next < _words.Length ? _words[_next++] : throw new FormatException($"The record ends where {what} should be.");

    public void Expect(string word)
    {
        string found = Word($"'{word}'");
        if (found != word) throw Wrong($"should be '{word}'");
    }

    public void ExpectEnd()
    {
        if (_next++ < _words.Length) throw Wrong("comes after the end of the record");
    }

    public double Number()
    {
        string word = Word("a number");
        bool isNumber = double.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out double number);
        return isNumber && Guard.IsFinite(number) ? number : throw Wrong("should be a finite number");
    }

    public float Float()
    {
        string word = Word("a number");
        bool isNumber = float.TryParse(word, NumberStyles.Float, CultureInfo.InvariantCulture, out float number);
        return isNumber && Guard.IsFinite(number) ? number : throw Wrong("should be a finite number");
    }

    public int Count()
    {
        bool isCount = int.TryParse(Word("a count"), NumberStyles.None, CultureInfo.InvariantCulture, out int count);
        int most = (_words.Length - _next) / 3;
        return isCount && count > 0 && count <= most
            ? count
            : throw Wrong("should be the number of points that follow");
    }

    public Double3 Vector() => new(Number(), Number(), Number());

    /// <summary>The last word was wrong.</summary>
    public FormatException Wrong(string why) => new($"Word {_next}, '{_words[_next - 1]}', {why}.");

    /// <summary>Makes something of the words read; what its constructor refuses is a fault of the text.</summary>
    public T Build<T>(Func<T> make)
    {
        try
        {
            return make();
        }
        catch (ArgumentException exception)
        {
            throw new FormatException($"Before word {_next + 1}: {exception.Message}", exception);
        }
    }
}
