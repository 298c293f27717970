package rasterlab.app.visibility.scene;

import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import rasterlab.app.canvas.method.ShownDifference;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.hidden.SurfaceView;
import rasterlab.engine.visibility.order.Painting;
import rasterlab.engine.visibility.order.Sight;

/**
 * An input of a topic about hidden surfaces as a scene, and how it is looked at.
 *
 * @param near the nearest depth that is drawn, in world units; 0 for all
 * @param far the farthest; infinite for all
 * @param drawnBy the visibility method that draws it
 * @param differences in what it is other than the input
 */
public record TopicView(
        Scene scene,
        Projection projection,
        double near,
        double far,
        String drawnBy,
        List<ShownDifference> differences) {
    /** Pixels from the middle of a picture of 800×600 to the farthest corner. */
    private static final double REACH = 240;

    /** Pictures with fewer pixels, or with so unlike sides, have hazards of their own. */
    private static final int FEWEST_PIXELS = 16;

    private static final double MOST_UNLIKE = 8;

    /** Draws faces in their order, the last one above the others. */
    private static final String AS_PAINTED = "none";

    private static final int BACKGROUND = 0xFFFFFF;
    private static final int[] COLORS = {
        0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442, 0x0072B2, 0xD55E00, 0xCC79A7, 0x999999
    };

    /** A perspective view of a scene. */
    private static TopicView perspective(
            Scene scene, String drawnBy, List<ShownDifference> differences) {
        return new TopicView(
                scene, Projection.PERSPECTIVE, 0, Double.POSITIVE_INFINITY, drawnBy, differences);
    }

    /**
     * @param name of the input, shown as the scene's
     */
    public static TopicView of(String name, SurfaceView input, String drawnBy) {
        PictureFit fit = input.view().fit();
        int smaller = Math.min(fit.width(), fit.height());
        int larger = Math.max(fit.width(), fit.height());
        double natural =
                Math.min(
                        (double) fit.width() / PictureFit.NATURAL_WIDTH,
                        (double) fit.height() / PictureFit.NATURAL_HEIGHT);
        Mesh mesh = input.mesh();
        double scale = fit.pixelsPerUnit() / natural;
        List<ShownDifference> differences = List.of();
        if (smaller < FEWEST_PIXELS || larger > MOST_UNLIKE * smaller) {
            var fitted = FittedSurfaces.of(input, REACH);
            mesh = fitted.mesh();
            scale = fitted.scale();
            differences = fitted.differences();
        }
        boolean cut = Double.isFinite(input.view().far());
        return new TopicView(
                scene(name, mesh, colors(mesh.faceCount()), input.camera(), scale),
                input.view().transform().projection(),
                cut ? input.view().near() : 0,
                input.view().far(),
                drawnBy,
                differences);
    }

    /**
     * The eye looks at the mean of the corners.
     *
     * @param name of the input, shown as the scene's
     * @param method of the topic
     * @param drawnBy what draws a body that can be drawn as it is
     */
    public static TopicView of(String name, Body body, String method, String drawnBy) {
        var drawn = DrawnBody.of(body, method);
        double[] eye = drawn.eye();
        double rho = Math.hypot(Math.hypot(eye[0], eye[1]), eye[2]);
        var camera = new SphericalView(Math.atan2(eye[1], eye[0]), Math.acos(eye[2] / rho), rho);
        Scene scene =
                scene(
                        name,
                        drawn.mesh(),
                        Arrays.stream(drawn.numbers()).map(TopicView::color).toArray(),
                        camera,
                        ballScale(drawn.radius(), rho));
        return perspective(scene, drawn.drawnBy().orElse(drawnBy), drawn.differences());
    }

    /** Pixels per unit for which a ball about the middle is seen, unless the eye is too near. */
    private static double ballScale(double radius, double rho) {
        return REACH * Math.max(rho - radius, rho / 2) / (radius * rho);
    }

    /**
     * The eye looks along z, as the topic's methods do: y up, x to the right.
     *
     * @param name of the input, shown as the scene's
     * @param method of the topic
     * @param drawnBy what draws polygons that can be drawn as they are
     */
    public static TopicView of(String name, Sight sight, String method, String drawnBy) {
        double[][] seen = seen(sight.polygons(), sight.eye());
        double rho = meanDepth(seen).orElse(0);
        if (reachable(rho)) {
            int[] numbers = IntStream.range(0, seen.length).toArray();
            return perspective(sight(name, seen, numbers, rho), drawnBy, List.of());
        }
        var painted = PaintedSight.of(sight, method, rho);
        List<Painting.Piece> pieces = painted.pieces();
        double[][] larger =
                pieces.stream()
                        .map(piece -> painted.scaled(piece, sight.eye()))
                        .toArray(double[][]::new);
        Scene scene =
                sight(
                        name,
                        larger,
                        pieces.stream().mapToInt(Painting.Piece::polygon).toArray(),
                        Math.scalb(rho, painted.exponent()));
        return perspective(scene, AS_PAINTED, painted.differences());
    }

    private static double[][] seen(double[][] polygons, double[] eye) {
        return Arrays.stream(polygons).map(polygon -> minus(polygon, eye)).toArray(double[][]::new);
    }

    /**
     * @param seen polygons as seen from the eye
     * @param numbers of each, for its colour
     * @param rho mean depth
     */
    private static Scene sight(String name, double[][] seen, int[] numbers, double rho) {
        var faces = new int[seen.length][];
        int at = 0;
        for (int f = 0; f < faces.length; f++) {
            int first = at;
            faces[f] = IntStream.range(first, first + seen[f].length / 3).toArray();
            at += faces[f].length;
        }
        double[] xyz = Arrays.stream(seen).flatMapToDouble(Arrays::stream).toArray();
        return scene(
                name,
                new Mesh(towardsX(xyz, rho), faces),
                Arrays.stream(numbers).map(TopicView::color).toArray(),
                new SphericalView(0, Math.PI / 2, rho),
                scale(xyz, rho));
    }

    private static Scene scene(
            String name, Mesh mesh, int[] colors, SphericalView camera, double scale) {
        return Scene.dull(name, mesh, colors, BACKGROUND, camera, scale);
    }

    private static int[] colors(int faces) {
        return IntStream.range(0, faces).map(TopicView::color).toArray();
    }

    private static int color(int face) {
        return COLORS[face % COLORS.length];
    }

    /** Whether an eye can be so far away, in world units. */
    static boolean reachable(double rho) {
        return rho >= SphericalView.NEAREST && rho <= SphericalView.FARTHEST;
    }

    static double[] minus(double[] xyz, double[] point) {
        var moved = new double[xyz.length];
        for (int i = 0; i < xyz.length; i++) moved[i] = xyz[i] - point[i % 3];
        return moved;
    }

    /** Mean depth of the corners before the eye; empty where there are none. */
    private static OptionalDouble meanDepth(double[][] polygons) {
        double[] depths =
                Arrays.stream(polygons)
                        .flatMapToDouble(
                                p ->
                                        IntStream.range(0, p.length / 3)
                                                .mapToDouble(i -> p[3 * i + 2]))
                        .filter(z -> z > 0)
                        .toArray();
        return Arrays.stream(depths).map(z -> z / depths.length).reduce(Double::sum);
    }

    /**
     * Turns x to the right, y up and z away from the eye into the world that is seen from its x.
     */
    private static double[] towardsX(double[] xyz, double rho) {
        var world = new double[xyz.length];
        for (int i = 0; i < xyz.length; i += 3) {
            world[i] = rho - xyz[i + 2];
            world[i + 1] = xyz[i];
            world[i + 2] = xyz[i + 1];
        }
        return world;
    }

    /** Pixels per unit for which what lies half as deep as the middle, or deeper, is seen. */
    private static double scale(double[] xyz, double rho) {
        double reach = 0;
        for (int i = 0; i < xyz.length; i += 3) {
            double depth = Math.max(xyz[i + 2], rho / 2);
            reach = Math.max(reach, Math.max(Math.abs(xyz[i]), Math.abs(xyz[i + 1])) / depth);
        }
        return REACH / (reach * rho);
    }

    /** The choice that shows it, each face in a colour of its own. */
    public VisibilityChoice shown(VisibilityChoice choice) {
        double rho = scene.defaultCamera().rho();
        LookChoice look = LookChoice.USUAL;
        if (Double.isFinite(far)) look = look.withFar(far / rho).withNear(near / rho);
        VisibilityChoice other = choice.with(SceneChoice.of(scene));
        return other.with(look)
                .withView(StageView.COLORS)
                .withVisibility(drawnBy.isEmpty() ? choice.visibility() : drawnBy)
                .withShading(ShadingMethod.FLAT.code())
                .withProjection(projection.code())
                .zoomed(1 / other.zoom())
                .withDifference(true);
    }
}
