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

    /// <summary>The name of the input in messages.</summary>
    public static string NameOf(string file) => file == StandardInput ? "standard input" : file;

    /// <summary>Reads to the end. The writer of a pipe may never finish, so another thread waits for it.</summary>
    /// <exception cref="RefusedException">The input cannot be read.</exception>
    /// <exception cref="OperationCanceledException">Cancelled before the end was reached.</exception>
    public static byte[] Read(string file, CancellationToken cancel)
    {
        byte[] ReadAll() => file == StandardInput ? ReadStandardInput() : File.ReadAllBytes(file);
        Task<byte[]> read = Task.Run(ReadAll, CancellationToken.None);
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

    private static byte[] ReadStandardInput()
    {
        using Stream input = Console.OpenStandardInput();
        using var bytes = new MemoryStream();
        input.CopyTo(bytes);
        return bytes.ToArray();
    }
}
