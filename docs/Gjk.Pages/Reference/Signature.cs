using System.Reflection;

namespace Gjk.Pages;

/// <summary>A type or member as a reader of C# would write it, without attributes.</summary>
internal static class Signature
{
    private static readonly Dictionary<Type, string> Keywords = new()
    {
        [typeof(bool)] = "bool",
        [typeof(int)] = "int",
        [typeof(uint)] = "uint",
        [typeof(long)] = "long",
        [typeof(ulong)] = "ulong",
        [typeof(float)] = "float",
        [typeof(double)] = "double",
        [typeof(string)] = "string",
        [typeof(object)] = "object",
        [typeof(void)] = "void",
    };

    private static readonly Dictionary<string, string> Operators = new()
    {
        ["op_Addition"] = "+",
        ["op_Subtraction"] = "-",
        ["op_UnaryNegation"] = "-",
        ["op_Multiply"] = "*",
        ["op_Division"] = "/",
    };

    public static string Of(Type type)
    {
        string kind = type.IsInterface ? "interface"
            : type.IsEnum ? "enum"
            : type.IsValueType ? "struct"
            : type is { IsAbstract: true, IsSealed: true } ? "static class" : "class";
        return $"{kind} {Name(type)}";
    }

    public static string Of(MemberInfo member) => member switch
    {
        FieldInfo { DeclaringType.IsEnum: true } field =>
            $"{field.Name} = {Convert.ToInt64(field.GetRawConstantValue())}",
        FieldInfo field => $"{Static(field.IsStatic)}{Name(field.FieldType)} {field.Name}",
        PropertyInfo property => Of(property),
        ConstructorInfo constructor => $"{Short(constructor.DeclaringType!)}({Parameters(constructor)})",
        MethodInfo { Name: "op_Implicit" or "op_Explicit" } method =>
            $"static {method.Name[3..].ToLowerInvariant()} operator {Name(method.ReturnType)}({Parameters(method)})",
        MethodInfo method when Operators.TryGetValue(method.Name, out string? sign) =>
            $"static {Name(method.ReturnType)} operator {sign}({Parameters(method)})",
        MethodInfo method =>
            $"{Static(method.IsStatic)}{Name(method.ReturnType)} {method.Name}{Generic(method)}({Parameters(method)})",
        _ => member.Name,
    };

    private static string Of(PropertyInfo property)
    {
        ParameterInfo[] index = property.GetIndexParameters();
        string name = index.Length == 0 ? property.Name : $"this[{string.Join(", ", index.Select(Parameter))}]";
        string set = property.SetMethod is { IsPublic: true } ? " set;" : "";
        return $"{Static(property.GetMethod!.IsStatic)}{Name(property.PropertyType)} {name} {{ get;{set} }}";
    }

    private static string Static(bool isStatic) => isStatic ? "static " : "";

    private static string Generic(MethodInfo method) =>
        method.IsGenericMethod ? $"<{string.Join(", ", method.GetGenericArguments().Select(Name))}>" : "";

    private static string Parameters(MethodBase method) => string.Join(", ", method.GetParameters().Select(Parameter));

    private static string Parameter(ParameterInfo parameter)
    {
        string way = !parameter.ParameterType.IsByRef ? "" : parameter.IsOut ? "out " : parameter.IsIn ? "in " : "ref ";
        string value = !parameter.HasDefaultValue ? "" : $" = {Value(parameter)}";
        return $"{way}{Name(parameter.ParameterType)} {parameter.Name}{value}";
    }

    private static string Value(ParameterInfo parameter) => parameter.RawDefaultValue switch
    {
        null => parameter.ParameterType.IsByRef || parameter.ParameterType.IsValueType ? "default" : "null",
        bool value => value ? "true" : "false",
        float.PositiveInfinity => "infinity",
        string text => $"\"{text}\"",
        { } value when parameter.ParameterType.IsEnum => $"{Enum.ToObject(parameter.ParameterType, value)}",
        IFormattable value => value.ToString(null, System.Globalization.CultureInfo.InvariantCulture),
        { } value => $"{value}",
    };

    private static string Short(Type type) => type.Name.Split('`')[0];

    private static string Name(Type type)
    {
        if (type.IsByRef) return Name(type.GetElementType()!);
        if (type.IsArray) return Name(type.GetElementType()!) + "[]";
        if (Nullable.GetUnderlyingType(type) is { } inner) return Name(inner) + "?";
        if (Keywords.TryGetValue(type, out string? keyword)) return keyword;
        return type.IsGenericType
            ? $"{Short(type)}<{string.Join(", ", type.GetGenericArguments().Select(Name))}>"
            : type.Name;
    }

    /// <summary>Whether it is an operator or a conversion; whether values are equal every type can say.</summary>
    public static bool IsOperator(MemberInfo member) =>
        member.Name is "op_Implicit" or "op_Explicit" || Operators.ContainsKey(member.Name);

    /// <summary>Members that every type has, or that the compiler made.</summary>
    public static bool IsWorthListing(MemberInfo member) =>
        member is not MethodInfo method
        || IsOperator(method) || (!method.IsSpecialName && !method.Name.StartsWith('<')
            && method.Name is not ("Equals" or "GetHashCode" or "ToString" or "GetType"));
}
