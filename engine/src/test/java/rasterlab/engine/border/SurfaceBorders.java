package rasterlab.engine.border;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.hidden.HiddenSurfacesTopic;
import rasterlab.engine.visibility.hidden.SurfaceView;

/** Faces in one plane, across each other or of one body, turned or not, and eyes that see them. */
final class SurfaceBorders {
    /** Coordinates, where the smallest ρ is 1. */
    private static final double LARGEST = 1000;

    private static final int WIDTH = 24;
    private static final int HEIGHT = 18;

    private final Draws draws;
    private final List<double[]> corners = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();

    private SurfaceBorders(Draws draws) {
        this.draws = draws;
    }

    static Border<?, ?, ?> all() {
        return Border.of(
                        new HiddenSurfacesTopic(),
                        draws -> new SurfaceBorders(draws).view(),
                        SurfaceBorders::mayRefuse)
                .excusing(SightLimits::excuse)
                .slow(0.5);
    }

    private static boolean mayRefuse(String method, SurfaceView view, String message) {
        if (method.equals("convex")) return message.contains("must be one convex closed body");
        boolean ordered = method.equals("newell") || method.equals("bsp");
        return ordered && ofSliver(message);
    }

    /** The view leaves of a face hardly more than a line, or a part that hardly ends. */
    private static boolean ofSliver(String message) {
        return message.contains("span no area")
                || message.contains("lies off the plane")
                || message.contains("must be finite");
    }

    private SurfaceView view() {
        if (draws.pick(4) == 0) box();
        else for (int left = 2 + draws.pick(3); left > 0; left--) face();
        if (draws.coin()) turn(draws.number(-7, 7), draws.number(-7, 7));
        var mesh =
                new Mesh(
                        corners.stream().flatMapToDouble(Arrays::stream).toArray(),
                        faces.toArray(int[][]::new));
        var projections = Projection.values();
        Projection projection =
                draws.coin() ? Projection.PERSPECTIVE : projections[draws.pick(projections.length)];
        var camera = new SphericalView(angle(), angle(), draws.number(1, LARGEST));
        double scale = draws.number(0.01, 10);
        return SurfaceView.of(mesh, camera, projection, new PictureFit(WIDTH, HEIGHT, scale));
    }

    private double angle() {
        return draws.coin() ? draws.pick(4) * Math.PI / 2 : draws.number(-7, 7);
    }

    private void face() {
        switch (draws.pick(3)) {
            case 0 -> rectangle();
            case 1 -> parallelogram();
            default -> add(draws.coin(), point(), point(), point());
        }
    }

    private double[] point() {
        return new double[] {
            draws.number(-LARGEST, LARGEST),
            draws.number(-LARGEST, LARGEST),
            draws.number(-LARGEST, LARGEST)
        };
    }

    /** A rectangle at right angles to an axis. */
    private void rectangle() {
        int axis = draws.pick(3);
        double[] one = point();
        double[] other = point();
        var all = new double[4][3];
        for (int k = 0; k < 4; k++) {
            all[k][axis] = one[axis];
            all[k][(axis + 1) % 3] = (k == 1 || k == 2 ? other : one)[(axis + 1) % 3];
            all[k][(axis + 2) % 3] = (k >= 2 ? other : one)[(axis + 2) % 3];
        }
        add(draws.coin(), all);
    }

    private void parallelogram() {
        double[] a = point();
        double[] b = point();
        double[] c = point();
        var d = new double[3];
        for (int axis = 0; axis < 3; axis++) d[axis] = a[axis] + (c[axis] - b[axis]);
        add(draws.coin(), a, b, c, d);
    }

    private void add(boolean round, double[]... points) {
        var face = new int[points.length];
        for (int k = 0; k < face.length; k++) {
            face[k] = corners.size() + (round ? k : face.length - 1 - k);
        }
        corners.addAll(List.of(points));
        faces.add(face);
    }

    /** A closed body, the only one that method {@code convex} takes. */
    private void box() {
        double[] one = point();
        double[] other = point();
        for (int k = 0; k < 8; k++) {
            var corner = new double[3];
            for (int axis = 0; axis < 3; axis++)
                corner[axis] =
                        (k >> axis & 1) == 0
                                ? Math.min(one[axis], other[axis])
                                : Math.max(one[axis], other[axis]);
            corners.add(corner);
        }
        faces.add(new int[] {0, 2, 3, 1});
        faces.add(new int[] {4, 5, 7, 6});
        faces.add(new int[] {0, 1, 5, 4});
        faces.add(new int[] {2, 6, 7, 3});
        faces.add(new int[] {0, 4, 6, 2});
        faces.add(new int[] {1, 3, 7, 5});
    }

    /** Turns all about z and then about x, which rounds every corner by itself. */
    private void turn(double aboutZ, double aboutX) {
        for (double[] p : corners) {
            double across = p[0] * Math.sin(aboutZ) + p[1] * Math.cos(aboutZ);
            p[0] = p[0] * Math.cos(aboutZ) - p[1] * Math.sin(aboutZ);
            p[1] = across * Math.cos(aboutX) - p[2] * Math.sin(aboutX);
            p[2] = across * Math.sin(aboutX) + p[2] * Math.cos(aboutX);
        }
    }
}
