/**
 * Changes that a wrong answer may be of the right one, whatever the topic: other signs, another
 * order, x and y exchanged, half of the picture.
 *
 * <p>Start with {@link rasterlab.exercises.change.KnownChanges}.
 */
package rasterlab.exercises.change;
