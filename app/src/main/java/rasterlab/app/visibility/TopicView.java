package rasterlab.app.visibility;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import rasterlab.app.canvas.Unshown;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.faces.Body;
import rasterlab.engine.visibility.hidden.SurfaceView;
import rasterlab.engine.visibility.order.Sight;

/**
 * An input of a topic about hidden surfaces as a scene, and how it is looked at.
 *
 * @param near the nearest depth that is drawn, in world units; 0 for all
 * @param far the farthest; infinite for all
 */
public record TopicView(Scene scene, Projection projection, double near, double far) {
    /** Pixels from the middle of a picture of 800×600 to the farthest corner. */
    private static final double REACH = 240;

    /** Pictures with fewer pixels, or with so unlike sides, have hazards of their own. */
    private static final int FEWEST_PIXELS = 16;

    private static final double MOST_UNLIKE = 8;
    private static final int BACKGROUND = 0xFFFFFF;
    private static final int[] COLOURS = {
        0xE69F00, 0x56B4E9, 0x009E73, 0xF0E442, 0x0072B2, 0xD55E00, 0xCC79A7, 0x999999
    };

    /** A view, or why there is none. */
    public record Found(Optional<TopicView> view, Optional<Unshown> obstacle) {
        private static Found no(Unshown why) {
            return new Found(Optional.empty(), Optional.of(why));
        }

        private static Found yes(TopicView view) {
            return new Found(Optional.of(view), Optional.empty());
        }
    }

    /**
     * @param name of the input, shown as the scene's
     */
    public static Found of(String name, SurfaceView input) {
        PictureFit fit = input.view().fit();
        int smaller = Math.min(fit.width(), fit.height());
        int larger = Math.max(fit.width(), fit.height());
        if (smaller < FEWEST_PIXELS || larger > MOST_UNLIKE * smaller)
            return Found.no(Unshown.PICTURE_SIZE);
        double natural =
                Math.min(
                        (double) fit.width() / PictureFit.NATURAL_WIDTH,
                        (double) fit.height() / PictureFit.NATURAL_HEIGHT);
        Scene scene = scene(name, input.mesh(), input.camera(), fit.pixelsPerUnit() / natural);
        boolean cut = Double.isFinite(input.view().far());
        return Found.yes(
                new TopicView(
                        scene,
                        input.view().transform().projection(),
                        cut ? input.view().near() : 0,
                        input.view().far()));
    }

    /**
     * The eye looks at the mean of the corners.
     *
     * @param name of the input, shown as the scene's
     */
    public static Found of(String name, Body body) {
        if (body.inside().length > 0) return Found.no(Unshown.INNER_POINT);
        double[] middle = body.insideOrMean();
        double[] xyz = minus(body.xyz(), middle);
        double[] eye = minus(body.eye(), middle);
        double rho = Math.hypot(Math.hypot(eye[0], eye[1]), eye[2]);
        if (!reachable(rho) || !(farthest(xyz) >= SphericalView.NEAREST))
            return Found.no(Unshown.MAGNITUDE);
        var camera = new SphericalView(Math.atan2(eye[1], eye[0]), Math.acos(eye[2] / rho), rho);
        return perspective(name, xyz, body.faces(), camera, ballScale(farthest(xyz), rho));
    }

    /** Pixels per unit for which a ball about the middle is seen, unless the eye is too near. */
    private static double ballScale(double radius, double rho) {
        return REACH * Math.max(rho - radius, rho / 2) / (radius * rho);
    }

    private static double farthest(double[] xyz) {
        double farthest = 0;
        for (int i = 0; i < xyz.length; i += 3)
            farthest = Math.max(farthest, Math.hypot(Math.hypot(xyz[i], xyz[i + 1]), xyz[i + 2]));
        return farthest;
    }

    /**
     * The eye looks along z, as the topic's methods do: y up, x to the right.
     *
     * @param name of the input, shown as the scene's
     */
    public static Found of(String name, Sight sight) {
        double[][] seen =
                Arrays.stream(sight.polygons())
                        .map(polygon -> minus(polygon, sight.eye()))
                        .toArray(double[][]::new);
        double rho = meanDepth(seen).orElse(0);
        if (!reachable(rho)) return Found.no(Unshown.MAGNITUDE);
        var faces = new int[seen.length][];
        int at = 0;
        for (int f = 0; f < faces.length; f++) {
            int first = at;
            faces[f] = IntStream.range(first, first + seen[f].length / 3).toArray();
            at += faces[f].length;
        }
        double[] xyz = Arrays.stream(seen).flatMapToDouble(Arrays::stream).toArray();
        var camera = new SphericalView(0, Math.PI / 2, rho);
        return perspective(name, towardsX(xyz, rho), faces, camera, scale(xyz, rho));
    }

    private static Found perspective(
            String name, double[] xyz, int[][] faces, SphericalView camera, double scale) {
        Mesh mesh;
        try {
            mesh = new Mesh(xyz, faces);
        } catch (IllegalArgumentException broken) {
            return Found.no(Unshown.BROKEN_FACE);
        }
        Scene scene = scene(name, mesh, camera, scale);
        return Found.yes(new TopicView(scene, Projection.PERSPECTIVE, 0, Double.POSITIVE_INFINITY));
    }

    private static Scene scene(String name, Mesh mesh, SphericalView camera, double scale) {
        int[] colours =
                IntStream.range(0, mesh.faceCount())
                        .map(face -> COLOURS[face % COLOURS.length])
                        .toArray();
        return Scene.dull(name, mesh, colours, BACKGROUND, camera, scale);
    }

    private static boolean reachable(double rho) {
        return rho >= SphericalView.NEAREST && rho <= SphericalView.FARTHEST;
    }

    private static double[] minus(double[] xyz, double[] point) {
        var moved = new double[xyz.length];
        for (int i = 0; i < xyz.length; i++) moved[i] = xyz[i] - point[i % 3];
        return moved;
    }

    /** Of the corners before the eye; empty where there are none. */
    private static OptionalDouble meanDepth(double[][] polygons) {
        return Arrays.stream(polygons)
                .flatMapToDouble(
                        p -> IntStream.range(0, p.length / 3).mapToDouble(i -> p[3 * i + 2]))
                .filter(z -> z > 0)
                .average();
    }

    /** From x to the right, y up and z away from the eye to the world that is seen from its x. */
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
    public VisibilityChoice shown(VisibilityChoice choice, String method) {
        double rho = scene.defaultCamera().rho();
        LookChoice look = LookChoice.USUAL;
        if (Double.isFinite(far)) look = look.withFar(far / rho).withNear(near / rho);
        return choice.with(SceneChoice.of(scene))
                .with(look)
                .withView(StageView.COLOURS)
                .withVisibility(method)
                .withShading(ShadingMethod.FLAT.code())
                .withProjection(projection.code())
                .zoomed(1 / choice.with(SceneChoice.of(scene)).zoom())
                .withDifference(true);
    }
}
