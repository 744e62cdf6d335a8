using System.Reflection;

namespace Gjk.Pages;

/// <summary>The name under which the compiler files a member's documentation (ECMA-334, annex D.4.2).</summary>
internal static class MemberId
{
    public static string Of(Type type) => "T:" + Name(type);

    public static string Of(MemberInfo member)
    {
        string owner = Name(member.DeclaringType!);
        return member switch
        {
            FieldInfo field => $"F:{owner}.{field.Name}",
            PropertyInfo property => $"P:{owner}.{property.Name}{Parameters(property.GetIndexParameters())}",
            EventInfo happening => $"E:{owner}.{happening.Name}",
            ConstructorInfo constructor => $"M:{owner}.#ctor{Parameters(constructor.GetParameters())}",
            MethodInfo method =>
                $"M:{owner}.{method.Name}{Arity(method)}{Parameters(method.GetParameters())}{Result(method)}",
            _ => throw new NotSupportedException($"{member.MemberType} {member}"),
        };
    }

    private static string Arity(MethodInfo method) =>
        method.IsGenericMethod ? $"``{method.GetGenericArguments().Length}" : "";

    private static string Result(MethodInfo method) =>
        method.Name is "op_Implicit" or "op_Explicit" ? "~" + Name(method.ReturnType) : "";

    private static string Parameters(ParameterInfo[] parameters) => parameters.Length == 0
        ? ""
        : $"({string.Join(',', parameters.Select(p => Name(p.ParameterType)))})";

    private static string Name(Type type)
    {
        if (type.IsByRef) return Name(type.GetElementType()!) + "@";
        if (type.IsArray) return Name(type.GetElementType()!) + "[]";
        if (type.IsGenericParameter)
            return (type.DeclaringMethod is null ? "`" : "``") + type.GenericParameterPosition;
        if (type.IsGenericType && !type.IsGenericTypeDefinition)
        {
            string open = type.GetGenericTypeDefinition().FullName!.Split('`')[0];
            return $"{open.Replace('+', '.')}{{{string.Join(',', type.GetGenericArguments().Select(Name))}}}";
        }

        return type.FullName!.Replace('+', '.');
    }
}
