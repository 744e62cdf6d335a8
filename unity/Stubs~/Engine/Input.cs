namespace UnityEngine
{
    public enum KeyCode
    {
        Space = 32,
        N = 110,
        S = 115,
    }

    /// <summary>What is pressed is what a test says.</summary>
    public class Input
    {
        /// <summary>The key that went down in this frame, for tests.</summary>
        public static KeyCode Pressed { get; set; }

        /// <summary>Whether the first button is down, for tests.</summary>
        public static bool IsHeld { get; set; }

        public static Vector3 mousePosition { get; set; }

        public static bool GetMouseButton(int button) => button == 0 && IsHeld;

        public static bool GetKeyDown(KeyCode key) => key == Pressed;
    }
}

namespace UnityEngine.InputSystem
{
    public class Mouse
    {
        public static Mouse current { get; set; }

        public Controls.ButtonControl leftButton { get; } = new Controls.ButtonControl();

        public Controls.Vector2Control position { get; } = new Controls.Vector2Control();
    }

    public class Keyboard
    {
        public static Keyboard current { get; set; }

        public Controls.KeyControl spaceKey { get; } = new Controls.KeyControl();

        public Controls.KeyControl nKey { get; } = new Controls.KeyControl();

        public Controls.KeyControl sKey { get; } = new Controls.KeyControl();
    }
}

namespace UnityEngine.InputSystem.Controls
{
    public class ButtonControl
    {
        public bool isPressed { get; set; }

        public bool wasPressedThisFrame { get; set; }
    }

    public class KeyControl : ButtonControl
    {
    }

    public class Vector2Control
    {
        public UnityEngine.Vector2 ReadValue() => default;
    }
}
