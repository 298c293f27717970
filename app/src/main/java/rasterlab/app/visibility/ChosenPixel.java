package rasterlab.app.visibility;

/**
 * The pixel whose history is shown.
 *
 * @param second whether in the other method's picture
 * @param x column
 * @param y row
 */
record ChosenPixel(boolean second, int x, int y) {}
