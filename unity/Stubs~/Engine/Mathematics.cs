namespace Unity.Mathematics
{
    public struct float3
    {
        public float x;
        public float y;
        public float z;

        public float3(float x, float y, float z)
        {
            this.x = x;
            this.y = y;
            this.z = z;
        }
    }

    public struct float4
    {
        public float x;
        public float y;
        public float z;
        public float w;
    }

    public struct RigidTransform
    {
        public quaternion rot;
        public float3 pos;

        public RigidTransform(quaternion rotation, float3 translation)
        {
            rot = rotation;
            pos = translation;
        }
    }

    public struct quaternion
    {
        public float4 value;

        public quaternion(float x, float y, float z, float w)
        {
            value.x = x;
            value.y = y;
            value.z = z;
            value.w = w;
        }
    }
}
