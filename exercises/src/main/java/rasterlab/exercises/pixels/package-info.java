/**
 * Answers that are pixels in an order from one end to the other, whatever the topic: what is told
 * of a wrong one by its ends, its place, its order and its repetitions, the pictures of it, and the
 * mistakes with which a method may be timed.
 *
 * <p>Pixel coordinates: x grows to the right, y grows down. Start with {@link
 * rasterlab.exercises.pixels.PixelsByTopic}.
 */
package rasterlab.exercises.pixels;
