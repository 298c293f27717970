package rasterlab.contract;

/**
 * Fills a polygon whose corners lie anywhere between the pixel centres.
 *
 * <p>Whole coordinates are pixel centres. A pixel belongs to the polygon when its centre is inside;
 * a centre on an edge belongs to the side right of it, and on a level edge to the side below it: a
 * left or top edge owns its centres, a right or bottom edge does not. So polygons that share an
 * edge share no pixel and leave none out. Exactly: an edge from row y0 down to row y1 crosses row y
 * when y0 ≤ y &lt; y1, and the columns at or right of where it does gain its direction, +1 when it
 * leads down and −1 when it leads up; {@link FillRule} says which sums are inside.
 *
 * <p>The last corner is joined to the first. Less than three corners, corners on one line and a
 * polygon outside the picture own nothing.
 */
@FunctionalInterface
public interface PolygonFiller {
    /**
     * Sends the polygon's pixels inside the picture.
     *
     * @param x columns of the corners, finite, at most 1e100 from 0
     * @param y rows of the corners, as many, in the same range
     * @param width of the picture: columns 0 to width − 1 are filled, 1 to 8192
     * @param height of the picture: rows 0 to height − 1 are filled, 1 to 8192
     * @param out receives each pixel once, rows from top to bottom, each row from left to right
     * @throws IllegalArgumentException if a value is outside its range; a method that looks at all
     *     pixels for each edge may refuse more than 10⁹ such looks; the message names the value and
     *     the range
     */
    void fill(double[] x, double[] y, FillRule rule, int width, int height, Spans out);
}
