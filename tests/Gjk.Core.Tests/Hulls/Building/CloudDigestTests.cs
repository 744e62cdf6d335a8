using System.Security.Cryptography;

namespace Gjk.Core.Tests.Hulls.Building;

/// <summary>The library's own SHA-256 is the runtime's, which the library must not need.</summary>
public class CloudDigestTests
{
    /// <summary>From no block but the padding's to several: the padding takes a block of its own where 56 bytes do not
    /// fit.</summary>
    [Fact]
    public void TheDigestIsTheRuntimes()
    {
        var rng = new Rng(29);
        for (int count = 0; count < 40; count++)
        {
            Vector3[] cloud = [.. Enumerable.Range(0, count).Select(_ => (Vector3)rng.Vector(-1e9, 1e9))];
            byte[] bytes = [.. cloud.SelectMany(p => new[] { p.X, p.Y, p.Z }).SelectMany(LowestByteFirst)];
            ulong expected = SHA256.HashData(bytes).Take(8).Aggregate(0UL, (seed, b) => seed << 8 | b);
            Assert.True(expected == CloudDigest.Of(cloud), $"{count} points");
        }
    }

    private static byte[] LowestByteFirst(float x)
    {
        byte[] bytes = new byte[4];
        System.Buffers.Binary.BinaryPrimitives.WriteSingleLittleEndian(bytes, x);
        return bytes;
    }
}
