package rasterlab.engine.pipeline.wire;

/**
 * Which edges are drawn, and how.
 *
 * @param hidden what becomes of hidden parts
 * @param creaseDegrees an edge between two faces is left out where they meet at less than this
 *     angle between their normals, unless the picture shows one from outside and one from inside; 0
 *     draws every edge, up to 180
 */
public record WireStyle(HiddenLines hidden, double creaseDegrees) {
    /** Every edge, without hidden parts. */
    public static final WireStyle USUAL = new WireStyle(HiddenLines.REMOVED, 0);

    public WireStyle {
        if (!(creaseDegrees >= 0 && creaseDegrees <= 180))
            throw new IllegalArgumentException(
                    "crease must be from 0 to 180 degrees, got " + creaseDegrees);
    }

    /** This style with every part of every edge. */
    public WireStyle withoutHiding() {
        return new WireStyle(HiddenLines.SHOWN, creaseDegrees);
    }
}
