using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using EnterExit;
using Gjk.Core;
using Xunit;

namespace Gjk.Samples.Tests;

public class EnterExitTests
{
    private const string Sample = "EnterExit";

    private static readonly SampleRun Run = SampleProcess.Run(Sample);

    [Fact]
    public void EventsAreThoseOfAllPairs()
    {
        Run.AssertDone();
        var scene = new CollisionScene();
        var carousel = new Carousel(scene);
        carousel.MoveTo(-1);
        HashSet<ObjectPair> before = Overlapping(scene);
        var expected = new List<string>();
        for (int frame = 0; frame < Carousel.RoundFrames; frame++)
        {
            carousel.MoveTo(frame);
            HashSet<ObjectPair> now = Overlapping(scene);
            foreach (ObjectPair pair in before.Union(now).Order())
            {
                if (before.Contains(pair) == now.Contains(pair)) continue;
                string verb = now.Contains(pair) ? "enter" : "exit ";
                expected.Add($"frame {frame,4}  {verb}  {Carousel.NameOf(pair.A)}, {Carousel.NameOf(pair.B)}");
            }

            before = now;
        }

        Assert.Equal(expected, Run.Lines[..^1]);
        int enters = expected.Count(l => l.Contains("enter"));
        Assert.StartsWith($"240 frames, {enters} enters, {expected.Count - enters} exits, ", Run.Lines[^1]);

        // All is back where it was after a round, so as many pairs met as parted.
        Assert.Equal(2 * enters, expected.Count);
        Assert.True(enters > 20);
    }

    [Fact]
    public void AFrameAllocatesNothingAfterTheFirstRound()
    {
        SampleRun run = SampleProcess.Run(Sample, "600");
        run.AssertDone();
        Assert.EndsWith(", at most 0 bytes allocated in a frame", run.Lines[^1]);
        Assert.StartsWith("600 frames, ", run.Lines[^1]);
    }

    [Fact]
    public void PairsThatBeginEndAndRemain()
    {
        var scene = new CollisionScene();
        var ball = ConvexShape.Sphere(1);
        for (int i = 0; i < 3; i++) scene.Add(ball, At(10 * i));
        var events = new OverlapEvents(scene);
        var log = new List<string>();
        events.Entered += pair => log.Add($"+{pair}");
        events.Exited += pair => log.Add($"-{pair}");

        events.Update();
        Assert.Empty(log);
        scene.Move(1, At(1));
        scene.Move(2, At(2));
        events.Update();
        Assert.Equal(["+(0, 1)", "+(0, 2)", "+(1, 2)"], log);
        scene.Move(0, At(1));
        events.Update();
        Assert.Equal(3, log.Count);
        scene.Move(1, At(20));
        events.Update();
        Assert.Equal(["-(0, 1)", "-(1, 2)"], log[3..]);
        scene.Remove(2);
        events.Update();
        Assert.Equal("-(0, 2)", Assert.Single(log[5..]));
    }

    [Theory]
    [InlineData("0")]
    [InlineData("1.5")]
    [InlineData("1", "2")]
    public void WrongArgumentsAreRefused(params string[] args) =>
        SampleProcess.Run(Sample, args).AssertRefused("usage: EnterExit [FRAMES]");

    [Fact]
    public void TheReadmeShowsTheOutput() =>
        Readme.AssertShows(Sample, Run.Lines, l => Regex.Replace(l, @"[\d.]+ us", ""));

    private static RigidPose At(float x) => new(new System.Numerics.Vector3(x, 0, 0));

    private static HashSet<ObjectPair> Overlapping(CollisionScene scene)
    {
        var pairs = new HashSet<ObjectPair>();
        for (int a = 0; a < scene.Count; a++)
        {
            for (int b = a + 1; b < scene.Count; b++)
            {
                bool isMet = ObjectSettings.AreTested(scene.GetSettings(a), scene.GetSettings(b))
                    && ConvexQuery.Overlaps(scene.GetShape(a), scene.GetPose(a), scene.GetShape(b), scene.GetPose(b));
                if (isMet) pairs.Add(new ObjectPair(a, b));
            }
        }

        return pairs;
    }
}
