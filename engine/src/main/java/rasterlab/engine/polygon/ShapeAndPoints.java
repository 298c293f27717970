package rasterlab.engine.polygon;

/**
 * A polygon and the points to judge by it.
 *
 * @param corners at least 3
 * @param points perhaps none
 */
public record ShapeAndPoints(Points corners, Points points) {
    public ShapeAndPoints {
        if (corners.size() < 3)
            throw new IllegalArgumentException(
                    "a polygon needs at least 3 corners, got " + corners.size());
    }
}
