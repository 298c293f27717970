/**
 * Marking decides what the tried cases are worth: which case pays for a mistake, and what all
 * failures share.
 *
 * <p>Nothing is run here. Start with {@link rasterlab.exercises.marking.Marking}.
 */
package rasterlab.exercises.marking;
