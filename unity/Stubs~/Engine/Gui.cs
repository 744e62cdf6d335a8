namespace UnityEngine
{
    public enum EventType
    {
        MouseDown = 0,
        MouseUp = 1,
        MouseDrag = 3,
        Repaint = 7,
    }

    public sealed class Event
    {
        public static Event current { get; set; } = new Event();

        public EventType type { get; set; }

        public Vector2 mousePosition { get; set; }

        public void Use()
        {
        }
    }

    public class GUILayoutOption
    {
    }

    public class GUILayout
    {
        /// <summary>The last label, for tests.</summary>
        public static string LastLabel { get; private set; }

        public static void Label(string text, params GUILayoutOption[] options) => LastLabel = text;

        public static bool Button(string text, params GUILayoutOption[] options) => false;

        public static bool Toggle(bool value, string text, params GUILayoutOption[] options) => value;

        public static void BeginArea(Rect screenRect)
        {
        }

        public static void EndArea()
        {
        }
    }
}
