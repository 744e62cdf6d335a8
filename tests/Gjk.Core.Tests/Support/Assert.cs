using System.Runtime.CompilerServices;

namespace Gjk.Core.Tests;

/// <summary>xunit's assertions, with messages that are put together only when they are shown.</summary>
public class Assert : Xunit.Assert
{
    public static void True(bool condition, [InterpolatedStringHandlerArgument(nameof(condition))] TrueMessage message)
    {
        if (!condition) True(condition, message.Text);
    }

    public static void False(
        bool condition, [InterpolatedStringHandlerArgument(nameof(condition))] FalseMessage message)
    {
        if (condition) False(condition, message.Text);
    }

    /// <summary>Unformatted where the condition holds.</summary>
    [InterpolatedStringHandler]
    public ref struct TrueMessage
    {
        private DefaultInterpolatedStringHandler _text;

        public TrueMessage(int length, int count, bool condition, out bool isShown)
        {
            isShown = !condition;
            _text = isShown ? new DefaultInterpolatedStringHandler(length, count) : default;
        }

        public string Text => _text.ToStringAndClear();

        public void AppendLiteral(string text) => _text.AppendLiteral(text);

        public void AppendFormatted<T>(T value, string? format = null) => _text.AppendFormatted(value, format);
    }

    /// <summary>Unformatted where the condition does not hold.</summary>
    [InterpolatedStringHandler]
    public ref struct FalseMessage
    {
        private TrueMessage _message;

        public FalseMessage(int length, int count, bool condition, out bool isShown) =>
            _message = new TrueMessage(length, count, !condition, out isShown);

        public string Text => _message.Text;

        public void AppendLiteral(string text) => _message.AppendLiteral(text);

        public void AppendFormatted<T>(T value, string? format = null) => _message.AppendFormatted(value, format);
    }
}
