package rasterlab.engine.visibility.order;

/**
 * A facet with the box round it: in depth, and in x/z and y/z on the picture.
 *
 * <p>All its corners are in front of the eye, z &gt; 0.
 */
final class FacetExtent {
    /** Depths that differ by less than this factor may be equal but for rounding. */
    private static final double LEVEL = 1 + 0x1p-44;

    private final Facet facet;
    private double leastX = Double.POSITIVE_INFINITY;
    private double mostX = Double.NEGATIVE_INFINITY;
    private double leastY = Double.POSITIVE_INFINITY;
    private double mostY = Double.NEGATIVE_INFINITY;
    private double leastZ = Double.POSITIVE_INFINITY;
    private double mostZ = Double.NEGATIVE_INFINITY;

    /**
     * @throws IllegalArgumentException naming the polygon if it reaches behind the eye
     */
    FacetExtent(Facet facet, EyeFrame frame) {
        this.facet = facet;
        double[] seen = facet.seen();
        for (int i = 0; i < seen.length / 3; i++) {
            double z = frame.z(seen, i);
            if (!(z > 0))
                throw new IllegalArgumentException(
                        "polygon %d, corner %d must be in front of the eye, which looks at the"
                                        .formatted(facet.polygon(), i)
                                + " middle of the box round all; clip the polygons first");
            include(frame.x(seen, i) / z, frame.y(seen, i) / z, z);
        }
    }

    private void include(double x, double y, double z) {
        leastX = Math.min(leastX, x);
        mostX = Math.max(mostX, x);
        leastY = Math.min(leastY, y);
        mostY = Math.max(mostY, y);
        leastZ = Math.min(leastZ, z);
        mostZ = Math.max(mostZ, z);
    }

    Facet facet() {
        return facet;
    }

    double mostZ() {
        return mostZ;
    }

    /** Whether every point of the other is nearer than all of this, or level with its nearest. */
    boolean behind(FacetExtent other) {
        return leastZ >= other.mostZ;
    }

    /** Whether every point of the other is nearer than all of this by more than rounding. */
    boolean clearlyBehind(FacetExtent other) {
        return leastZ > other.mostZ * LEVEL;
    }

    boolean apartInX(FacetExtent other) {
        return leastX >= other.mostX || other.leastX >= mostX;
    }

    boolean apartInY(FacetExtent other) {
        return leastY >= other.mostY || other.leastY >= mostY;
    }
}
