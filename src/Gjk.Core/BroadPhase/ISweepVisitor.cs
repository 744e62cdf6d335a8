namespace Gjk.Core;

/// <summary>Is shown the objects whose boxes a path meets, and says how much of the path is still of interest.
/// Implement it with a struct: it is called without boxing.</summary>
public interface ISweepVisitor
{
    /// <summary>One object. The broad phase must not be changed before the last visit has returned.</summary>
    /// <param name="id">Its number.</param>
    /// <returns>The largest fraction that is of interest from now on: boxes that the path meets only later are left
    /// out. It does not grow again. +infinity to see all boxes; for the first hit, <see cref="SweptBox.After"/>
    /// that.</returns>
    double Visit(int id);
}
