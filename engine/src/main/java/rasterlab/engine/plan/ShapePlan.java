package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.sight.Reason;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.ViewTransform;

/**
 * Fewer steps for the curved surfaces of a scene, and none for what is out of sight.
 *
 * <p>Both meshes, the full one and the coarser, lie within their own rise of the surface; together
 * these must stay below the tolerance where the part is nearest to the eye, so that what is far is
 * coarser. An angle ε between normals changes diffuse light by at most ε·k_d and a highlight by ε
 * times the steepest slope of cosˢ. A texture that is moved against the pixels shows what lies
 * between them, which no pixel had: it may move by no more than its steepest slope allows.
 */
final class ShapePlan {
    /** Meshes of fewer faces are left as they are. */
    private static final int FEW = 64;

    /** Steps of one direction whose rise is looked at alone. */
    private static final int PROBED = 24;

    /** Steps so fine that their own rise does not count. */
    private static final int FINE = 4096;

    /** Factors of the proportion of both directions' steps. */
    private static final double[] LEANS = {0.7, 1, 1.4};

    /** Parts that the way from one step to the full ones is divided into. */
    private static final int PARTS = 512;

    /** The share of the level tolerance that coarser normals may use. */
    static final double LEVELS = 0.5;

    /** Two outlines may move towards each other, and what is between them must not vanish. */
    private static final double OUTLINES = 2;

    private final KnownScene known;
    private final ViewTransform transform;
    private final PictureFit fit;
    private final double pixels;
    private final double levels;

    /**
     * The outcome for a scene.
     *
     * @param narrow whether it holds near the camera only, since parts are out of sight
     */
    record PlannedShapes(Scene scene, List<PlanDecision> decisions, boolean narrow) {}

    ShapePlan(KnownScene known, ViewTransform transform, PictureFit fit, Tolerance tolerance) {
        this.known = known;
        this.transform = transform;
        this.fit = fit;
        pixels = tolerance.pixels() / OUTLINES;
        levels = LEVELS * tolerance.levels();
    }

    /** Leaves out what it can; empty where that is nothing. */
    Optional<PlannedShapes> plan() {
        List<PlanDecision> decisions = new ArrayList<>();
        List<Integer> steps = new ArrayList<>();
        boolean changed = false;
        boolean any = false;
        boolean narrow = false;
        for (ShapePart part : known.parts()) {
            Optional<ShapeSteps> full = part.full();
            boolean gone = outOfSight(part);
            if (full.isEmpty()) {
                if (gone) return Optional.empty();
                any |= part.any();
                steps.addAll(List.of(-1, -1));
            } else if (gone) {
                decisions.add(gone(part, full.get()));
                steps.addAll(List.of(0, 0));
                changed = narrow = true;
            } else {
                ShapeSteps least = full.get();
                if (least.faces() >= FEW && part.mayBeCoarser() && alone(part))
                    least = fewest(part, least);
                changed |= least.faces() < full.get().faces();
                any = true;
                steps.addAll(List.of(least.u(), least.v()));
                decisions.add(decision(part, least, full.get()));
            }
        }
        if (!changed || !any) return Optional.empty();
        Scene scene = known.coarser(steps, () -> made(steps));
        return Optional.of(new PlannedShapes(scene, decisions, narrow));
    }

    /**
     * Whether no other part is in sight. A line along which surfaces cross moves farther than they
     * do, and what is seen of one past another's outline may be narrower than its way.
     */
    private boolean alone(ShapePart part) {
        for (ShapePart other : known.parts())
            if (other != part && other.any() && !outOfSight(other)) return false;
        return true;
    }

    private Scene made(List<Integer> steps) {
        var scene = new ShapeScene();
        for (ShapePart part : known.parts()) {
            int u = steps.get(2 * part.finish());
            int v = steps.get(2 * part.finish() + 1);
            if (u < 0) addAsItIs(scene, part.finish());
            else if (u > 0) scene.add(part.shape().faces(u, v), part.finish());
        }
        return scene.of(known.scene());
    }

    private static PlanDecision gone(ShapePart part, ShapeSteps full) {
        return PlanDecision.exact(
                "sight",
                "part %d: nothing".formatted(part.finish() + 1),
                "part %d: %d faces".formatted(part.finish() + 1, full.faces()),
                Reason.of("beyond", "all of it is beyond one side of the picture"));
    }

    private PlanDecision decision(ShapePart part, ShapeSteps least, ShapeSteps full) {
        boolean same = least.faces() == full.faces();
        double moved = same ? 0 : (least.sag() + full.sag()) * pixelsPerUnit(part);
        double lit = same ? 0 : levels(least, part, full, pixelsPerUnit(part));
        return new PlanDecision(
                "tessellation",
                "part %d: %d×%d".formatted(part.finish() + 1, least.u(), least.v()),
                "part %d: %d×%d".formatted(part.finish() + 1, full.u(), full.v()),
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
    private void addAsItIs(ShapeScene made, int finish) {
        Scene scene = known.scene();
        int[] faces =
                IntStream.range(0, scene.mesh().faceCount())
                        .filter(f -> scene.finishNumber(f) == finish)
                        .toArray();
        if (faces.length > 0) made.add(scene.only(faces).mesh(), finish);
    }

    /**
     * The fewest faces within the tolerance. Where rises of both directions add up to A/u² + B/v²,
     * u·v is least at u:v = √A:√B; at poles both act together, so that other proportions are tried
     * too. In each a few places tell where to begin; from there on all are looked at, until it is
     * enough, and single steps are taken away.
     */
    private ShapeSteps fewest(ShapePart part, ShapeSteps full) {
        double perUnit = pixelsPerUnit(part);
        if (!enough(full, part, full, perUnit)) return full;
        double u = Math.sqrt(part.atLeast(PROBED, FINE).sag());
        double v = Math.sqrt(part.atLeast(FINE, PROBED).sag());
        ShapeSteps begin = full;
        for (double lean : LEANS) {
            ShapeSteps found = begin(lean * u, v, part, full);
            if (found.faces() < begin.faces()) begin = found;
        }
        ShapeSteps next = begin;
        while (next.faces() < full.faces() && !enough(next.u(), next.v(), part, full, perUnit))
            next =
                    part.atLeast(
                            Math.min(full.u(), next.u() + Math.max(1, next.u() / 64)),
                            Math.min(full.v(), next.v() + Math.max(1, next.v() / 64)));
        return next.faces() < full.faces() ? trimmed(next, part, full, perUnit) : full;
    }

    /** The fewest steps in a proportion for which a few places are within the tolerance. */
    private ShapeSteps begin(double u, double v, ShapePart part, ShapeSteps full) {
        double perUnit = pixelsPerUnit(part);
        double finest = Math.max(u > 0 ? full.u() / u : 0, v > 0 ? full.v() / v : 0);
        int low = 1;
        int high = PARTS;
        while (low < high) {
            int middle = (low + high) / 2;
            if (enough(glance(finest * middle / PARTS, u, v, part, full), part, full, perUnit))
                high = middle;
            else low = middle + 1;
        }
        return glance(finest * high / PARTS, u, v, part, full);
    }

    private static ShapeSteps glance(
            double scale, double u, double v, ShapePart part, ShapeSteps full) {
        return part.atLeast(
                steps(scale * u, part.fewestColumns(), full.u()),
                steps(scale * v, part.fewestRows(), full.v()));
    }

    /** Takes away steps while that is enough, of the direction first that saves more faces. */
    private ShapeSteps trimmed(ShapeSteps from, ShapePart part, ShapeSteps full, double perUnit) {
        ShapeSteps best = from;
        while (true) {
            boolean rows = best.u() > best.v();
            int u = best.u();
            int v = best.v();
            if (v > part.fewestRows() && rows && enough(u, v - 1, part, full, perUnit)) v--;
            else if (u > part.fewestColumns() && enough(u - 1, v, part, full, perUnit)) u--;
            else if (v > part.fewestRows() && !rows && enough(u, v - 1, part, full, perUnit)) v--;
            else return best;
            best = part.steps(u, v);
        }
    }

    private static int steps(double wanted, int least, int full) {
        return (int) Math.max(Math.min(least, full), Math.min(full, Math.ceil(wanted)));
    }

    /** Whether steps are within the tolerance; a look at a few places refuses most that are not. */
    private boolean enough(int u, int v, ShapePart part, ShapeSteps full, double perUnit) {
        return enough(part.atLeast(u, v), part, full, perUnit)
                && enough(part.steps(u, v), part, full, perUnit);
    }

    private boolean enough(ShapeSteps steps, ShapePart part, ShapeSteps full, double perUnit) {
        return (steps.sag() + full.sag()) * perUnit <= pixels
                && levels(steps, part, full, perUnit) <= levels;
    }

    /** The levels by which turned normals and a moved texture change what is seen. */
    private static double levels(
            ShapeSteps steps, ShapePart part, ShapeSteps full, double perUnit) {
        return (steps.bend() + full.bend()) * part.levelsPerRadian()
                + (steps.sag() + full.sag()) * perUnit * part.levelsPerPixel();
    }

    /**
     * Pixels on the picture for a world unit at the nearest place of a part, whichever way it goes:
     * f/z times the secant of the angle from the middle, with the room that the camera has.
     *
     * <p>Two balls hold the part. The one about the origin, of radius M, is nearest on the middle
     * line of sight, where f/z is largest while ρ ≥ 2M. The part's own, of radius r about c, α off
     * the direction to the eye, comes as near as {@code ρ − |c|·cos(max(0, α − WIDE)) − r}, and is
     * no farther aside than M.
     */
    private double pixelsPerUnit(ShapePart part) {
        if (!transform.central()) return fit.pixelsPerUnit();
        double rho = transform.distance() / CameraRange.ZOOM;
        double reach = part.reach();
        double aside = Math.hypot(Math.hypot(part.middle(0), part.middle(1)), part.middle(2));
        double towards = 0;
        for (int axis = 0; axis < 3; axis++) towards -= transform.sight(axis) * part.middle(axis);
        double angle = aside > 0 ? Math.acos(Math.max(-1, Math.min(1, towards / aside))) : 0;
        double nearer = aside * Math.cos(Math.max(0, angle - CameraRange.WIDE)) + part.radius();
        double z = rho - Math.min(reach, nearer);
        if (!(z > 0)) return Double.POSITIVE_INFINITY;
        double most = Math.hypot(1, reach / z) / z;
        if (rho >= 2 * reach) most = Math.min(most, 1 / (rho - reach));
        return most * transform.distance() * fit.pixelsPerUnit();
    }

    /** Whether all of a part's box is beyond one side of the picture, with the camera's room. */
    private boolean outOfSight(ShapePart part) {
        double distance = transform.central() ? transform.distance() : 0;
        if (distance == 0 || !part.any()) return false;
        double[][] sides = {
            {distance, 0, -fit.toPlaneX(-1)}, {-distance, 0, fit.toPlaneX(fit.width())},
            {0, -distance, fit.toPlaneY(-1)}, {0, distance, -fit.toPlaneY(fit.height())}
        };
        for (double[] side : sides) if (beyond(side, part, distance)) return true;
        return false;
    }

    /** The eye turns about the origin, at that distance, and comes nearer along z. */
    private boolean beyond(double[] side, ShapePart part, double distance) {
        double length = Math.hypot(Math.hypot(side[0], side[1]), side[2]);
        double nearer = (CameraRange.ZOOM - 1) * distance * Math.abs(side[2]) / length;
        for (double[] at : part.corners()) {
            double x = transform.toEye(0, at[0], at[1], at[2]);
            double y = transform.toEye(1, at[0], at[1], at[2]);
            double z = transform.toEye(2, at[0], at[1], at[2]);
            double fromMiddle = Math.sqrt(x * x + y * y + (z - distance) * (z - distance));
            double room = 2 * CameraRange.TURN * fromMiddle + nearer;
            if (!((side[0] * x + side[1] * y + side[2] * z) / length < -room)) return false;
        }
        return true;
    }
}
