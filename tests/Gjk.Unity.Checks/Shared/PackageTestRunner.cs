using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace Gjk.Unity.Checks;

/// <summary>Runs the tests that lie in the Unity package, without NUnit: by the names of the attributes, so that it
/// does not matter where the attributes come from.</summary>
internal static class PackageTestRunner
{
    private const string Test = "TestAttribute", TearDown = "TearDownAttribute";

    /// <summary>All tests of an assembly, by name.</summary>
    public static IReadOnlyList<MethodInfo> TestsOf(Assembly assembly) =>
        assembly.GetTypes().Where(t => t.IsPublic)
            .SelectMany(t => t.GetMethods().Where(m => Has(m, Test)))
            .OrderBy(NameOf, StringComparer.Ordinal).ToArray();

    public static string NameOf(MethodInfo test) => test.DeclaringType!.Name + "." + test.Name;

    /// <summary>Runs one on an object of its own; what it throws passes through.</summary>
    public static void Run(MethodInfo test)
    {
        object owner = Activator.CreateInstance(test.DeclaringType!)!;
        try
        {
            Call(test, owner);
        }
        finally
        {
            foreach (MethodInfo cleanUp in test.DeclaringType!.GetMethods().Where(m => Has(m, TearDown)))
                Call(cleanUp, owner);
        }
    }

    private static bool Has(MethodInfo method, string attribute) =>
        method.GetCustomAttributesData().Any(a => a.Constructor.DeclaringType!.Name == attribute);

    private static void Call(MethodInfo method, object owner) =>
        ((Action)Delegate.CreateDelegate(typeof(Action), owner, method))();
}
