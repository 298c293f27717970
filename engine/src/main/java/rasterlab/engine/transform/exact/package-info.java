/**
 * Slow arithmetic of many digits for the exact references of all transformations: sines and cosines
 * of degrees, matrix products, rotations.
 *
 * <p>Points are rows, as in the textbook. 60 significant digits, so that a result rounded to a
 * double is right even after twenty digits have cancelled. No method uses anything from here.
 */
package rasterlab.engine.transform.exact;
