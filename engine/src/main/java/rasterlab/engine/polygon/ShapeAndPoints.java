package rasterlab.engine.polygon;

/**
 * A polygon and the points to judge by it.
 *
 * @param corners at least 3
 * @param points at least 1
 */
public record ShapeAndPoints(Points corners, Points points) {
    public ShapeAndPoints {
        if (corners.size() < 3)
            throw new IllegalArgumentException(
                    "a polygon needs at least 3 corners, got " + corners.size());
        if (points.size() < 1) throw new IllegalArgumentException("no point to judge");
    }
}
