/**
 * The exercise on drawing a segment: its cases as data, and how a drawn line is judged.
 *
 * <p>Pixel coordinates: x grows to the right, y grows down. Start with {@link
 * rasterlab.exercises.line.LineCase}.
 */
package rasterlab.exercises.line;
