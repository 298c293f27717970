package rasterlab.engine.visibility.buffer;

import java.util.OptionalDouble;
import rasterlab.engine.visibility.NearnessPlane;
import rasterlab.engine.visibility.ScreenPolygon;
import rasterlab.engine.visibility.ViewedMesh;

/** The depth that a face offers to one pixel of a depth buffer. */
final class OfferedDepth {
    private OfferedDepth() {}

    /**
     * Computes the depth along the face's whole span, as the buffer does, since a sum along it
     * drifts.
     *
     * @param width of the picture
     * @param height of the picture
     * @return as it is stored; empty where the face does not own the pixel
     */
    static OptionalDouble at(
            int x, int y, int width, int height, ViewedMesh view, int face, DepthCodes depths) {
        var plane = new NearnessPlane();
        if (!plane.load(view, face)) return OptionalDouble.empty();
        var polygon = new ScreenPolygon(view);
        polygon.load(view, face);
        var codes = new int[width];
        var found = new double[] {Double.NaN};
        polygon.fill(
                width,
                height,
                (row, from, to) -> {
                    if (row != y || x < from || x >= to) return;
                    depths.row(plane.base + row * plane.perRow, plane.perColumn, from, to, codes);
                    found[0] = depths.depth(codes[x - from]);
                });
        return Double.isNaN(found[0]) ? OptionalDouble.empty() : OptionalDouble.of(found[0]);
    }
}
