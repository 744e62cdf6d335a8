using System.Reflection;
using System.Reflection.Emit;
using System.Reflection.Metadata;
using System.Reflection.Metadata.Ecma335;

namespace Gjk.Core.Tests.Api;

/// <summary>Reads what the C# compiler made of methods.</summary>
internal static class IntermediateCode
{
    private static readonly Dictionary<int, OpCode> Codes = typeof(OpCodes).GetFields(
        BindingFlags.Public | BindingFlags.Static)
        .Select(f => (OpCode)f.GetValue(null)!).ToDictionary(c => c.Value & 0xFFFF);

    /// <summary>The methods that a body takes the address of, for delegates.</summary>
    public static IEnumerable<EntityHandle> DelegateTargets(byte[] body) =>
        Operands(body, OpCodes.Ldftn, OpCodes.Ldvirtftn).Select(MetadataTokens.EntityHandle);

    /// <summary>The methods that a method calls.</summary>
    public static IEnumerable<MethodBase> Calls(MethodBase method) =>
        Operands(method.GetMethodBody()!.GetILAsByteArray()!, OpCodes.Call, OpCodes.Callvirt).Select(
            token => method.Module.ResolveMethod(
                token, method.DeclaringType!.GetGenericArguments(), method.GetGenericArguments())!);

    /// <summary>The tokens behind either of two instructions.</summary>
    private static IEnumerable<int> Operands(byte[] body, OpCode one, OpCode other)
    {
        for (int at = 0; at < body.Length;)
        {
            int value = body[at++];
            if (value == 0xFE) value = value << 8 | body[at++];
            OpCode code = Codes[value];
            if (code == one || code == other) yield return BitConverter.ToInt32(body, at);
            at += code.OperandType switch
            {
                OperandType.InlineNone => 0,
                OperandType.ShortInlineBrTarget or OperandType.ShortInlineI or OperandType.ShortInlineVar => 1,
                OperandType.InlineVar => 2,
                OperandType.InlineI8 or OperandType.InlineR => 8,
                OperandType.InlineSwitch => 4 + 4 * BitConverter.ToInt32(body, at),
                _ => 4,
            };
        }
    }

    /// <summary>Whether a method belongs to a struct.</summary>
    public static bool IsOfStruct(MetadataReader reader, EntityHandle method) => method.Kind switch
    {
        HandleKind.MethodSpecification =>
            IsOfStruct(reader, reader.GetMethodSpecification((MethodSpecificationHandle)method).Method),
        HandleKind.MemberReference =>
            IsStruct(reader, reader.GetMemberReference((MemberReferenceHandle)method).Parent),
        _ => IsStruct(reader, reader.GetMethodDefinition((MethodDefinitionHandle)method).GetDeclaringType()),
    };

    private static bool IsStruct(MetadataReader reader, EntityHandle type)
    {
        if (type.Kind == HandleKind.TypeSpecification)
        {
            TypeSpecification instance = reader.GetTypeSpecification((TypeSpecificationHandle)type);
            BlobReader blob = reader.GetBlobReader(instance.Signature);
            return blob.ReadSignatureTypeCode() == SignatureTypeCode.GenericTypeInstance
                && blob.ReadCompressedInteger() == (int)SignatureTypeKind.ValueType;
        }

        if (type.Kind != HandleKind.TypeDefinition) return false;
        EntityHandle parent = reader.GetTypeDefinition((TypeDefinitionHandle)type).BaseType;
        return parent.Kind == HandleKind.TypeReference
            && reader.GetString(reader.GetTypeReference((TypeReferenceHandle)parent).Name) == "ValueType";
    }
}
