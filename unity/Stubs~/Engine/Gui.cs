namespace UnityEngine
{
    public class GUILayoutOption
    {
    }

    public class GUI
    {
        /// <summary>The last label, for tests.</summary>
        public static string LastLabel { get; private set; }

        public static void Label(Rect position, string text) => LastLabel = text;
    }
}
