/**
 * How long the server's judge takes for a student's source, and what servers make of load, of
 * faults of the machine, and of being killed. Start with {@link
 * rasterlab.tests.bench.grader.GraderBench}; a fault is a {@link
 * rasterlab.tests.bench.grader.ServerFault}.
 */
package rasterlab.tests.bench.grader;
