package rasterlab.contract;

/** The rule that says which parts of a polygon that crosses itself are inside. */
public enum FillRule {
    /** A point is inside where a ray from it crosses the outline an odd number of times. */
    EVEN_ODD,
    /** A point is inside where the outline winds around it, in whichever direction. */
    NON_ZERO;

    /**
     * Whether a point is inside.
     *
     * @param winding how often the outline winds around it: edges that cross the row downward to
     *     its left, less those that cross upward there
     */
    public boolean inside(int winding) {
        return this == EVEN_ODD ? (winding & 1) != 0 : winding != 0;
    }
}
