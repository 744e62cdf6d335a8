global using Xunit;

// The programs of the pages print to the one standard output of the process.
[assembly: CollectionBehavior(DisableTestParallelization = true)]
