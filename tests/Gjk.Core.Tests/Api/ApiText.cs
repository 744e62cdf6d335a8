using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Text;

namespace Gjk.Core.Tests.Api;

/// <summary>All public types and members of an assembly as sorted lines of text.</summary>
internal static class ApiText
{
    private const BindingFlags Declared =
        BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;

    public static string Of(Assembly assembly)
    {
        var text = new StringBuilder();
        foreach (Type type in assembly.GetExportedTypes().OrderBy(t => t.FullName, StringComparer.Ordinal))
        {
            text.Append(Head(type)).Append('\n');
            foreach (string member
                in type.GetMembers(Declared).Select(m => Member(type, m)).OfType<string>().Order(
                    StringComparer.Ordinal))
                text.Append("    ").Append(member).Append('\n');
        }

        return text.ToString();
    }

    private static string Head(Type t)
    {
        string kind = t.IsEnum ? "enum"
            : t.IsInterface ? "interface"
            : t.IsValueType ? (IsReadOnly(t) ? "readonly struct" : "struct")
            : t.IsAbstract && t.IsSealed ? "static class" : t.IsSealed ? "sealed class" : "class";
        IEnumerable<string> bases = t.GetInterfaces().Where(i => i.IsVisible).Select(Name)
            .Order(StringComparer.Ordinal);
        string inherits = t.IsEnum || !bases.Any() ? "" : " : " + string.Join(", ", bases);
        return $"{kind} {Name(t)}{inherits}{Constraints(t.IsGenericTypeDefinition ? t.GetGenericArguments() : [])}";
    }

    private static bool IsReadOnly(Type t) =>
        t.GetCustomAttributesData().Any(a => a.AttributeType.Name == "IsReadOnlyAttribute");

    private static string? Member(Type owner, MemberInfo member) => member switch
    {
        FieldInfo f when owner.IsEnum =>
            f.IsLiteral ? $"{f.Name} = {Convert.ToInt64(f.GetRawConstantValue(), CultureInfo.InvariantCulture)}" : null,
        FieldInfo f =>
            (f.IsLiteral ? "const " : f.IsStatic ? "static " : "")
            + $"{(f.IsInitOnly ? "readonly " : "")}{Name(f.FieldType)} {f.Name}",
        PropertyInfo p =>
            $"{(p.GetMethod!.IsStatic ? "static " : "")}{Name(p.PropertyType)} {p.Name} "
            + $"{{ get;{(p.SetMethod is { IsPublic: true } ? " set;" : "")} }}",
        ConstructorInfo c => $"new({Parameters(c)})",
        MethodInfo m when m.IsSpecialName && !m.Name.StartsWith("op_", StringComparison.Ordinal) => null,
        MethodInfo m =>
            $"{(m.IsStatic ? "static " : "")}{Name(m.ReturnType)} "
            + $"{m.Name}{Generic(m)}({Parameters(m)}){Constraints(m.IsGenericMethod ? m.GetGenericArguments() : [])}",
        Type => null,
        _ => member.ToString(),
    };

    private static string Generic(MethodInfo m) =>
        m.IsGenericMethod ? $"<{string.Join(", ", m.GetGenericArguments().Select(Name))}>" : "";

    private static string Constraints(Type[] parameters) => string.Concat(parameters.Select(p =>
    {
        bool isStruct = (p.GenericParameterAttributes & GenericParameterAttributes.NotNullableValueTypeConstraint) != 0;
        string[] all =
        [
            .. isStruct ? ["struct"] : Array.Empty<string>(),
            .. p.GetGenericParameterConstraints().Where(c => c != typeof(ValueType)).Select(Name),
        ];
        return all.Length == 0 ? "" : $" where {p.Name} : {string.Join(", ", all)}";
    }));

    private static string Parameters(MethodBase m) => string.Join(", ", m.GetParameters().Select(p =>
    {
        string direction = !p.ParameterType.IsByRef ? "" : p.IsOut ? "out " : p.IsIn ? "in " : "ref ";
        object? given = p.HasDefaultValue ? p.DefaultValue ?? "default" : null;
        string value = given switch
        {
            null => "",
            IFormattable f => " = " + f.ToString(null, CultureInfo.InvariantCulture),
            _ => " = " + given,
        };
        return $"{direction}{Name(p.ParameterType)} {p.Name}{value}";
    }));

    private static string Name(Type t)
    {
        if (t.IsByRef) return Name(t.GetElementType()!);
        if (t.IsArray) return Name(t.GetElementType()!) + "[]";
        if (!t.IsGenericType) return t.Name;
        return $"{t.Name[..t.Name.IndexOf('`')]}<{string.Join(", ", t.GetGenericArguments().Select(Name))}>";
    }
}
