using UnityEngine;
using UnityEngine.Rendering;
#if !ENABLE_LEGACY_INPUT_MANAGER
using UnityEngine.InputSystem;
#endif

namespace Gjk.Samples
{
    /// <summary>The mouse and two keys, from whichever of Unity's input packages the project uses, and a material that
    /// its render pipeline can show.</summary>
    internal static class Controls
    {
#if ENABLE_LEGACY_INPUT_MANAGER
        public static bool IsHeld => Input.GetMouseButton(0);

        public static Vector2 Pointer => new Vector2(Input.mousePosition.x, Input.mousePosition.y);

        public static bool WasNextPressed => Input.GetKeyDown(KeyCode.N);

        public static bool WasSearchPressed => Input.GetKeyDown(KeyCode.S);
#else
        public static bool IsHeld => Mouse.current != null && Mouse.current.leftButton.isPressed;

        public static Vector2 Pointer => Mouse.current != null ? Mouse.current.position.ReadValue() : default;

        public static bool WasNextPressed => Keyboard.current != null && Keyboard.current.nKey.wasPressedThisFrame;

        public static bool WasSearchPressed => Keyboard.current != null && Keyboard.current.sKey.wasPressedThisFrame;
#endif

        /// <summary>The scene names the built-in pipeline's material, which others show in pink.</summary>
        public static void MakeVisible(Renderer renderer)
        {
            RenderPipelineAsset pipeline = GraphicsSettings.currentRenderPipeline;
            if (pipeline == null) return;

            // In a build some pipelines have no default material, but all have a shader.
            Material material = pipeline.defaultMaterial;
            renderer.sharedMaterial = material != null ? material : new Material(pipeline.defaultShader);
        }
    }
}
