package rasterlab.app.polygon.outcome;

import java.util.List;

/**
 * The triangles that a polygon was cut into, in the method's order.
 *
 * @param of how many there are to be
 */
public record CutAnswer(List<CutTriangle> cuts, int of) implements PolygonAnswer {
    /**
     * A triangle that was cut off at a corner.
     *
     * @param a number of its first corner
     * @param b number of the corner that is cut off
     * @param c number of its last corner; a–c is the diagonal
     * @param turns of three corners computed up to here
     * @param fault what is wrong with it
     */
    public record CutTriangle(int a, int b, int c, long turns, TriangleFault fault) {}

    /** A fault that a triangle can have by itself. */
    public enum TriangleFault {
        NONE,
        CLOCKWISE,
        NO_AREA,
        /** Holds another corner of the polygon. */
        HOLDS_A_CORNER
    }

    public CutAnswer {
        cuts = List.copyOf(cuts);
    }

    @Override
    public int steps() {
        return cuts.size();
    }
}
