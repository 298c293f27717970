/**
 * Judging compares what a method answered with the topic's exact answer and says what is wrong.
 *
 * <p>Start with {@link rasterlab.exercises.judging.ByTopic}.
 */
package rasterlab.exercises.judging;
