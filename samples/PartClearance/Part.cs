using Gjk.Core;

namespace PartClearance;

/// <summary>A part of the assembly. A mesh is taken as the convex hull of its vertices.</summary>
internal sealed record Part(string Name, ConvexShape Shape, RigidPose Pose);
