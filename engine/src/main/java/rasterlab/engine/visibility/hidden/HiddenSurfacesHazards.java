package rasterlab.engine.visibility.hidden;

import java.util.List;
import java.util.TreeMap;
import java.util.stream.Stream;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Vase;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.study.Hazard;
import rasterlab.engine.study.Method;
import rasterlab.engine.study.Verdict;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.Visibility;

/** Scenes on which methods fail, with what each makes of them. */
final class HiddenSurfacesHazards {
    /** The one scene that is a convex closed body. */
    private static final String CLOSED = "edge-on";

    private static final PictureFit SMALL = new PictureFit(160, 120, 1);

    private final List<Method<Visibility>> methods;

    private HiddenSurfacesHazards(List<Method<Visibility>> methods) {
        this.methods = methods;
    }

    static List<Hazard<SurfaceView>> all(List<Method<Visibility>> methods) {
        var hazards = new HiddenSurfacesHazards(methods);
        return Stream.of(
                        hazards.ofOrder(),
                        hazards.ofOnePlane(),
                        hazards.ofDepths(),
                        hazards.ofPlaces(),
                        hazards.aroundTheEye())
                .flatMap(List::stream)
                .toList();
    }

    private List<Hazard<SurfaceView>> ofOrder() {
        var vase = Scenes.named("vase").mesh();
        return List.of(
                hazard(
                        "vase-mean-z",
                        "none painter-textbook",
                        "",
                        SurfaceView.of(
                                vase,
                                Vase.CAMERA,
                                Projection.PARALLEL,
                                new PictureFit(400, 300, 0.9))),
                hazard(
                        "mean-mis-sorts",
                        "none back-face painter-textbook painter",
                        "",
                        perspective(
                                new Quads()
                                        .add(
                                                -57.7, -44.8, 1300, 58.2, -44.8, 1300, 58.2, 20,
                                                1300, -57.7, 20, 1300)
                                        .add(
                                                -60.3, -45, 100, 60.7, -45, 100, 60.7, -45, 2400,
                                                -60.3, -45, 2400)
                                        .mesh())),
                hazard(
                        "cyclic-overlap",
                        "none back-face painter-textbook painter",
                        "",
                        parallel(
                                new Quads()
                                        .add(bar(0))
                                        .add(bar(2 * Math.PI / 3))
                                        .add(bar(4 * Math.PI / 3))
                                        .mesh())),
                hazard(
                        "interpenetration",
                        "none back-face painter-textbook painter",
                        "",
                        perspective(crossedSquares())));
    }

    private List<Hazard<SurfaceView>> ofOnePlane() {
        return List.of(
                hazard(
                        "coplanar",
                        "none back-face painter-textbook painter",
                        "z24",
                        SurfaceView.of(
                                new Quads().square(-10, -8, 500, 30).square(12, 9, 500, 33).mesh(),
                                new SphericalView(0.7, 1.1, 500),
                                Projection.PERSPECTIVE,
                                SMALL)),
                hazard(
                        "coplanar-turned",
                        "none back-face painter",
                        "painter-textbook",
                        TurnedSquares.seen()),
                hazard(
                        "coplanar-far-corners",
                        "none back-face painter",
                        "painter-textbook",
                        FarCorners.seen()));
    }

    /** One is nearer on the left, the other on the right. */
    private static Mesh crossedSquares() {
        return new Quads()
                .add(-40.3, -40.6, 460, 41.2, -40.6, 541, 41.2, 39.7, 541, -40.3, 39.7, 460)
                .add(-39.6, -30.4, 540, 40.7, -30.4, 463, 40.7, 49.8, 463, -39.6, 49.8, 540)
                .mesh();
    }

    /** A bar that is nearer at one end, turned about the line of sight. */
    private static double[] bar(double angle) {
        double[] flat = {-50.3, 15.4, 480, 50.6, 15.4, 520, 50.6, 30.7, 520, -50.3, 30.7, 480};
        var turned = new double[flat.length];
        for (int i = 0; i < flat.length; i += 3) {
            turned[i] = flat[i] * Math.cos(angle) - flat[i + 1] * Math.sin(angle);
            turned[i + 1] = flat[i] * Math.sin(angle) + flat[i + 1] * Math.cos(angle);
            turned[i + 2] = flat[i + 2];
        }
        return turned;
    }

    private List<Hazard<SurfaceView>> ofDepths() {
        return List.of(
                deep("depth-1-at-1000", "painter-textbook z16", "", 1000, 1),
                deep("depth-10-at-100000", "painter-textbook z16 z24", "", 1e5, 10),
                deep("depth-50-at-900000", "painter-textbook z16 z24 z32", "", 9e5, 50),
                deep("depth-hair-at-900000", "painter-textbook z16 z24 z32", "", 9e5, 0.1),
                hazard("long-span-drift", "z16 z24", "", longSpan()));
    }

    /**
     * A slope before another, whose steps of 1500 and a half of 2⁻⁸ depths are rounded up and down.
     * Two small squares beside them hold the ends of the range.
     */
    private static SurfaceView longSpan() {
        double depth = 2000 / (0x1p24 - 2);
        double first = 600 - 8 * depth;
        double up = first + 8000 * (1500 + 0.52 / 256) * depth;
        double down = 600 + 8000 * (1500 + 0.48 / 256) * depth;
        var slopes =
                new Quads()
                        .add(-4000, -3, 600, 4000, -3, down, 4000, 3, down, -4000, 3, 600)
                        .add(-4000, -3, first, 4000, -3, up, 4000, 3, up, -4000, 3, first)
                        .square(4050, 0, 500, 1)
                        .square(4060, 0, 2500, 1);
        return SurfaceView.of(
                slopes.mesh(), Quads.FROM_X, Projection.PARALLEL, new PictureFit(8192, 4, 1));
    }

    private Hazard<SurfaceView> deep(
            String name, String wrong, String degraded, double depth, double apart) {
        double half = 40.3 * depth / Quads.RHO;
        var squares =
                new Quads().square(0, 0, depth + apart, half).square(0, 0, depth, half * 0.75);
        return hazard(
                name,
                wrong,
                degraded,
                SurfaceView.between(1, 1e6, squares.mesh(), Quads.FROM_X, SMALL));
    }

    private List<Hazard<SurfaceView>> ofPlaces() {
        return List.of(
                hazard(CLOSED, "none", "painter-textbook", parallel(box())),
                hazard(
                        "edge-on-by-a-hair",
                        "",
                        "",
                        SurfaceView.of(
                                wallOnFloor(),
                                new SphericalView(0, Double.MIN_VALUE, Quads.RHO),
                                Projection.PARALLEL,
                                SMALL)));
    }

    private List<Hazard<SurfaceView>> aroundTheEye() {
        return List.of(
                hazard(
                        "eye-in-a-face",
                        "",
                        "painter-textbook",
                        perspective(
                                new Quads()
                                        .square(5.3, 3.4, 500, 30)
                                        .add(-40, 0, 900, 40, 0, 900, 40, 0, -100, -40, 0, -100)
                                        .mesh())),
                hazard(
                        "through-a-face",
                        "",
                        "painter-textbook",
                        perspective(
                                new Quads()
                                        .square(5.3, 3.4, 500, 30)
                                        .square(0, 0, 1e-4, 60)
                                        .mesh())),
                hazard(
                        "behind-the-eye",
                        "none back-face painter-textbook painter",
                        "",
                        perspective(
                                new Quads()
                                        .square(5.3, 3.4, 600, 30)
                                        .square(0, 0, -500, 60)
                                        .add(
                                                -41.3, -21, 905, 38.6, -21, 905, 38.6, -21, -100,
                                                -41.3, -21, -100)
                                        .mesh())),
                hazard(
                        "one-pixel",
                        "none back-face",
                        "",
                        SurfaceView.of(
                                new Quads().square(0, 0, 500, 3).square(1, 1, 600, 9).mesh(),
                                Quads.FROM_X,
                                Projection.PERSPECTIVE,
                                new PictureFit(1, 1, 1))));
    }

    private static Mesh box() {
        return new Quads()
                .add(-30.3, -20.4, 480, 30.6, -20.4, 480, 30.6, 19.7, 480, -30.3, 19.7, 480)
                .add(-30.3, -20.4, 520, -30.3, 19.7, 520, 30.6, 19.7, 520, 30.6, -20.4, 520)
                .add(-30.3, -20.4, 520, 30.6, -20.4, 520, 30.6, -20.4, 480, -30.3, -20.4, 480)
                .add(30.6, 19.7, 480, 30.6, 19.7, 520, -30.3, 19.7, 520, -30.3, 19.7, 480)
                .add(-30.3, 19.7, 480, -30.3, 19.7, 520, -30.3, -20.4, 520, -30.3, -20.4, 480)
                .add(30.6, -20.4, 520, 30.6, 19.7, 520, 30.6, 19.7, 480, 30.6, -20.4, 480)
                .mesh();
    }

    /** The floor is level, the wall upright. */
    private static Mesh wallOnFloor() {
        double[] xyz = {
            -40, -30, 0, 40, -30, 0, 40, 30, 0, -40, 30, 0,
            20, -45, -10, 20, 45, -10, 20, 45, 40, 20, -45, 40
        };
        return new Mesh(xyz, new int[][] {{0, 1, 2, 3}, {4, 5, 6, 7}});
    }

    private static SurfaceView parallel(Mesh mesh) {
        return SurfaceView.of(mesh, Quads.FROM_X, Projection.PARALLEL, SMALL);
    }

    private static SurfaceView perspective(Mesh mesh) {
        return SurfaceView.of(mesh, Quads.FROM_X, Projection.PERSPECTIVE, SMALL);
    }

    /**
     * @param wrong methods that are, with spaces between
     * @param degraded methods that are, likewise; 'convex' refuses whatever is no closed body
     */
    private Hazard<SurfaceView> hazard(
            String name, String wrong, String degraded, SurfaceView input) {
        var failing = new TreeMap<String, Verdict.Kind>();
        words(wrong).forEach(method -> failing.put(method, Verdict.Kind.WRONG));
        words(degraded).forEach(method -> failing.put(method, Verdict.Kind.DEGRADED));
        if (!name.equals(CLOSED)) failing.put("convex", Verdict.Kind.REFUSED);
        return Hazard.allExactBut(failing, methods, name, input);
    }

    private static Stream<String> words(String names) {
        return Stream.of(names.split(" ")).filter(name -> !name.isEmpty());
    }
}
