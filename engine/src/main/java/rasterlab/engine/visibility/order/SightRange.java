package rasterlab.engine.visibility.order;

/**
 * The range in which doubles tell what hides what: no polygon is narrower, and none is nearer to
 * the eye, than 10⁻⁶ of the largest coordinate.
 *
 * <p>Corners of cuts are rounded to a share of the largest coordinate, some 10⁻¹⁶, and a plane is
 * told apart from another by 10⁻¹³ of it. Within the range both are small beside what is seen.
 */
final class SightRange {
    private static final double LEAST = 1e-6;

    private final Sight sight;
    private final int exponent;
    private final double largest;

    private SightRange(Sight sight) {
        this.sight = sight;
        exponent = sight.exponent();
        largest = Math.scalb(sight.largest(), -exponent);
    }

    /**
     * @throws IllegalArgumentException naming the first polygon that is too narrow or too near
     */
    static void require(Sight sight) {
        var range = new SightRange(sight);
        for (int k = 0; k < sight.size(); k++) range.require(k);
    }

    private void require(int polygon) {
        var flat = new SeenOutline(sight.seen(polygon, -exponent));
        double width = flat.width();
        // A polygon without area is refused elsewhere, with its own message.
        if (width > 0) require(polygon, "wide", width);
        if (width > 0) require(polygon, "from the eye", flat.distance());
    }

    private void require(int polygon, String what, double got) {
        if (got >= LEAST * largest) return;
        throw new IllegalArgumentException(
                "polygon %d must be at least %s %s, 10⁻⁶ of the largest coordinate %s, got %s"
                        .formatted(
                                polygon,
                                LEAST * sight.largest(),
                                what,
                                sight.largest(),
                                Math.scalb(got, exponent)));
    }
}
