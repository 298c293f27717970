/**
 * Speed of the engine's methods beside what a user would pick instead, as ratios within one run.
 *
 * <p>A benchmark class holds a method of ours and its peer on the same input; a {@link
 * rasterlab.tests.bench.Goal} pairs the two and says which ratio is wanted. Times come from JMH and
 * are never asserted: {@code ./lab bench GROUP} prints them. Start with {@link
 * rasterlab.tests.bench.Bench}.
 */
package rasterlab.tests.bench;
