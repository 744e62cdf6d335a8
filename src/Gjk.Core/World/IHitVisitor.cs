namespace Gjk.Core;

/// <summary>
/// Is shown the objects that a ray meets, in order. Implement it with a struct: it is called without boxing.
/// </summary>
public interface IRayHitVisitor
{
    /// <summary>One object. The scene must not be used before the last visit has returned.</summary>
    void Visit(in RayHit hit);
}

/// <summary>
/// Is shown the objects that a moving shape meets, in order. Implement it with a struct: it is called without boxing.
/// </summary>
public interface ICastHitVisitor
{
    /// <summary>One object. The scene must not be used before the last visit has returned.</summary>
    void Visit(in CastHit hit);
}

/// <summary>
/// Is shown the objects that a scene finds, in order. Implement it with a struct: it is called without boxing.
/// </summary>
public interface IObjectVisitor
{
    /// <summary>One object. The scene must not be used before the last visit has returned.</summary>
    void Visit(int id);
}
