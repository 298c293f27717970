/**
 * The pictures of a case's answer, by the kind of output: a grid of pixels, a plane to scale, a
 * table of numbers, an image; expected, actual and their difference, of one size each.
 *
 * <p>Pictures hold no words, for a report is read in several languages; a text goes with each.
 * Start with {@link rasterlab.exercises.drawing.PixelPictures}.
 */
package rasterlab.exercises.drawing;
