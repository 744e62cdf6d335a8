using System;

namespace NUnit.Framework
{
    public class TestAttribute : Attribute
    {
    }

    public class TearDownAttribute : Attribute
    {
    }

    public delegate void TestDelegate();

    public class AssertionException : Exception
    {
        public AssertionException(string message)
            : base(message)
        {
        }
    }

    public abstract class Assert
    {
        public static void IsTrue(bool condition, string message, params object[] args)
        {
            if (!condition) throw new AssertionException(message);
        }

        public static void IsTrue(bool condition) => IsTrue(condition, "Expected: True");

        public static void IsFalse(bool condition) => IsTrue(!condition, "Expected: False");

        public static void IsFalse(bool condition, string message, params object[] args) => IsTrue(!condition, message);

        public static void AreEqual(object expected, object actual) =>
            IsTrue(Equals(expected, actual), "Expected: " + expected + ", but was: " + actual);

        public static void AreEqual(double expected, double actual, double delta) =>
            IsTrue(
                Math.Abs(expected - actual) <= delta || (double.IsNaN(expected) && double.IsNaN(actual)),
                "Expected: " + expected + ", but was: " + actual);

        public static void AreSame(object expected, object actual) =>
            IsTrue(ReferenceEquals(expected, actual), "Expected the same object.");

        public static TActual Throws<TActual>(TestDelegate code) where TActual : Exception
        {
            try
            {
                code();
            }
            catch (TActual exception) when (exception.GetType() == typeof(TActual))
            {
                return exception;
            }

            throw new AssertionException("Expected: " + typeof(TActual).Name);
        }
    }

    public abstract class StringAssert
    {
        public static void Contains(string expected, string actual) =>
            Assert.IsTrue(actual != null && actual.Contains(expected), "'" + actual + "' lacks '" + expected + "'");
    }
}
