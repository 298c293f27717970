package rasterlab.engine.pipeline.fast;

import rasterlab.engine.scene.VertexQuantity;

/**
 * Cuts a triangle before the division by w: near, far, w = 0, the guard's four sides, then the
 * user's planes, each in turn.
 *
 * <p>A new vertex is computed from the end inside to the end outside, so two triangles that share
 * an edge get bit-equal vertices on it. Clip coordinates, and all that a vertex carries, are linear
 * along an edge here, which they are no longer after the division.
 *
 * <p>Source: I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Communications of the ACM
 * 17(1), 1974, pp. 32–42; in homogeneous coordinates: J. F. Blinn, M. E. Newell, Clipping using
 * homogeneous coordinates, SIGGRAPH 1978, pp. 245–251.
 */
final class Clipper {
    /** Each plane adds a corner at most: 3 + 7 + 6. */
    private static final int MOST_CORNERS = 10 + TriangleView.MOST_PLANES;

    private static final int OWN_PLANES = 7;

    private ClipPolygon polygon = new ClipPolygon(MOST_CORNERS);
    private ClipPolygon next = new ClipPolygon(MOST_CORNERS);
    private final double[] distances = new double[MOST_CORNERS];

    /**
     * Cuts a triangle of the frame.
     *
     * @return what is left, possibly fewer than three corners; good until the next call
     */
    ClipPolygon clip(FrameState frame, int a, int b, int c) {
        polygon.size = 0;
        addVertex(frame, a);
        addVertex(frame, b);
        addVertex(frame, c);
        int planes = OWN_PLANES + frame.view.worldPlanes().length;
        for (int plane = 0; plane < planes && polygon.size >= 3; plane++) cut(plane);
        return polygon;
    }

    private void addVertex(FrameState frame, int vertex) {
        float x = frame.mesh.values(VertexQuantity.X)[vertex];
        float y = frame.mesh.values(VertexQuantity.Y)[vertex];
        float z = frame.mesh.values(VertexQuantity.Z)[vertex];
        float[] matrix = frame.view.toClip();
        int at = polygon.add(vertex);
        for (int i = 0; i < 4; i++) polygon.values[at][i] = VertexStage.dot(matrix, i, x, y, z);
        polygon.attributes = frame.attributeCount;
        polygon.planes = frame.view.worldPlanes().length;
        for (int k = 0; k < polygon.planes; k++)
            polygon.values[at][4 + k] = ClipCode.distance(frame.view.worldPlanes()[k], x, y, z);
        for (int k = 0; k < polygon.attributes; k++)
            polygon.values[at][4 + polygon.planes + k] = frame.vertices.attribute(k, vertex);
    }

    private void cut(int plane) {
        boolean anyOutside = false;
        for (int k = 0; k < polygon.size; k++) {
            distances[k] = distance(plane, polygon.values[k]);
            anyOutside |= distances[k] < 0;
        }
        if (!anyOutside) return;
        next.size = 0;
        next.planes = polygon.planes;
        next.attributes = polygon.attributes;
        for (int k = 0, previous = polygon.size - 1; k < polygon.size; previous = k++) {
            boolean wasIn = distances[previous] >= 0;
            boolean isIn = distances[k] >= 0;
            if (wasIn && !isIn) cross(previous, k);
            if (!wasIn && isIn) cross(k, previous);
            if (isIn) next.addCopy(polygon, k);
        }
        ClipPolygon cut = next;
        next = polygon;
        polygon = cut;
    }

    private void cross(int inside, int outside) {
        double share = distances[inside] / (distances[inside] - distances[outside]);
        next.addBetween(polygon, inside, outside, share);
    }

    /** Positive inside; x, y, z, w are values 0 to 3. */
    private static double distance(int plane, double[] values) {
        double w = values[3];
        return switch (plane) {
            case 0 -> w - ClipCode.SMALLEST_W;
            case 1 -> w + values[2];
            case 2 -> w - values[2];
            case 3 -> Subpixels.GUARD * w + values[0];
            case 4 -> Subpixels.GUARD * w - values[0];
            case 5 -> Subpixels.GUARD * w + values[1];
            case 6 -> Subpixels.GUARD * w - values[1];
            default -> values[4 + plane - OWN_PLANES];
        };
    }
}
