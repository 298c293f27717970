package rasterlab.engine.polygon.scan;

/**
 * An edge where a row crosses it, in pixel coordinates.
 *
 * @param upperX the edge's end with the smaller y
 * @param upperY smaller than {@code lowerY}
 * @param x where the row crosses, rounded
 * @param column the first one of the picture that counts as crossed, or its width
 * @param winding 1 where the outline follows the edge downward, −1 where upward
 */
public record RowCrossing(
        double upperX,
        double upperY,
        double lowerX,
        double lowerY,
        double x,
        int column,
        int winding) {}
