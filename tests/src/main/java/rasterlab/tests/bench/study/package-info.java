/**
 * Checks of how studies measure: whether two runs say the same, whether a method that was slowed on
 * purpose is found slower, and whether a busy machine leads to a wrong order.
 *
 * <p>Start with {@link rasterlab.tests.bench.study.StudyBench}.
 */
package rasterlab.tests.bench.study;
