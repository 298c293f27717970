package rasterlab.engine.visibility.exact;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.ViewedMesh;

/** Small scenes for two references, the same for the same seed. */
final class RandomScenes {
    private static final int WIDTH = 12;
    private static final int HEIGHT = 9;

    private final Random random;
    private final List<double[]> corners = new ArrayList<>();
    private final List<int[]> faces = new ArrayList<>();

    private RandomScenes(long seed) {
        random = new Random(seed);
    }

    /** Kinds of scenes. */
    enum Kind {
        /** Squares and triangles in one plane, turned and moved. */
        ONE_PLANE,
        /** Squares and triangles near one plane, some by 2⁻³⁴ of their size above it. */
        SHEETS,
        /** Two such planes, and triangles through them. */
        CROSSED,
        /** Triangles all over. */
        SCATTERED
    }

    static ViewedMesh of(Kind kind, long seed) {
        return new RandomScenes(seed).view(kind);
    }

    private ViewedMesh view(Kind kind) {
        if (kind != Kind.SCATTERED) sheets(kind == Kind.SHEETS ? 0x1p-34 : 0);
        if (kind == Kind.CROSSED) sheets(0);
        if (kind == Kind.CROSSED || kind == Kind.SCATTERED) for (int k = 0; k < 3; k++) triangle();
        var projections = Projection.values();
        boolean central = random.nextBoolean();
        Projection projection =
                central ? Projection.PERSPECTIVE : projections[random.nextInt(projections.length)];
        double rho = random.nextInt(4) == 0 ? 40 : 400;
        var camera = new SphericalView(between(0, 6), between(0.1, 3), rho);
        var transform = new ViewTransform(camera, projection);
        boolean cut = random.nextInt(3) == 0;
        double near = transform.central() ? 1e-3 * rho : Double.NEGATIVE_INFINITY;
        List<ClipPlane> clips =
                cut
                        ? List.of(
                                new ClipPlane(
                                        between(-1, 1),
                                        between(-1, 1),
                                        between(-1, 1),
                                        between(0, 40)))
                        : List.of();
        return new ViewedMesh(
                new Mesh(
                        corners.stream().flatMapToDouble(java.util.Arrays::stream).toArray(),
                        faces.toArray(int[][]::new)),
                transform,
                new PictureFit(WIDTH, HEIGHT, between(0.05, 0.3), random.nextInt(2) * 3.7),
                cut ? Math.max(near, rho - 35) : near,
                cut ? rho + 35 : Double.POSITIVE_INFINITY,
                clips);
    }

    private double between(double least, double most) {
        return random.nextDouble(least, most);
    }

    /** A few faces in z = 0, of which later ones may be lifted, turned and moved together. */
    private void sheets(double lift) {
        int count = 2 + random.nextInt(3);
        double[] turns = {between(0, 6), between(0, 6), between(0, 6)};
        double far = random.nextInt(2) * 60;
        double[] moved = {between(-1, 1) * far, between(-1, 1) * far, between(-1, 1) * far};
        for (int k = 0; k < count; k++) {
            double half = 5 + random.nextInt(60);
            double x = random.nextInt(40) - 20;
            double y = random.nextInt(40) - 20;
            double z = lift * half * random.nextInt(3);
            int size = 3 + random.nextInt(2);
            int first = corners.size();
            for (int c = 0; c < size; c++) {
                double[] corner = {
                    x + (c == 1 || c == 2 ? half : -half), y + (c >= 2 ? half : -half), z
                };
                for (int axis = 0; axis < 3; axis++) turn(corner, axis, turns[axis]);
                for (int axis = 0; axis < 3; axis++) corner[axis] += moved[axis];
                corners.add(corner);
            }
            boolean round = random.nextBoolean();
            var face = new int[size];
            for (int c = 0; c < size; c++) face[c] = first + (round ? c : size - 1 - c);
            faces.add(face);
        }
    }

    private static void turn(double[] p, int axis, double angle) {
        int i = (axis + 1) % 3;
        int j = (axis + 2) % 3;
        double u = p[i] * Math.cos(angle) - p[j] * Math.sin(angle);
        p[j] = p[i] * Math.sin(angle) + p[j] * Math.cos(angle);
        p[i] = u;
    }

    private void triangle() {
        int first = corners.size();
        for (int c = 0; c < 3; c++)
            corners.add(new double[] {between(-60, 60), between(-60, 60), between(-60, 60)});
        faces.add(new int[] {first, first + 1, first + 2});
    }
}
