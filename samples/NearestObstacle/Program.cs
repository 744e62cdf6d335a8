using System;
using System.Diagnostics;
using System.Globalization;
using System.Numerics;
using Gjk.Core;

namespace NearestObstacle;

/// <summary>Moves a robot arm among 200 obstacles, and prints what is nearest to it at each step.</summary>
internal static class Program
{
    public const int ObstacleCount = 200, Seed = 1;

    /// <summary>The part of the arm's whole motion that one step is.</summary>
    public const float StepTime = 0.02f;

    private static int Main(string[] args)
    {
        int steps = 20;
        bool isGood = args.Length == 0
            || (args.Length == 1 && int.TryParse(args[0], CultureInfo.InvariantCulture, out steps) && steps > 0);
        if (!isGood)
        {
            Console.Error.WriteLine("usage: NearestObstacle [STEPS], a whole number, at least 1");
            return 2;
        }

        var scene = new CollisionScene();
        var arm = new RobotArm(scene);
        Obstacles.AddTo(scene, ObstacleCount, Seed);
        Console.WriteLine(
            "step  link       nearest       distance  point on the link        point on the nearest     us");
        var times = new double[steps];
        for (int step = 0; step < steps; step++)
        {
            long start = Stopwatch.GetTimestamp();
            arm.MoveTo(step * StepTime);
            (int link, int other, DistanceResult result) = FindNearest(scene, arm);
            times[step] = Stopwatch.GetElapsedTime(start).TotalMicroseconds;
            Console.WriteLine(
                $"{step,4}  {arm.NameOf(link),-9}  {arm.NameOf(other),-12}  {result.Distance,8:F4}  "
                + $"{Text(result.PointA),-23}  {Text(result.PointB),-23}  {times[step]:F1}");
        }

        Array.Sort(times);
        Console.WriteLine($"median {times[steps / 2]:F1} us per step; the first steps wait for the compiler");
        return 0;
    }

    /// <summary>Of all links the one with the nearest object, that object, and where they are closest.</summary>
    private static (int Link, int Other, DistanceResult Result) FindNearest(CollisionScene scene, RobotArm arm)
    {
        (int Link, int Other, DistanceResult Result) nearest = (-1, -1, default);
        foreach (int link in arm.Links)
        {
            bool isFound = scene.TryFindNearest(link, out PairDistance found);
            if (isFound && (nearest.Link < 0 || found.Distance < nearest.Result.Distance))
                nearest = (link, found.Pair.B, found.Result);
        }

        return nearest;
    }

    private static string Text(Vector3 v) => $"({v.X:F3}, {v.Y:F3}, {v.Z:F3})";
}
