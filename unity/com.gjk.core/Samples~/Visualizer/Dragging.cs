using Gjk.Core;
using Gjk.Unity;
using UnityEngine;

namespace Gjk.Samples
{
    /// <summary>Moves the object under the mouse in the plane of the screen. Uses the library's own rays, so that it
    /// needs no colliders.</summary>
    internal sealed class Dragging
    {
        private int _dragged = -1;
        private bool _wasHeld;
        private float _depth;
        private Vector3 _grip;

        public void Update(PosedShape[] shapes, MeshFilter[] filters)
        {
            Camera camera = Camera.main;
            if (camera == null) return;
            bool isGrabbing = Controls.IsHeld && !_wasHeld;
            _wasHeld = Controls.IsHeld;
            if (!_wasHeld)
            {
                _dragged = -1;
                return;
            }

            Ray ray = camera.ScreenPointToRay(Controls.Pointer);
            if (isGrabbing) Grab(ray, camera, shapes, filters);
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
