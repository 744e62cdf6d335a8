# A rotation matrix in double, from a quaternion of floats: how far an element is off, and the factor that all of them
# share.
# supports: placed.g, world-bounds.g and ray-foot.g, which take its bounds
# code: src/Gjk.Core/Geometry/RotationD.cs, RotationD and Set
# assumed: the quaternion's length is within 1e-3 of 1 (Guard, RigidPose.UnitTolerance), so all ranges are true ones
# control: e = 3b-53;
e = 503e-2 * 1b-53;
@single = float<ieee_32, ne>;
@double = float<ieee_64, ne>;
x = single(x_);
y = single(y_);
z = single(z_);
w = single(w_);

# The squared length, and 2 over it. Products of two floats are exact.
n double= x * x + y * y + z * z + w * w;
N = x * x + y * y + z * z + w * w;
scale = double(2 / n);
S = 2 / N;

# With whatever factor s, one element of the diagonal and one beside it; the others are alike.
s = double(s_);
m00 double= 1 - (y * y + z * z) * s;
M00 = 1 - (y * y + z * z) * s;
xys double= x * y * s;
wzs double= w * z * s;
m01 double= xys - wzs;
M01 = x * y * s - w * z * s;
{ N in [998e-3, 1002e-3] /\ x * x + y * y in [0, 1002e-3] /\ x * x + y * y + z * z in [0, 1002e-3]
  /\ y * y + z * z in [0, 1002e-3] /\ |x * y| <= 501e-3 /\ |w * z| <= 501e-3 /\ |x| <= 1001e-3 /\ |y| <= 1001e-3
  /\ |z| <= 1001e-3 /\ |w| <= 1001e-3 /\ s in [1995e-3, 2005e-3] /\ |M00| <= 1003e-3 /\ |M01| <= 1003e-3
  -> |m00 - M00| / e <= 1 /\ |m01 - M01| / (302e-2 * 1b-53) <= 1 /\ |(scale - S) / S| / (402e-2 * 1b-53) <= 1
  /\ |n - N| / (301e-2 * 1b-53) <= 1 }
