package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.contract.Reflection;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Light;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.shape.SceneShape;
import rasterlab.engine.scene.shape.ShapeSurfaces;
import rasterlab.engine.sight.Reason;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Fewer steps for the curved surfaces of a scene, and none for what is out of sight.
 *
 * <p>Both meshes, the full one and the coarser, lie within their own rise of the surface; together
 * these must stay below the tolerance where the part is nearest to the eye, so that what is far is
 * coarser. An angle ε between normals changes diffuse light by at most ε·k_d and a highlight by ε
 * times the steepest slope of cosˢ.
 */
final class ShapePlan {
    /** Meshes of fewer faces are left as they are. */
    private static final int FEW = 64;

    /** The share of the level tolerance that coarser normals may use. */
    static final double LEVELS = 0.5;

    /** Two outlines may move towards each other, and what is between them must not vanish. */
    private static final double OUTLINES = 2;

    private final Scene scene;
    private final ViewedMesh view;
    private final double pixels;
    private final double levels;

    /** The outcome for a scene. */
    record Result(Scene scene, List<PlanDecision> decisions) {}

    ShapePlan(Scene scene, ViewedMesh view, Tolerance tolerance) {
        this.scene = scene;
        this.view = view;
        pixels = tolerance.pixels() / OUTLINES;
        levels = LEVELS * tolerance.levels();
    }

    /** Leaves out what it can; empty where that is nothing. */
    Optional<Result> plan() {
        if (scene.surfaces().isEmpty()
                || !(scene.surfaces().get() instanceof ShapeSurfaces made)
                || scene.mesh().hasColors()
                || made.shapes().size() != scene.finishes().size()) return Optional.empty();
        List<PlanDecision> decisions = new ArrayList<>();
        var parts = new ShapeScene();
        boolean changed = false;
        boolean any = false;
        for (int i = 0; i < made.shapes().size(); i++) {
            SceneShape shape = made.shapes().get(i);
            Optional<ShapeSteps> full = ShapeSteps.found(scene, shape, i);
            if (full.isEmpty()) {
                if (outOfSight(i)) return Optional.empty();
                any |= addAsItIs(parts, i);
                continue;
            }
            if (outOfSight(i)) {
                decisions.add(
                        PlanDecision.exact(
                                "sight",
                                "part %d: nothing".formatted(i + 1),
                                "part %d: %d faces".formatted(i + 1, full.get().faces()),
                                Reason.of(
                                        "beyond", "all of it is beyond one side of the picture")));
                changed = true;
                continue;
            }
            ShapeSteps least = full.get().faces() < FEW ? full.get() : fewest(shape, full.get(), i);
            changed |= least.faces() < full.get().faces();
            any = true;
            parts.add(shape.faces(least.u(), least.v()), i);
            decisions.add(told(i, least, full.get()));
        }
        return changed && any
                ? Optional.of(new Result(parts.of(scene), decisions))
                : Optional.empty();
    }

    private PlanDecision told(int part, ShapeSteps least, ShapeSteps full) {
        boolean same = least.faces() == full.faces();
        double moved = same ? 0 : (least.sag() + full.sag()) * pixelsPerUnit(part);
        double lit = same ? 0 : perRadian(part) * (least.bend() + full.bend());
        return new PlanDecision(
                "tessellation",
                "part %d: %d×%d".formatted(part + 1, least.u(), least.v()),
                "part %d: %d×%d".formatted(part + 1, full.u(), full.v()),
                same
                        ? Reason.of("needed", "fewer faces would leave the tolerance")
                        : Reason.of(
                                "chord",
                                "κs²/8 is %.3f px at the nearest place, normals turn by %.2g rad:"
                                        + " %.2f levels",
                                moved,
                                least.bend(),
                                lit),
                lit,
                moved);
    }

    /** A part that was not made in steps that are known keeps its faces. */
    private boolean addAsItIs(ShapeScene parts, int finish) {
        int[] faces =
                IntStream.range(0, scene.mesh().faceCount())
                        .filter(f -> scene.finishNumber(f) == finish)
                        .toArray();
        if (faces.length == 0) return false;
        parts.add(scene.only(faces).mesh(), finish);
        return true;
    }

    /** The fewest faces within the tolerance: along the diagonal first, then one step alone. */
    private ShapeSteps fewest(SceneShape shape, ShapeSteps full, int part) {
        double perUnit = pixelsPerUnit(part);
        double perRadian = perRadian(part);
        int low = 1;
        int high = 64;
        while (low < high) {
            int middle = (low + high) / 2;
            if (enough(scaled(shape, full, middle), full, perUnit, perRadian)) high = middle;
            else low = middle + 1;
        }
        ShapeSteps best = high == 64 ? full : scaled(shape, full, high);
        for (int axis = 0; axis < 2; axis++)
            while (true) {
                int u = axis == 0 ? best.u() - Math.max(1, best.u() / 12) : best.u();
                int v = axis == 1 ? best.v() - Math.max(1, best.v() / 12) : best.v();
                if (u < 4 || v < 3 || v > full.v()) break;
                ShapeSteps next = ShapeSteps.of(shape, u, v);
                if (!enough(next, full, perUnit, perRadian)) break;
                best = next;
            }
        return best;
    }

    private static ShapeSteps scaled(SceneShape shape, ShapeSteps full, int of64) {
        int u = Math.max(Math.min(4, full.u()), (full.u() * of64 + 63) / 64);
        int v = Math.max(Math.min(3, full.v()), (full.v() * of64 + 63) / 64);
        return ShapeSteps.of(shape, u, v);
    }

    private boolean enough(ShapeSteps steps, ShapeSteps full, double perUnit, double perRadian) {
        return (steps.sag() + full.sag()) * perUnit <= pixels
                && (steps.bend() + full.bend()) * perRadian <= levels;
    }

    /** Levels for each radian that a normal turns. */
    private double perRadian(int finish) {
        Appearance look = scene.finishes().get(finish);
        return Math.max(perRadian(look.front().surface()), perRadian(look.back().surface()));
    }

    private double perRadian(SurfaceMaterial surface) {
        double sum = 0;
        List<Light> lights = new ArrayList<>(scene.light().model().lights());
        scene.light().atEye().ifPresent(eye -> lights.add(Light.from(eye, 0, 0, 1)));
        boolean half = scene.light().model().reflection() == Reflection.BLINN_PHONG;
        double slope = (half ? 1 : 2) * steepest(surface.shininess());
        for (Light light : lights)
            sum +=
                    most(surface.diffuse(), light.source().diffuse())
                            + slope * most(surface.specular(), light.source().specular());
        return 255 * sum;
    }

    /** The most of |d cosˢ φ/dφ|: √s·((s − 1)/s)^((s − 1)/2). */
    static double steepest(double s) {
        if (s <= 1) return 1;
        return Math.sqrt(s) * Math.pow((s - 1) / s, (s - 1) / 2);
    }

    private static double most(double[] surface, double[] light) {
        double most = 0;
        for (int c = 0; c < 3; c++) most = Math.max(most, surface[c] * light[c]);
        return most;
    }

    /**
     * Pixels on the picture for a world unit at the nearest place of a part, whichever way it goes:
     * f/z times the secant of the angle from the middle, with the room that the camera has.
     */
    private double pixelsPerUnit(int finish) {
        if (!view.transform().central()) return view.fit().pixelsPerUnit();
        Mesh mesh = view.mesh();
        double most = 0;
        for (int f = 0; f < mesh.faceCount(); f++) {
            if (scene.finishNumber(f) != finish) continue;
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                int v = mesh.corner(f, k);
                double z = view.eyeZ(v);
                if (!(z > view.near())) return Double.POSITIVE_INFINITY;
                double secant = Math.hypot(1, Math.hypot(view.eyeX(v), view.eyeY(v)) / z);
                most = Math.max(most, secant / z);
            }
        }
        return CameraRange.ZOOM * most * view.transform().distance() * view.fit().pixelsPerUnit();
    }

    /** Whether all corners of a part are beyond one side of the picture, with the camera's room. */
    private boolean outOfSight(int finish) {
        double distance = view.transform().central() ? view.transform().distance() : 0;
        if (distance == 0) return false;
        var fit = view.fit();
        double[][] sides = {
            {distance, 0, -fit.toPlaneX(-1)}, {-distance, 0, fit.toPlaneX(fit.width())},
            {0, -distance, fit.toPlaneY(-1)}, {0, distance, -fit.toPlaneY(fit.height())}
        };
        for (double[] side : sides) if (beyond(side, finish, distance)) return true;
        return false;
    }

    /** The eye turns about the origin, at that distance, and comes nearer along z. */
    private boolean beyond(double[] side, int finish, double distance) {
        Mesh mesh = view.mesh();
        double length = Math.hypot(Math.hypot(side[0], side[1]), side[2]);
        boolean any = false;
        for (int f = 0; f < mesh.faceCount(); f++) {
            if (scene.finishNumber(f) != finish) continue;
            any = true;
            for (int k = 0; k < mesh.cornerCount(f); k++) {
                int v = mesh.corner(f, k);
                double x = view.eyeX(v);
                double y = view.eyeY(v);
                double z = view.eyeZ(v);
                double fromMiddle = Math.sqrt(x * x + y * y + (z - distance) * (z - distance));
                double nearer = (CameraRange.ZOOM - 1) * distance * Math.abs(side[2]) / length;
                double room = 2 * CameraRange.TURN * fromMiddle + nearer;
                if (!((side[0] * x + side[1] * y + side[2] * z) / length < -room)) return false;
            }
        }
        return any;
    }
}
