namespace Gjk.Core;

/// <summary>Work on items 0 to n - 1 that may be done in parts, in any order and at the same time.</summary>
internal interface IPartJob
{
    /// <summary>Does the items from begin up to, not including, end. What it does to one item depends on no
    /// other.</summary>
    void Run(int begin, int end);
}
