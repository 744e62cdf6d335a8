// Every local is assigned before it is read (the compiler sees to that), so the runtime need not clear the solvers'
// half kilobyte of stack on each call. Mono 6.8 clears all the same, what is allocated on the stack, too.
[module: System.Runtime.CompilerServices.SkipLocalsInit]
