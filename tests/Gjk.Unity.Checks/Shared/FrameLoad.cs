using System;
using System.Collections.Generic;
using UnityEngine;
using UnityStubs;

namespace Gjk.Unity.Checks;

/// <summary>A small game: moving and resting colliders of every kind, a <see cref="ConvexDistance"/> and a
/// <see cref="ProximitySensor"/>, driven frame by frame.</summary>
internal sealed class FrameLoad : IDisposable
{
    private const int Objects = 60, Period = 20;

    private readonly List<GameObject> _all = [];
    private readonly Action _distance, _sensor;
    private int _frame;

    public FrameLoad()
    {
        var root = Make("root", null);
        for (int i = 0; i < Objects; i++) AddCollider(Make("object " + i, root), i);
        GameObject own = Make("own", null);
        own.AddComponent<BoxCollider>();
        Distance = own.AddComponent<ConvexDistance>();
        Distance.Target = _all[3];
        Sensor = own.AddComponent<ProximitySensor>();
        Sensor.Root = root;
        Sensor.Radius = 3;
        Sensor.Rescan();
        _distance = Messages.Get(Distance, "LateUpdate");
        _sensor = Messages.Get(Sensor, "LateUpdate");
    }

    public ConvexDistance Distance { get; }

    public ProximitySensor Sensor { get; }

    /// <summary>The least and the most that the sensor had near: a test sees that objects came and went.</summary>
    public (int Least, int Most) Near { get; private set; } = (int.MaxValue, 0);

    public void Frame()
    {
        _frame++;
        for (int i = 0; i < _all.Count; i++)
        {
            if (i % 3 == 0 || i == _all.Count - 1) Place(_all[i].transform, i, _frame % Period);
        }

        _distance();
        _sensor();
        Near = (Math.Min(Near.Least, Sensor.Near.Count), Math.Max(Near.Most, Sensor.Near.Count));
    }

    public void Dispose()
    {
        foreach (GameObject made in _all) UnityEngine.Object.DestroyImmediate(made);
        World.Clear();
    }

    private static void Place(Transform t, int i, int step)
    {
        float angle = i + step * 0.31416f;
        t.localPosition = new Vector3(
            8 * (float)Math.Sin(angle), i % 7 - 3, 8 * (float)Math.Cos(angle * 0.5));
        t.localRotation = Quaternion.AngleAxis(18 * step, Vector3.up);
    }

    private static void AddCollider(GameObject owner, int i)
    {
        switch (i % 4)
        {
            case 0:
                owner.AddComponent<BoxCollider>();
                break;
            case 1:
                owner.AddComponent<SphereCollider>();
                owner.isStatic = true;
                break;
            case 2:
                owner.AddComponent<CapsuleCollider>().direction = i % 3;
                break;
            default:
                owner.transform.localScale = new Vector3(1, 2, -0.5f);
                var skewed = new GameObject("skewed");
                skewed.transform.SetParent(owner.transform, false);
                skewed.transform.localRotation = Quaternion.AngleAxis(i, Vector3.right);
                skewed.AddComponent<MeshCollider>().sharedMesh =
                    i % 8 == 3 ? Tests.TestMeshes.Block() : Tests.TestMeshes.Roof(-0.25f);
                break;
        }
    }

    private GameObject Make(string name, GameObject? parent)
    {
        var made = new GameObject(name);
        if (parent is not null) made.transform.SetParent(parent.transform, false);
        Place(made.transform, _all.Count, 0);
        _all.Add(made);
        return made;
    }
}
