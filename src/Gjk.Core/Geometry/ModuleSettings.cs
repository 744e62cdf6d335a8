#if NET
// Every local is assigned before it is read (the compiler sees to that), so the runtime need not clear the solvers'
// half kilobyte of stack on each call.
[module: System.Runtime.CompilerServices.SkipLocalsInit]
#endif
