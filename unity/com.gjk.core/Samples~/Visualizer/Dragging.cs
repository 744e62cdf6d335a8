using Gjk.Core;
using Gjk.Unity;
using UnityEngine;

namespace Gjk.Samples
{
    /// <summary>
    /// Moves the object under the mouse in the plane of the screen. Uses the library's own rays and the events of
    /// OnGUI, so that it needs neither colliders nor a certain input package.
    /// </summary>
    internal sealed class Dragging
    {
        private int _dragged = -1;
        private float _depth;
        private Vector3 _grip;

        public void OnGUI(PosedShape[] shapes, MeshFilter[] filters)
        {
            Camera camera = Camera.main;
            Event now = Event.current;
            if (camera == null) return;
            if (now.type == EventType.MouseUp) _dragged = -1;
            if (now.type != EventType.MouseDown && now.type != EventType.MouseDrag) return;

            // OnGUI counts from the top, the camera from the bottom.
            var pixel = new Vector3(now.mousePosition.x, Screen.height - now.mousePosition.y, 0);
            Ray ray = camera.ScreenPointToRay(pixel);
            if (now.type == EventType.MouseDown) Grab(ray, camera, shapes, filters);
            else if (_dragged >= 0) filters[_dragged].transform.position = At(ray, camera) + _grip;
        }

        private void Grab(Ray ray, Camera camera, PosedShape[] shapes, MeshFilter[] filters)
        {
            float nearest = float.PositiveInfinity;
            _dragged = -1;
            for (int i = 0; i < shapes.Length; i++)
            {
                RayCastResult hit = ConvexQuery.RayCast(
                    shapes[i].Shape, shapes[i].Pose, ray.origin.ToNumerics(), ray.direction.ToNumerics());
                if (hit.Status != CastStatus.Hit || hit.Distance >= nearest) continue;
                nearest = hit.Distance;
                _dragged = i;
                Vector3 forward = camera.transform.rotation * Vector3.forward;
                _depth = Vector3.Dot(hit.Point.ToUnity() - camera.transform.position, forward);
            }

            if (_dragged >= 0) _grip = filters[_dragged].transform.position - At(ray, camera);
        }

        /// <summary>Where the ray meets the plane at the depth of the grip.</summary>
        private Vector3 At(Ray ray, Camera camera)
        {
            Vector3 forward = camera.transform.rotation * Vector3.forward;
            float ahead = Vector3.Dot(ray.origin - camera.transform.position, forward);
            return ray.origin + ray.direction * ((_depth - ahead) / Vector3.Dot(ray.direction, forward));
        }
    }
}
