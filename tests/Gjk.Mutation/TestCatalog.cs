using System.IO;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Threading.Tasks;

namespace Gjk.Mutation;

/// <summary>The facts and the rows of the theories of a test assembly, called by reflection: xunit's own runners cannot
/// change what is tested between two tests of one process.</summary>
internal sealed class TestCatalog
{
    private readonly SortedDictionary<string, MethodInfo> _methods = new(StringComparer.Ordinal);
    private readonly Dictionary<string, List<object?[]>> _rows = [];
    private readonly FieldInfo _active;

    public TestCatalog(string path)
    {
        Assembly assembly = Assembly.LoadFrom(path);
        Assembly library = Assembly.LoadFrom(Path.Combine(Path.GetDirectoryName(path)!, "Gjk.Core.dll"));
        Type mutation = library.GetType("Gjk.Core.Mutation", true)!;
        _active = mutation.GetField("Active")!;
        Reached = (byte[]?)mutation.GetField("Reached")?.GetValue(null);
        foreach (Type type in assembly.GetTypes().Where(t => !t.IsAbstract))
            foreach (MethodInfo test in type.GetMethods().Where(m => Fact(m) is not null))
                _methods.Add($"{type.Name}.{test.Name}", test);
    }

    /// <summary>Which places were reached, in a recording build.</summary>
    public byte[]? Reached { get; }

    /// <summary>The tests by name.</summary>
    public IEnumerable<string> Methods => _methods.Keys;

    /// <summary>The mutant that is on; 0 is none.</summary>
    public int Active
    {
        set => _active.SetValue(null, value);
    }

    /// <summary>How many times a method is to be called.</summary>
    public int RowsOf(string method) => Rows(method).Count;

    /// <summary>Runs a test; null where it passes, else what it says.</summary>
    public string? Run(string method, int row, int mutant)
    {
        Active = 0;
        MethodInfo test = _methods[method];
        object?[] arguments = Rows(method)[row];
        try
        {
            // What a class computes once must not be a mutant's.
            RuntimeHelpers.RunClassConstructor(test.DeclaringType!.TypeHandle);
            if (test.IsGenericMethodDefinition) test = Closed(test, arguments);
            Active = mutant;
            object instance = New(test.DeclaringType!);
            object? result = test.Invoke(instance, Converted(test, arguments));
            (result as Task)?.GetAwaiter().GetResult();
            (instance as IDisposable)?.Dispose();
            return null;
        }
        catch (Exception e)
        {
            Exception cause = e is TargetInvocationException { InnerException: { } inner } ? inner : e;
            return $"{cause.GetType().Name}: {cause.Message.Replace('\n', ' ').Replace('\r', ' ')}";
        }
        finally
        {
            Active = 0;
        }
    }

    private List<object?[]> Rows(string method)
    {
        if (_rows.TryGetValue(method, out List<object?[]>? known)) return known;
        MethodInfo test = _methods[method];
        List<object?[]> rows = [];
        foreach (Attribute data in test.GetCustomAttributes().Where(a => IsNamed(a.GetType(), "DataAttribute")))
        {
            MethodInfo get = data.GetType().GetMethod("GetData", [typeof(MethodInfo)])!;
            rows.AddRange((IEnumerable<object?[]>)get.Invoke(data, [test])!);
        }

        if (test.GetParameters().Length == 0) rows = [[]];
        return _rows[method] = rows;
    }

    private static Attribute? Fact(MethodInfo method) =>
        method.GetCustomAttributes().FirstOrDefault(
            a => IsNamed(a.GetType(), "FactAttribute") && a.GetType().GetProperty("Skip")!.GetValue(a) is null);

    private static bool IsNamed(Type? type, string name) =>
        type is not null && (type.Name == name || IsNamed(type.BaseType, name));

    private static object New(Type type)
    {
        ConstructorInfo constructor = type.GetConstructors()[0];
        object[] output = [.. constructor.GetParameters().Select(
            p => (object)DispatchProxy.Create(p.ParameterType, typeof(Silence)))];
        return constructor.Invoke(output);
    }

    private static MethodInfo Closed(MethodInfo test, object?[] arguments)
    {
        ParameterInfo[] parameters = test.GetParameters();
        return test.MakeGenericMethod([.. test.GetGenericArguments().Select(
            g => arguments[Array.FindIndex(parameters, p => p.ParameterType == g)]!.GetType())]);
    }

    private static object?[] Converted(MethodInfo test, object?[] arguments)
    {
        ParameterInfo[] parameters = test.GetParameters();
        var converted = new object?[parameters.Length];
        for (int i = 0; i < parameters.Length; i++)
        {
            object? value = i < arguments.Length ? arguments[i] : parameters[i].DefaultValue;
            Type type = parameters[i].ParameterType;
            if (parameters[i].IsDefined(typeof(ParamArrayAttribute)) && !type.IsInstanceOfType(value))
            {
                var rest = Array.CreateInstance(type.GetElementType()!, Math.Max(0, arguments.Length - i));
                for (int k = 0; k < rest.Length; k++) rest.SetValue(arguments[i + k], k);
                value = rest;
            }

            bool fits = value is null || type.IsInstanceOfType(value);
            converted[i] = fits || value is not IConvertible || type.IsEnum
                ? value
                : Convert.ChangeType(value, Nullable.GetUnderlyingType(type) ?? type);
        }

        return converted;
    }

    /// <summary>An ITestOutputHelper that says nothing.</summary>
    public class Silence : DispatchProxy
    {
        protected override object? Invoke(MethodInfo? targetMethod, object?[]? args) => null;
    }
}
