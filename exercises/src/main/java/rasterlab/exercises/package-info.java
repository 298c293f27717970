/**
 * Exercises as data, the isolated runner that tries a student's method on them, and the scoring.
 *
 * <p>Start with {@link rasterlab.exercises.Grading}, then {@link rasterlab.exercises.Exercise}.
 */
package rasterlab.exercises;
