/**
 * Which topics can be graded.
 *
 * <p>Start with {@link rasterlab.exercises.topic.TopicGradings}.
 */
package rasterlab.exercises.topic;
