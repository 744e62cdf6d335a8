namespace UnityEngine
{
    public struct Color
    {
        public float r;
        public float g;
        public float b;
        public float a;

        public Color(float r, float g, float b)
        {
            this.r = r;
            this.g = g;
            this.b = b;
            a = 1;
        }

        public static Color red => new Color(1, 0, 0);

        public static Color green => new Color(0, 1, 0);

        public static Color blue => new Color(0, 0, 1);

        public static Color white => new Color(1, 1, 1);

        public static Color yellow => new Color(1, 0.92156863f, 0.015686275f);

        public static Color gray => new Color(0.5f, 0.5f, 0.5f);
    }

    public struct Rect
    {
        public Rect(float x, float y, float width, float height)
        {
            this.x = x;
            this.y = y;
            this.width = width;
            this.height = height;
        }

        public float x { get; set; }

        public float y { get; set; }

        public float width { get; set; }

        public float height { get; set; }
    }

    public struct Ray
    {
        public Ray(Vector3 origin, Vector3 direction)
        {
            this.origin = origin;
            this.direction = direction;
        }

        public Vector3 origin { get; set; }

        public Vector3 direction { get; set; }
    }

    public class Shader : Object
    {
    }

    public class Material : Object
    {
        public Material()
        {
        }

        public Material(Shader shader) => this.shader = shader;

        public Color color { get; set; }

        public Shader shader { get; set; }
    }

    public class Renderer : Component
    {
        public Material sharedMaterial { get; set; } = new Material();

        public Material material
        {
            get => sharedMaterial;
            set => sharedMaterial = value;
        }
    }

    public class Camera : Behaviour
    {
        public static Camera main { get; set; }

        public Ray ScreenPointToRay(Vector3 pos) => new Ray(transform.position, transform.rotation * Vector3.forward);
    }

    public sealed class Gizmos
    {
        public static Color color { get; set; }

        /// <summary>The last line's ends, for tests.</summary>
        public static Vector3[] LastLine { get; private set; }

        public static void DrawLine(Vector3 from, Vector3 to) => LastLine = new[] { from, to };
    }

    public class Debug
    {
        /// <summary>The last warning, for tests; the engine has no such member.</summary>
        public static string LastWarning { get; private set; }

        /// <summary>How many warnings there were, for tests.</summary>
        public static int WarningCount { get; private set; }

        public static bool isDebugBuild => false;

        public static void LogWarning(object message, Object context)
        {
            LastWarning = message.ToString();
            WarningCount++;
        }

        /// <summary>How many exceptions were logged, for tests.</summary>
        public static int ExceptionCount { get; private set; }

        public static void LogException(System.Exception exception, Object context) => ExceptionCount++;

        /// <summary>How many lines were drawn, for tests.</summary>
        public static int LineCount { get; set; }

        public static void DrawLine(Vector3 start, Vector3 end, Color color) => LineCount++;
    }

    public class Application
    {
        public static bool isPlaying { get; set; }

        public static bool isEditor => false;

        public static string unityVersion => "2021.3.0f1";
    }

    public class Time
    {
        /// <summary>The engine's has no setter; tests make frames with it.</summary>
        public static int frameCount { get; set; }
    }

    public struct Mathf
    {
        public const float Infinity = float.PositiveInfinity;
    }

    public struct LayerMask
    {
        private int _mask;

        public int value
        {
            get => _mask;
            set => _mask = value;
        }

        public static implicit operator int(LayerMask mask) => mask._mask;

        public static implicit operator LayerMask(int intVal)
        {
            LayerMask mask = default;
            mask._mask = intVal;
            return mask;
        }
    }

    public class Screen
    {
        public static int width { get; set; } = 1280;

        public static int height { get; set; } = 800;
    }
}

namespace UnityEngine.Rendering
{
    public class RenderPipelineAsset : ScriptableObject
    {
        public virtual Material defaultMaterial { get; set; }

        public virtual Shader defaultShader { get; set; }
    }

    public sealed class GraphicsSettings : Object
    {
        /// <summary>The engine's has no setter.</summary>
        public static RenderPipelineAsset currentRenderPipeline { get; set; }
    }
}
