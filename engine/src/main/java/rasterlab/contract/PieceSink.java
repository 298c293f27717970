package rasterlab.contract;

/** Takes polygons in space, or pieces of them, in the order in which they are to be painted. */
@FunctionalInterface
public interface PieceSink {
    /**
     * @param polygon number of the polygon, from 0
     * @param corners x, y, z of each corner, going round as the polygon does: the polygon's own, or
     *     those of a convex piece of it; not to be kept or changed
     */
    void piece(int polygon, double[] corners);
}
