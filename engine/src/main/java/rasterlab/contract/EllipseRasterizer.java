package rasterlab.contract;

/**
 * Draws an ellipse about a pixel centre, its axes along rows and columns.
 *
 * <p>With (u, v) counted from the centre and a, b the half-axes along rows and columns, the curve
 * u²/a² + v²/b² = 1 lights, in the quadrant u, v ≥ 0, in each column 0..a the row nearest to it and
 * in each row 0..b the column nearest to it (Freeman's grid-intersect rule, 1961), and the three
 * mirror images. No such crossing of a row or column lies midway between two pixels, so there are
 * no ties. Where a or b is 0, that is a straight line; where both are, one pixel. A circle is the
 * case a = b.
 */
@FunctionalInterface
public interface EllipseRasterizer {
    /**
     * Sends the pixels of the ellipse, in any order.
     *
     * @param centerX column of the centre; centreX ± radiusX has to be an int
     * @param centerY row of the centre; centreY ± radiusY has to be an int
     * @param radiusX half-axis along the rows in pixels, at least 0
     * @param radiusY half-axis along the columns in pixels, at least 0
     * @param out receives each pixel once
     * @throws IllegalArgumentException if a half-axis is below 0 or a pixel would be beyond int; a
     *     method may refuse half-axes above 2¹⁹, too; the message names the value and the range
     */
    void draw(int centerX, int centerY, int radiusX, int radiusY, Pixels out);
}
