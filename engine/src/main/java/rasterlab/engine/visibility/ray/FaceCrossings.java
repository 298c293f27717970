package rasterlab.engine.visibility.ray;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.EyeSegment;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Where faces pass through each other: a straight piece for each two that do.
 *
 * <p>Two faces cross where each has corners on both sides of the other's plane, and the pieces that
 * the faces cut out of the line n₁ × n₂, in which their planes meet, overlap. Faces that only
 * touch, as neighbours at their edge do, do not cross. A corner is in a plane within {@link
 * #IN_PLANE} of the sizes of the coordinates.
 */
public final class FaceCrossings {
    static final double IN_PLANE = 0x1p-40;

    private final ViewedMesh view;
    private final List<EyeSegment> found = new ArrayList<>();
    private final Cut first;
    private final Cut second;

    private FaceCrossings(ViewedMesh view) {
        this.view = view;
        first = new Cut();
        second = new Cut();
    }

    /**
     * All crossings of a mesh's faces.
     *
     * @param cancelled asked for each two faces that are close
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static List<EyeSegment> of(ViewedMesh view, BooleanSupplier cancelled) {
        var search = new FaceCrossings(view);
        new BoxTree(view.mesh())
                .overlaps(
                        (one, other) -> {
                            Cancellation.check(cancelled);
                            search.tryPair(one, other);
                        });
        return search.found;
    }

    private void tryPair(int one, int other) {
        double[] along = cross(one, other);
        double length = Math.sqrt(dot(along, along));
        if (length == 0) return;
        for (int axis = 0; axis < 3; axis++) along[axis] /= length;
        if (!first.load(one, other, along) || !second.load(other, one, along)) return;
        Cut begin = first.least > second.least ? first : second;
        Cut end = first.most < second.most ? first : second;
        double room = IN_PLANE * (Math.abs(begin.least) + Math.abs(end.most));
        if (!(end.most - begin.least > room)) return;
        double[] from = begin.from;
        double[] to = end.to;
        found.add(new EyeSegment(from[0], from[1], from[2], to[0], to[1], to[2]));
    }

    private double[] cross(int one, int other) {
        double[] n = normal(one);
        double[] m = normal(other);
        return new double[] {
            n[1] * m[2] - n[2] * m[1], n[2] * m[0] - n[0] * m[2], n[0] * m[1] - n[1] * m[0]
        };
    }

    private double[] normal(int face) {
        return new double[] {
            view.eyeNormal(face, 0), view.eyeNormal(face, 1), view.eyeNormal(face, 2)
        };
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /** Distance of a vertex from the plane of a face; 0 within the tolerance. */
    static double distance(ViewedMesh view, int vertex, int face) {
        double x = view.eyeX(vertex);
        double y = view.eyeY(vertex);
        double z = view.eyeZ(vertex);
        double offset = view.planeOffset(face);
        double distance =
                view.eyeNormal(face, 0) * x
                        + view.eyeNormal(face, 1) * y
                        + view.eyeNormal(face, 2) * z
                        - offset;
        double sizes = Math.abs(x) + Math.abs(y) + Math.abs(z) + Math.abs(offset);
        return Math.abs(distance) <= IN_PLANE * sizes ? 0 : distance;
    }

    /**
     * The segment that the plane of one face cuts out of another: the ends, and their places on the
     * line.
     */
    private final class Cut {
        final double[] from = new double[3];
        final double[] to = new double[3];
        double least;
        double most;
        private final double[] point = new double[3];

        /**
         * @param along the line's direction, of length 1
         * @return false where the face has not corners on both sides
         */
        boolean load(int face, int by, double[] along) {
            least = Double.POSITIVE_INFINITY;
            most = Double.NEGATIVE_INFINITY;
            boolean before = false;
            boolean behind = false;
            int corners = view.mesh().cornerCount(face);
            int last = view.mesh().corner(face, corners - 1);
            double atLast = distance(view, last, by);
            for (int k = 0; k < corners; k++) {
                int corner = view.mesh().corner(face, k);
                double here = distance(view, corner, by);
                before |= here > 0;
                behind |= here < 0;
                if (here == 0) include(corner, corner, 0, along);
                else if (here > 0 && atLast < 0 || here < 0 && atLast > 0)
                    include(last, corner, atLast / (atLast - here), along);
                last = corner;
                atLast = here;
            }
            return before && behind;
        }

        private void include(int a, int b, double t, double[] along) {
            point[0] = view.eyeX(a) + t * (view.eyeX(b) - view.eyeX(a));
            point[1] = view.eyeY(a) + t * (view.eyeY(b) - view.eyeY(a));
            point[2] = view.eyeZ(a) + t * (view.eyeZ(b) - view.eyeZ(a));
            double place = dot(point, along);
            if (place < least) {
                least = place;
                System.arraycopy(point, 0, from, 0, 3);
            }
            if (place > most) {
                most = place;
                System.arraycopy(point, 0, to, 0, 3);
            }
        }
    }
}
