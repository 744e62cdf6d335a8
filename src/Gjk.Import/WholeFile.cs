using System.Threading.Tasks;

namespace Gjk.Import;

/// <summary>Reads all bytes of a file, a pipe or a device, up to a limit.</summary>
internal static class WholeFile
{
    private const int ChunkBytes = 1 << 16;

    /// <exception cref="ImportException">The file cannot be read, or it has more bytes than an import may
    /// have.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the end was reached.</exception>
    public static byte[] Read(string file, int mostBytes, CancellationToken cancel) => Read(
        file,
        () => new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.ReadWrite | FileShare.Delete),
        mostBytes,
        cancel);

    /// <summary>Reads to the end. The writer of a pipe may never finish, so another thread waits for it.</summary>
    /// <param name="name">For messages.</param>
    /// <param name="open">Opens it.</param>
    /// <param name="mostBytes">A device without an end is refused after so many.</param>
    /// <param name="cancel">Ends the wait.</param>
    /// <exception cref="ImportException">It cannot be read, or it has more bytes.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the end was reached.</exception>
    public static byte[] Read(string name, Func<Stream> open, int mostBytes, CancellationToken cancel)
    {
        Task<byte[]> read = Task.Run(() => ReadUpTo(name, open, mostBytes, cancel), CancellationToken.None);
        Task.WaitAny(new Task[] { read }, cancel);
        try
        {
            return read.GetAwaiter().GetResult();
        }
        catch (Exception e) when (ImportException.IsFileTrouble(e))
        {
            throw new ImportException(name, e);
        }
    }

    private static byte[] ReadUpTo(string name, Func<Stream> open, int mostBytes, CancellationToken cancel)
    {
        using Stream input = open();
        if (input.CanSeek && input.Length > mostBytes) throw TooLong(name, mostBytes);

        // A pipe does not tell its length. Chunks, unlike one growing buffer, are never copied but at the end.
        var chunks = new List<byte[]>();
        long total = 0;
        for (int count = ChunkBytes; count == ChunkBytes;)
        {
            byte[] chunk = new byte[ChunkBytes];
            int read = count = 0;
            while (count < ChunkBytes && (read = input.Read(chunk, count, ChunkBytes - count)) > 0) count += read;
            cancel.ThrowIfCancellationRequested();
            if ((total += count) > mostBytes) throw TooLong(name, mostBytes);
            chunks.Add(count == ChunkBytes ? chunk : chunk[..count]);
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

    private static ImportException TooLong(string name, int mostBytes) =>
        new($"{name}: cannot be read: it has more than {mostBytes} bytes");
}
