/**
 * Properties of right answers: relations between a method's own answers to two or more inputs, or
 * between an input and its answer, which hold for every right method of a topic.
 *
 * <p>Each assumes a rule of the topic, such as which pixels an end or a tie gets, and is told
 * together with it. A property stands here with the kind of output that it is about; an exercise
 * names it in its data. Start with {@link rasterlab.exercises.property.Property}, then {@link
 * rasterlab.exercises.property.Properties}.
 */
package rasterlab.exercises.property;
