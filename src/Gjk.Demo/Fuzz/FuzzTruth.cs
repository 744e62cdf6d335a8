using Gjk.Core;
using Gjk.Core.Tests.Support;

namespace Gjk.Demo.Fuzz;

/// <summary>
/// The true distance of a pair, solved in integers of any size from the points that the shapes were made of: known for every pair without a curved core, margins included.
/// </summary>
internal sealed class FuzzTruth
{
    private readonly FuzzPair _pair;

    public FuzzTruth(FuzzPair pair)
    {
        _pair = pair;
        if (IsKnown) Answer = Solve(default);
    }

    /// <summary>False where a core is curved; there the certificate and the library's accuracy of 1e-6 must do.</summary>
    public bool IsKnown => !_pair.IsCurved;

    /// <summary>The exact flag and the distance rounded to the nearest double.</summary>
    public ExactAnswer Answer { get; }

    /// <summary>Whether moving B by so much parts the shapes: then they overlap by no more than that.</summary>
    public bool PartsWith(in Vector3D moveB) => !Solve(moveB).Overlap;

    private ExactAnswer Solve(in Vector3D moveB) =>
        ExactOracle.Solve(_pair.BodyA.Vertices, _pair.A.Margin, _pair.PoseA, _pair.BodyB.Vertices, _pair.B.Margin, _pair.PoseB, moveB);
}
