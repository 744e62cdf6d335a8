using Gjk.Core;

namespace PartClearance;

/// <summary>A part of the assembly. A mesh is the convex hull of its vertices, or what it is.</summary>
internal sealed record Part(string Name, AnyShape Shape, RigidPose Pose);
