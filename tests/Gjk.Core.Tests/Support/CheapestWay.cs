namespace Gjk.Core.Tests.Support;

/// <summary>How long the shortest way out is at most: a search from many directions at once, each walking downhill in
/// ever smaller steps. It uses the shapes' supports alone, so it judges every shape.</summary>
internal static class CheapestWay
{
    private const int Starts = 400, Walks = 4, Tries = 12;

    private const double LeastStep = 1e-8;

    /// <summary>Ratio: what gains less is no step, or a walk along a level valley would not end for long.</summary>
    private const double LeastGain = 1e-10;

    public static double Of(TestPair pair, Double3 first, ulong seed)
    {
        var rng = new Rng(seed);
        var a = new Body<ConvexShape>(pair.A.Shape, pair.PoseA);
        var b = new Body<ConvexShape>(pair.B.Shape, pair.PoseB);
        (double Cost, Double3 Way)[] starts =
        [
            .. Enumerable.Range(0, Starts).Select(i => i == 0 ? first * (1 / first.Length) : Direction())
                .Select(way => (Cost(way), way)).OrderBy(s => s.Item1).Take(Walks)
        ];
        return starts.Min(s => Downhill(s.Cost, s.Way));

        Double3 Direction()
        {
            Double3 way = rng.UnitVector();
            return way * (1 / way.Length);
        }

        double Cost(Double3 way) =>
            a.Height(way) + b.Height(-way) - Double3.Dot(way, b.Position - a.Position);

        double Downhill(double least, Double3 way)
        {
            int failed = 0;
            double gain = LeastGain * Math.Abs(least);
            for (double step = 0.2; step > LeastStep;)
            {
                Double3 next = way + Direction() * step;
                next *= 1 / next.Length;
                double cost = Cost(next);
                if (cost < least - gain)
                {
                    (least, way, failed) = (cost, next, 0);
                    step *= 1.5;
                }
                else if (++failed > Tries)
                {
                    failed = 0;
                    step *= 0.6;
                }
            }

            return least;
        }
    }
}
