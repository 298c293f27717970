package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.shape.SceneShape;
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
 *
 * <p>Only the outline needs that. Within it a rise moves nothing that is seen, but for the normal
 * that a pixel gets: where a part has no texture, blocks of its cells become one face each ({@link
 * InnerBlocks}).
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
    private final double milliseconds;

    /**
     * The outcome for a scene.
     *
     * @param turn of the camera for which it holds, radians
     */
    record PlannedShapes(Scene scene, List<PlanDecision> decisions, double turn) {}

    /**
     * How one part is made.
     *
     * @param steps that it is made in; empty where it keeps its faces or is out of sight
     * @param gone whether it is out of sight
     */
    private record PlannedPart(
            ShapePart part,
            boolean gone,
            Optional<ShapeSteps> steps,
            Optional<InnerBlocks> inner) {}

    /**
     * @param milliseconds that the full picture takes
     */
    ShapePlan(
            KnownScene known,
            ViewTransform transform,
            PictureFit fit,
            Tolerance tolerance,
            double milliseconds) {
        this.known = known;
        this.transform = transform;
        this.fit = fit;
        pixels = tolerance.pixels() / OUTLINES;
        levels = LEVELS * tolerance.levels();
        this.milliseconds = milliseconds;
    }

    /** Leaves out what it can; empty where that is nothing. */
    Optional<PlannedShapes> plan() {
        List<PlannedPart> parts = new ArrayList<>();
        List<PlanDecision> decisions = new ArrayList<>();
        boolean changed = false;
        boolean any = false;
        double turn = CameraRange.WIDE;
        for (ShapePart part : known.parts()) {
            PlannedPart planned = planned(part);
            parts.add(planned);
            any |= part.any() && !planned.gone;
            if (part.full().isEmpty()) {
                if (planned.gone) return Optional.empty();
                continue;
            }
            PlanDecision decision =
                    planned.gone ? gone(part, part.full().get()) : decision(planned);
            decisions.add(decision);
            changed |= decision.saves();
            if (planned.gone) turn = Math.min(turn, CameraRange.TURN);
            if (planned.inner.isPresent()) turn = Math.min(turn, CameraRange.OUTLINE);
        }
        if (!changed || !any) return Optional.empty();
        return Optional.of(new PlannedShapes(made(parts), decisions, turn));
    }

    private PlannedPart planned(ShapePart part) {
        Optional<ShapeSteps> full = part.full();
        if (outOfSight(part))
            return new PlannedPart(part, true, Optional.empty(), Optional.empty());
        if (full.isEmpty()) return new PlannedPart(part, false, full, Optional.empty());
        ShapeSteps least = full.get();
        if (least.faces() < FEW || !part.mayBeCoarser() || !alone(part))
            return new PlannedPart(part, false, full, Optional.empty());
        least = fewest(part, least);
        return new PlannedPart(part, false, Optional.of(least), inner(part, least, full.get()));
    }

    /** The blocks of cells that may be one face each; empty where they save too little. */
    private Optional<InnerBlocks> inner(ShapePart part, ShapeSteps least, ShapeSteps full) {
        if (part.levelsPerPixel() > 0) return Optional.empty();
        var allowed =
                new InnerBlocks.Allowed(
                        full,
                        part.shape().isConvexBody(),
                        part.levelsPerRadian(),
                        pixels / pixelsPerUnit(part),
                        levels);
        EyeRange eye = EyeRange.of(transform, CameraRange.OUTLINE);
        return InnerBlocks.fewest(part, least, eye, allowed, milliseconds);
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

    /** Meshes that are the same from all sides are made once. */
    private Scene made(List<PlannedPart> parts) {
        if (parts.stream().anyMatch(planned -> planned.inner.isPresent())) return scene(parts);
        List<Integer> steps = new ArrayList<>();
        for (PlannedPart planned : parts) {
            int none = planned.gone ? 0 : -1;
            steps.add(planned.steps.map(ShapeSteps::u).orElse(none));
            steps.add(planned.steps.map(ShapeSteps::v).orElse(none));
        }
        return known.coarser(steps, () -> scene(parts));
    }

    private Scene scene(List<PlannedPart> parts) {
        PlannedPart first = parts.get(0);
        if (parts.size() == 1 && first.steps.isPresent())
            return ShapeScene.of(known.scene(), mesh(first, first.steps.get()));
        var scene = new ShapeScene();
        for (PlannedPart planned : parts) {
            if (planned.gone) continue;
            int finish = planned.part.finish();
            if (planned.steps.isPresent()) scene.add(mesh(planned, planned.steps.get()), finish);
            else addAsItIs(scene, finish);
        }
        return scene.of(known.scene());
    }

    private static Mesh mesh(PlannedPart planned, ShapeSteps steps) {
        SceneShape shape = planned.part.shape();
        return planned.inner
                .map(inner -> shape.faces(steps.u(), steps.v(), inner))
                .orElseGet(() -> shape.faces(steps.u(), steps.v()));
    }

    private static PlanDecision gone(ShapePart part, ShapeSteps full) {
        return PlanDecision.exact(
                "sight",
                "part %d: nothing".formatted(part.finish() + 1),
                "part %d: %d faces".formatted(part.finish() + 1, full.faces()),
                Reason.of("beyond", "all of it is beyond one side of the picture"));
    }

    private PlanDecision decision(PlannedPart planned) {
        ShapePart part = planned.part;
        ShapeSteps full = part.full().orElseThrow();
        ShapeSteps least = planned.steps.orElseThrow();
        boolean same = least.faces() == full.faces();
        double perUnit = pixelsPerUnit(part);
        double moved = same ? 0 : (least.sag() + full.sag()) * perUnit;
        double lit = same ? 0 : levels(least, part, full, perUnit);
        String all = "part %d: %d×%d".formatted(part.finish() + 1, full.u(), full.v());
        String some = "part %d: %d×%d".formatted(part.finish() + 1, least.u(), least.v());
        if (planned.inner.isPresent()) {
            InnerBlocks inner = planned.inner.get();
            double within = (inner.sag() + full.sag()) * perUnit;
            return new PlanDecision(
                    "tessellation",
                    "%s, inside ÷%d".formatted(some, inner.side()),
                    all,
                    Reason.of(
                            "inside",
                            "κs²/8 is %.3f px on the outline and %.3f px inside, where %d×%d"
                                    + " cells are one: %.2f levels",
                            moved,
                            within,
                            inner.side(),
                            inner.side(),
                            Math.max(lit, inner.levels())),
                    Math.max(lit, inner.levels()),
                    Math.max(moved, within));
        }
        return new PlanDecision(
                "tessellation",
                some,
                all,
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
