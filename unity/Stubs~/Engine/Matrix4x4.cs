using System;

namespace UnityEngine
{
    /// <summary>Column vectors: mRC is row R, column C, and a point is multiplied from the right.</summary>
    public struct Matrix4x4
    {
        public float m00, m10, m20, m30;
        public float m01, m11, m21, m31;
        public float m02, m12, m22, m32;
        public float m03, m13, m23, m33;

        public static Matrix4x4 identity
        {
            get
            {
                var m = default(Matrix4x4);
                m.m00 = m.m11 = m.m22 = m.m33 = 1;
                return m;
            }
        }

        public float this[int row, int column]
        {
            get
            {
                switch (column)
                {
                    case 0: return row == 0 ? m00 : row == 1 ? m10 : row == 2 ? m20 : m30;
                    case 1: return row == 0 ? m01 : row == 1 ? m11 : row == 2 ? m21 : m31;
                    case 2: return row == 0 ? m02 : row == 1 ? m12 : row == 2 ? m22 : m32;
                    case 3: return row == 0 ? m03 : row == 1 ? m13 : row == 2 ? m23 : m33;
                    default: throw new IndexOutOfRangeException("Invalid matrix index!");
                }
            }
        }

        public static Matrix4x4 TRS(Vector3 pos, Quaternion q, Vector3 s)
        {
            Matrix4x4 m = Rotate(q);
            m.m00 *= s.x;
            m.m10 *= s.x;
            m.m20 *= s.x;
            m.m01 *= s.y;
            m.m11 *= s.y;
            m.m21 *= s.y;
            m.m02 *= s.z;
            m.m12 *= s.z;
            m.m22 *= s.z;
            m.m03 = pos.x;
            m.m13 = pos.y;
            m.m23 = pos.z;
            return m;
        }

        public static Matrix4x4 Rotate(Quaternion q)
        {
            float x = q.x * 2, y = q.y * 2, z = q.z * 2;
            Matrix4x4 m = identity;
            m.m00 = 1 - (q.y * y + q.z * z);
            m.m10 = q.x * y + q.w * z;
            m.m20 = q.x * z - q.w * y;
            m.m01 = q.x * y - q.w * z;
            m.m11 = 1 - (q.x * x + q.z * z);
            m.m21 = q.y * z + q.w * x;
            m.m02 = q.x * z + q.w * y;
            m.m12 = q.y * z - q.w * x;
            m.m22 = 1 - (q.x * x + q.y * y);
            return m;
        }

        public static Matrix4x4 operator *(Matrix4x4 lhs, Matrix4x4 rhs)
        {
            Matrix4x4 m = identity;
            Vector3 x = lhs.MultiplyVector(new Vector3(rhs.m00, rhs.m10, rhs.m20));
            Vector3 y = lhs.MultiplyVector(new Vector3(rhs.m01, rhs.m11, rhs.m21));
            Vector3 z = lhs.MultiplyVector(new Vector3(rhs.m02, rhs.m12, rhs.m22));
            Vector3 p = lhs.MultiplyPoint3x4(new Vector3(rhs.m03, rhs.m13, rhs.m23));
            (m.m00, m.m10, m.m20) = (x.x, x.y, x.z);
            (m.m01, m.m11, m.m21) = (y.x, y.y, y.z);
            (m.m02, m.m12, m.m22) = (z.x, z.y, z.z);
            (m.m03, m.m13, m.m23) = (p.x, p.y, p.z);
            return m;
        }

        public Vector3 MultiplyPoint3x4(Vector3 point) =>
            new Vector3(
                m00 * point.x + m01 * point.y + m02 * point.z + m03,
                m10 * point.x + m11 * point.y + m12 * point.z + m13,
                m20 * point.x + m21 * point.y + m22 * point.z + m23);

        public Vector3 MultiplyVector(Vector3 vector) =>
            new Vector3(
                m00 * vector.x + m01 * vector.y + m02 * vector.z,
                m10 * vector.x + m11 * vector.y + m12 * vector.z,
                m20 * vector.x + m21 * vector.y + m22 * vector.z);
    }
}
