/**
 * The parts that the exercise on drawing a segment adds to the grading of pixels: the exact pixels
 * with their ties, the traits of segments, and a plain right method.
 *
 * <p>Pixel coordinates: x grows to the right, y grows down. Start with {@link
 * rasterlab.exercises.line.LineGrading}.
 */
package rasterlab.exercises.line;
