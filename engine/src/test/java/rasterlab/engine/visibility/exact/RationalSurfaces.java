package rasterlab.engine.visibility.exact;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.PixelPoint;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Finds by force what is seen at each pixel by the rules of {@link ExactVisibility}: every line of
 * sight is met with every face in quotients of whole numbers, in the world, where a point of the
 * line is compared with the polygon in two of its coordinates. It shares nothing with what it
 * checks but the rules.
 */
final class RationalSurfaces {
    private static final Rational TOLERANCE = Rational.of(0x1p-40);
    private static final double ONE_NORMAL = 0x1p-20;

    private final ViewedMesh view;
    private final Mesh mesh;
    private final Rational[][] corner;
    private final Rational[][] normal;
    private final Rational[][] toWorld;
    private final int[] plane;

    RationalSurfaces(ViewedMesh view) {
        this.view = view;
        mesh = view.mesh();
        corner = new Rational[mesh.vertexCount()][];
        for (int v = 0; v < corner.length; v++) corner[v] = vector(mesh.x(v), mesh.y(v), mesh.z(v));
        normal =
                IntStream.range(0, mesh.faceCount())
                        .mapToObj(this::normal)
                        .toArray(Rational[][]::new);
        toWorld = inverse();
        plane = planes();
    }

    private static Rational[] vector(double x, double y, double z) {
        return new Rational[] {Rational.of(x), Rational.of(y), Rational.of(z)};
    }

    private Rational[] at(int face, int k) {
        return corner[mesh.corner(face, k % mesh.cornerCount(face))];
    }

    private Rational[] normal(int face) {
        Rational[] sum = vector(0, 0, 0);
        for (int k = 1; k + 1 < mesh.cornerCount(face); k++) {
            Rational[] part =
                    cross(minus(at(face, k), at(face, 0)), minus(at(face, k + 1), at(face, 0)));
            for (int i = 0; i < 3; i++) sum[i] = sum[i].plus(part[i]);
        }
        return sum;
    }

    /** The columns of the inverse of the turning part of the view. */
    private Rational[][] inverse() {
        var rows = new Rational[3][];
        for (int i = 0; i < 3; i++)
            rows[i] =
                    vector(
                            view.transform().entry(i, 0),
                            view.transform().entry(i, 1),
                            view.transform().entry(i, 2));
        Rational determinant = dot(rows[0], cross(rows[1], rows[2]));
        var columns = new Rational[3][];
        for (int i = 0; i < 3; i++) {
            columns[i] = cross(rows[(i + 1) % 3], rows[(i + 2) % 3]);
            for (int k = 0; k < 3; k++) columns[i][k] = columns[i][k].dividedBy(determinant);
        }
        return columns;
    }

    /** The largest face in whose plane each face is. */
    private int[] planes() {
        var of = new int[mesh.faceCount()];
        var founders = new ArrayList<Integer>();
        List<Integer> largestFirst =
                IntStream.range(0, of.length)
                        .boxed()
                        .sorted(Comparator.comparing(this::size).reversed())
                        .toList();
        for (int face : largestFirst) {
            of[face] =
                    founders.stream()
                            .filter(founder -> inPlane(face, founder))
                            .min(Comparator.comparing(founder -> squaredDistance(face, founder)))
                            .orElse(face);
            if (of[face] == face) founders.add(face);
        }
        return of;
    }

    private Rational size(int face) {
        Rational most = Rational.ZERO;
        for (int k = 1; k < mesh.cornerCount(face); k++) {
            Rational[] way = minus(at(face, k), at(face, 0));
            if (dot(way, way).compareTo(most) > 0) most = dot(way, way);
        }
        return most;
    }

    private boolean inPlane(int face, int founder) {
        double apart = Double.POSITIVE_INFINITY;
        for (int turn : new int[] {1, -1}) {
            double x = Math.abs(mesh.normalX(face) - turn * mesh.normalX(founder));
            double y = Math.abs(mesh.normalY(face) - turn * mesh.normalY(founder));
            double z = Math.abs(mesh.normalZ(face) - turn * mesh.normalZ(founder));
            apart = Math.min(apart, Math.max(x, Math.max(y, z)));
        }
        Rational largest = Rational.ZERO;
        for (int of : new int[] {face, founder})
            for (int k = 0; k < mesh.cornerCount(of); k++)
                for (Rational each : at(of, k))
                    if (each.size().compareTo(largest) > 0) largest = each.size();
        Rational allowed = TOLERANCE.times(largest);
        return apart <= ONE_NORMAL
                && squaredDistance(face, founder).compareTo(allowed.times(allowed)) <= 0;
    }

    /** The squared distance of the farthest corner of a face from the plane of another. */
    private Rational squaredDistance(int face, int founder) {
        Rational most = Rational.ZERO;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            Rational off = dot(normal[founder], minus(at(face, k), at(founder, 0)));
            if (off.size().compareTo(most) > 0) most = off.size();
        }
        return most.times(most).dividedBy(dot(normal[founder], normal[founder]));
    }

    /**
     * The faces at a pixel, the nearest first.
     *
     * @param x the pixel's column
     * @param y its row
     */
    List<Integer> seen(int x, int y) {
        Rational s = Rational.of(view.fit().pixelsPerUnit());
        Rational across =
                Rational.of(x + PixelPoint.RIGHT_OF_CENTER - view.fit().centerX())
                        .dividedBy(s)
                        .minus(Rational.of(view.fit().eyeX()));
        Rational up = Rational.of(view.fit().centerY() - y - PixelPoint.BELOW_CENTER).dividedBy(s);
        boolean central = view.transform().central();
        Rational[] none = vector(0, 0, 0);
        Rational rho = Rational.of(view.transform().distance());
        Rational[] from = world(central ? none : new Rational[] {across, up, Rational.ZERO});
        Rational[] to =
                world(
                        central
                                ? new Rational[] {
                                    across.dividedBy(rho), up.dividedBy(rho), Rational.of(1)
                                }
                                : new Rational[] {across, up, Rational.of(1)});
        Rational[] along = minus(to, from);
        var depths = new Rational[mesh.faceCount()];
        for (int face = 0; face < depths.length; face++) depths[face] = depth(face, from, along);
        return IntStream.range(0, depths.length)
                .filter(face -> depths[face] != null)
                .boxed()
                .sorted(Comparator.comparing(face -> depths[face]))
                .toList();
    }

    private Rational[] world(Rational[] eye) {
        var moved = new Rational[3];
        for (int i = 0; i < 3; i++)
            moved[i] = eye[i].minus(Rational.of(view.transform().entry(i, 3)));
        var world = new Rational[3];
        for (int k = 0; k < 3; k++)
            world[k] =
                    toWorld[0][k]
                            .times(moved[0])
                            .plus(toWorld[1][k].times(moved[1]))
                            .plus(toWorld[2][k].times(moved[2]));
        return world;
    }

    /** Where the line meets a face, as a depth in eye space; null where it does not. */
    private Rational depth(int face, Rational[] from, Rational[] along) {
        Rational t = meets(plane[face], from, along);
        Rational own = meets(face, from, along);
        if (t == null || own == null) return null;
        if (t.compareTo(bound(view.near())) < 0 || t.compareTo(bound(view.far())) > 0) return null;
        for (ClipPlane clip : view.clipPlanes())
            if (dot(vector(clip.a(), clip.b(), clip.c()), point(from, along, t))
                            .plus(Rational.of(clip.d()))
                            .signum()
                    < 0) return null;
        return inside(face, point(from, along, own)) ? t : null;
    }

    private static Rational bound(double z) {
        return Rational.of(Math.max(-1e300, Math.min(1e300, z)));
    }

    private Rational meets(int face, Rational[] from, Rational[] along) {
        Rational toward = dot(normal[face], along);
        if (toward.signum() == 0) return null;
        return dot(normal[face], minus(at(face, 0), from)).dividedBy(toward);
    }

    private static Rational[] point(Rational[] from, Rational[] along, Rational t) {
        var point = new Rational[3];
        for (int i = 0; i < 3; i++) point[i] = from[i].plus(along[i].times(t));
        return point;
    }

    /**
     * Whether the point is inside by the parity of crossings, without the coordinate along which
     * the face is flattest.
     */
    private boolean inside(int face, Rational[] point) {
        int flat = 0;
        for (int i = 1; i < 3; i++)
            if (normal[face][i].size().compareTo(normal[face][flat].size()) > 0) flat = i;
        int u = (flat + 1) % 3;
        int v = (flat + 2) % 3;
        boolean inside = false;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            Rational[] a = at(face, k);
            Rational[] b = at(face, k + 1);
            if (a[v].compareTo(point[v]) < 0 == b[v].compareTo(point[v]) < 0) continue;
            Rational share = point[v].minus(a[v]).dividedBy(b[v].minus(a[v]));
            if (a[u].plus(share.times(b[u].minus(a[u]))).compareTo(point[u]) > 0) inside = !inside;
        }
        return inside;
    }

    private static Rational[] minus(Rational[] a, Rational[] b) {
        return new Rational[] {a[0].minus(b[0]), a[1].minus(b[1]), a[2].minus(b[2])};
    }

    private static Rational dot(Rational[] a, Rational[] b) {
        return a[0].times(b[0]).plus(a[1].times(b[1])).plus(a[2].times(b[2]));
    }

    private static Rational[] cross(Rational[] a, Rational[] b) {
        return new Rational[] {
            a[1].times(b[2]).minus(a[2].times(b[1])),
            a[2].times(b[0]).minus(a[0].times(b[2])),
            a[0].times(b[1]).minus(a[1].times(b[0]))
        };
    }
}
