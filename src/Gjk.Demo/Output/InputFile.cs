using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using System.Threading.Tasks;

namespace Gjk.Demo.Output;

/// <summary>Reads the bytes of an input: a file, a pipe, or standard input if the name is "-".</summary>
internal static class InputFile
{
    /// <summary>The name that stands for standard input.</summary>
    public const string StandardInput = "-";

    /// <summary>
    /// Bytes of one input. The largest scenes that <c>import</c> writes are smaller. A device without an end is refused
    /// after this many bytes.
    /// </summary>
    public const int MostBytes = 1 << 29;

    private const int ChunkBytes = 1 << 16;

    /// <summary>The name of the input in messages.</summary>
    public static string NameOf(string file) => file == StandardInput ? "standard input" : file;

    /// <summary>Reads to the end. The writer of a pipe may never finish, so another thread waits for it.</summary>
    /// <exception cref="RefusedException">The input cannot be read, or it has more than <see cref="MostBytes"/>
    /// bytes.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the end was reached.</exception>
    public static byte[] Read(string file, CancellationToken cancel) => Read(file, MostBytes, cancel);

    /// <summary>As the other one, with a limit of its own.</summary>
    /// <exception cref="RefusedException">The input cannot be read, or it has more bytes.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the end was reached.</exception>
    public static byte[] Read(string file, int mostBytes, CancellationToken cancel)
    {
        Task<byte[]> read = Task.Run(() => ReadUpTo(file, mostBytes, cancel), CancellationToken.None);
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
        using Stream input = file == StandardInput
            ? Console.OpenStandardInput()
            : new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete);
        if (input.CanSeek && input.Length > mostBytes) throw TooLong(file, mostBytes);

        // A pipe does not tell its length. Chunks, unlike one growing buffer, are never copied but at the end.
        var chunks = new List<byte[]>();
        long total = 0;
        byte[] chunk = new byte[ChunkBytes];
        while (input.ReadAtLeast(chunk, ChunkBytes, throwOnEndOfStream: false) is int count and > 0)
        {
            cancel.ThrowIfCancellationRequested();
            if ((total += count) > mostBytes) throw TooLong(file, mostBytes);
            chunks.Add(count == ChunkBytes ? chunk : chunk[..count]);
            chunk = new byte[ChunkBytes];
        }

        byte[] all = new byte[total];
        int at = 0;
        foreach (byte[] part in chunks)
        {
            part.CopyTo(all, at);
            at += part.Length;
        }

        return all;
    }

    private static RefusedException TooLong(string file, int mostBytes) =>
        new($"{NameOf(file)}: cannot be read: it has more than {mostBytes} bytes");
}
