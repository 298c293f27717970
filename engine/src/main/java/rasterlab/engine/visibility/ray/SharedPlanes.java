package rasterlab.engine.visibility.ray;

import java.util.concurrent.atomic.AtomicBoolean;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Whether two faces of a mesh lie over each other in one plane, where no depth tells which of them
 * is in front.
 *
 * <p>Convex faces in one plane are apart where a line along an edge of one of them has all of the
 * one on its one side and all of the other on its other side. Faces that only touch are apart.
 *
 * <p>Source: S. Gottschalk, M. C. Lin, D. Manocha, OBBTree: a hierarchical structure for rapid
 * interference detection, SIGGRAPH 1996, pp. 171–180 (the separating axis theorem).
 */
public final class SharedPlanes {
    private final ViewedMesh view;

    private SharedPlanes(ViewedMesh view) {
        this.view = view;
    }

    /** A corner is in a plane within the tolerance of {@link FaceCrossings}. */
    public static boolean anyOverlap(ViewedMesh view) {
        var faces = new SharedPlanes(view);
        var found = new AtomicBoolean();
        new BoxTree(view.mesh())
                .overlaps(
                        (one, other) -> {
                            if (!found.get()) found.set(faces.overlap(one, other));
                        });
        return found.get();
    }

    private boolean overlap(int one, int other) {
        return inPlane(one, other)
                && inPlane(other, one)
                && !apart(one, one, other)
                && !apart(other, one, other);
    }

    private boolean inPlane(int face, int of) {
        for (int k = 0; k < view.mesh().cornerCount(face); k++)
            if (FaceCrossings.distance(view, view.mesh().corner(face, k), of) != 0) return false;
        return true;
    }

    /** Whether a line along an edge of {@code edges} is between the two faces. */
    private boolean apart(int edges, int one, int other) {
        int corners = view.mesh().cornerCount(edges);
        int last = view.mesh().corner(edges, corners - 1);
        for (int k = 0; k < corners; k++) {
            int corner = view.mesh().corner(edges, k);
            double[] across = across(edges, last, corner);
            double[] first = extent(one, across);
            double[] second = extent(other, across);
            double room =
                    FaceCrossings.IN_PLANE
                            * Math.max(
                                    Math.max(Math.abs(first[0]), Math.abs(first[1])),
                                    Math.max(Math.abs(second[0]), Math.abs(second[1])));
            if (first[1] <= second[0] + room || second[1] <= first[0] + room) return true;
            last = corner;
        }
        return false;
    }

    /** The direction in the face's plane, at a right angle to the edge between two vertices. */
    private double[] across(int face, int from, int to) {
        double x = view.eyeX(to) - view.eyeX(from);
        double y = view.eyeY(to) - view.eyeY(from);
        double z = view.eyeZ(to) - view.eyeZ(from);
        double nx = view.eyeNormal(face, 0);
        double ny = view.eyeNormal(face, 1);
        double nz = view.eyeNormal(face, 2);
        return new double[] {ny * z - nz * y, nz * x - nx * z, nx * y - ny * x};
    }

    /** The least and the most that a face's corners are along a direction. */
    private double[] extent(int face, double[] along) {
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        for (int k = 0; k < view.mesh().cornerCount(face); k++) {
            int v = view.mesh().corner(face, k);
            double place =
                    along[0] * view.eyeX(v) + along[1] * view.eyeY(v) + along[2] * view.eyeZ(v);
            least = Math.min(least, place);
            most = Math.max(most, place);
        }
        return new double[] {least, most};
    }
}
