/**
 * The topics that are graded by their own comparison: of each, how its answers are drawn, and a
 * plain right method that a student's speed is held against.
 *
 * <p>A plain method is written as a student writes it: right for ordinary inputs in doubles. Start
 * with {@link rasterlab.exercises.graded.TriangleGrading}.
 */
package rasterlab.exercises.graded;
