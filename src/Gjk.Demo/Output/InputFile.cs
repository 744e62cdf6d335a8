using System;
using System.IO;
using System.Threading;
using System.Threading.Tasks;

namespace Gjk.Demo.Output;

/// <summary>Reads the bytes of an input: a file, a pipe, or standard input if the name is "-".</summary>
internal static class InputFile
{
    /// <summary>The name that stands for standard input.</summary>
    public const string StandardInput = "-";

    private const int ChunkBytes = 1 << 16;

    /// <summary>The name of the input in messages.</summary>
    public static string NameOf(string file) => file == StandardInput ? "standard input" : file;

    /// <summary>Reads to the end. The writer of a pipe may never finish, so another thread waits for it.</summary>
    /// <exception cref="RefusedException">The input cannot be read.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the end was reached.</exception>
    public static byte[] Read(string file, CancellationToken cancel) =>
        Read(file, () => file == StandardInput ? ReadStandardInput() : File.ReadAllBytes(file), cancel);

    /// <summary>As the other one, but refuses a file that is too large, even a device without an end.</summary>
    /// <exception cref="RefusedException">The file cannot be read, or it has more bytes.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the end was reached.</exception>
    public static byte[] Read(string file, int mostBytes, CancellationToken cancel) =>
        Read(file, () => ReadUpTo(file, mostBytes, cancel), cancel);

    private static byte[] Read(string file, Func<byte[]> readAll, CancellationToken cancel)
    {
        Task<byte[]> read = Task.Run(readAll, CancellationToken.None);
        Task.WaitAny([read], cancel);
        try
        {
            return read.GetAwaiter().GetResult();
        }
        catch (Exception e) when (RefusedException.IsFileTrouble(e))
        {
            throw new RefusedException(NameOf(file), "cannot be read", e);
        }
    }

    private static byte[] ReadUpTo(string file, int mostBytes, CancellationToken cancel)
    {
        using var input = new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.ReadWrite);
        using var bytes = new MemoryStream();
        byte[] buffer = new byte[ChunkBytes];
        while (input.Read(buffer) is int count and > 0)
        {
            cancel.ThrowIfCancellationRequested();
            if (bytes.Length + count > mostBytes)
                throw new RefusedException($"{NameOf(file)}: cannot be read: it has more than {mostBytes} bytes");
            bytes.Write(buffer.AsSpan(0, count));
        }

        return bytes.ToArray();
    }

    private static byte[] ReadStandardInput()
    {
        using Stream input = Console.OpenStandardInput();
        using var bytes = new MemoryStream();
        input.CopyTo(bytes);
        return bytes.ToArray();
    }
}
