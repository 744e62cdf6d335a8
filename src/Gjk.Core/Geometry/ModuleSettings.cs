// Every local is assigned before it is read (the compiler sees to that), so the runtime need not clear the solvers'
// half kilobyte of stack on each call. Mono clears locals all the same, but not what is allocated on the stack.
[module: System.Runtime.CompilerServices.SkipLocalsInit]
