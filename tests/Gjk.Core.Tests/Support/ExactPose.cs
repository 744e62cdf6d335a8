namespace Gjk.Core.Tests.Support;

/// <summary>A pose in fractions, which round nothing: a matrix made of the quaternion, and the position.</summary>
internal sealed class ExactPose
{
    private readonly Fraction[] _matrix, _position;

    public ExactPose(in RigidPose pose)
    {
        Quaternion q = pose.Rotation;
        Fraction x = q.X, y = q.Y, z = q.Z, w = q.W, two = 2;
        Fraction xx = x * x, yy = y * y, zz = z * z, ww = w * w;
        Fraction[] rows =
        [
            ww + xx - yy - zz, two * (x * y - w * z), two * (x * z + w * y),
            two * (x * y + w * z), ww - xx + yy - zz, two * (y * z - w * x),
            two * (x * z - w * y), two * (y * z + w * x), ww - xx - yy + zz,
        ];
        _matrix = [.. rows.Select(m => m / (xx + yy + zz + ww))];
        _position = [pose.Position.X, pose.Position.Y, pose.Position.Z];
    }

    public Fraction this[int row, int column] => _matrix[3 * row + column];

    /// <summary>A local point in the world.</summary>
    public Fraction[] Place(in Double3 v)
    {
        Fraction[] local = [v.X, v.Y, v.Z];
        return [.. Enumerable.Range(0, 3).Select(i => Row(i, local) + _position[i])];
    }

    /// <summary>A vector of the world in the local axes.</summary>
    public Fraction[] InverseRotate(Fraction[] v) =>
        [.. Enumerable.Range(0, 3).Select(i => this[0, i] * v[0] + this[1, i] * v[1] + this[2, i] * v[2])];

    private Fraction Row(int i, Fraction[] v) => this[i, 0] * v[0] + this[i, 1] * v[1] + this[i, 2] * v[2];
}
