using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using UnityEngine;
using UnityStubs;

namespace Gjk.Unity.Checks;

/// <summary>From Unity 6.6 on, new projects enter play mode without a domain reload: statics keep their values. So each
/// static of the package begins anew by itself, or is named here with the reason why what it keeps does no
/// harm.</summary>
[Collection(nameof(OneScene))]
public class StaticsTests
{
    private const BindingFlags Statics =
        BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    private static readonly Assembly[] Package =
        [typeof(GjkPhysics).Assembly, typeof(Editor.MeasureWindow).Assembly, typeof(Samples.Benchmark).Assembly];

    private static readonly Dictionary<string, string> Harmless = new()
    {
        ["PairQueries._scratch"] = "memory of the library's searches: no question reads what an earlier one left",
        ["PairQueries._parts"] = "cleared before each use; holds distances and no objects",
        ["PairQueries._contacts"] = "cleared before each use; holds points and no objects",
        ["MeshPrint.Vertices"] = "overwritten before each use; holds numbers and no objects",
        ["ByReference.Comparer"] = "has no state",
        ["Benchmark.Kinds"] = "an array of names that nothing writes",
    };

    [Fact]
    public void EachStaticBeginsAnewOrDoesNoHarm()
    {
        string[] kept = [.. from field in Fields()
                            where !IsConstant(field) && !IsReset(field)
                            select NameOf(field)];
        Assert.Equal(Harmless.Keys.Order(), kept.Order());
        Assert.All(Harmless.Values, Assert.NotEmpty);
    }

    /// <summary>What is reset holds something else afterwards than before.</summary>
    [Fact]
    public void AResetForgets()
    {
        FieldInfo[] reset = [.. Fields().Where(f => !IsConstant(f) && IsReset(f))];
        Assert.True(reset.Length >= 5, string.Join(", ", reset.Select(NameOf)));
        var root = new GameObject("world");
        Messages.Send(root.AddComponent<GjkWorld>(), "OnEnable");
        Assert.NotNull(GjkWorld.Current);
        object?[] before = [.. reset.Select(f => f.GetValue(null))];
        Assert.All(before, Assert.NotNull);
        foreach (MethodInfo method in reset.Select(f => f.DeclaringType!).Distinct().SelectMany(Resets))
            method.Invoke(null, null);
        for (int i = 0; i < reset.Length; i++) Assert.NotSame(before[i], reset[i].GetValue(null));
        UnityEngine.Object.DestroyImmediate(root);
    }

    private static IEnumerable<FieldInfo> Fields() =>
        from assembly in Package
        from type in assembly.GetTypes()
        where !type.IsDefined(typeof(CompilerGeneratedAttribute))
        from field in type.GetFields(Statics)
        where !field.IsLiteral
        select field;

    /// <summary>Whether it is read-only and a value without references, or a text.</summary>
    private static bool IsConstant(FieldInfo field) =>
        field.IsInitOnly && (field.FieldType == typeof(string) || IsPlain(field.FieldType));

    private static bool IsPlain(Type type) =>
        type.IsPrimitive || type.IsEnum
        || (type.IsValueType && type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic)
            .All(f => f.FieldType != type && IsPlain(f.FieldType)));

    /// <summary>Whether its type has a method that the engine calls when play begins. What is read-only is not
    /// reset.</summary>
    private static bool IsReset(FieldInfo field) => !field.IsInitOnly && Resets(field.DeclaringType!).Any();

    private static IEnumerable<MethodInfo> Resets(Type type) => type.GetMethods(Statics).Where(m =>
        m.GetCustomAttribute<RuntimeInitializeOnLoadMethodAttribute>()?.loadType
            == RuntimeInitializeLoadType.SubsystemRegistration);

    /// <summary>Type and field; a property's field by the property's name.</summary>
    private static string NameOf(FieldInfo field) =>
        $"{field.DeclaringType!.Name}.{field.Name.TrimStart('<').Split('>')[0]}";
}
