package rasterlab.engine.sight;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.buffer.NearnessRange;

/**
 * The cheapest visibility method among those that are proved right for a view.
 *
 * <p>What a method costs is the counted work times the measured cost of its parts; one that is not
 * the triangle pipeline is taken only where it saves at least {@link #WORTH} of it, so that another
 * machine's numbers do not turn a saving into a loss. A proof that costs more than it can save is
 * not tried.
 */
public final class SightChoice {
    /** The triangle pipeline, which is right for all opaque scenes without shared planes. */
    public static final String PIPELINE = "pipeline";

    /** The share that must be saved. */
    private static final double WORTH = 0.35;

    private static final Reason CLOSED =
            Reason.of(
                    "closed",
                    "closed bodies: a back is always behind a front; depths decide the rest");

    private static final Reason APART =
            Reason.of("apart", "no two faces lie over each other in one plane: depths are right");

    private static final Reason MANY =
            Reason.of(
                    "many",
                    "depths are right, unless faces lie over each other in one plane or transparent"
                            + " ones cross");

    private final SightFacts facts;
    private final ViewedMesh view;
    private final Costs costs;

    /**
     * The choice that was made.
     *
     * @param method its name
     * @param frontsOnly whether faces that show their backs are left out, with the pipeline
     * @param reason by which proof or measurement
     * @param milliseconds predicted, of this machine's cores together
     * @param work estimated
     * @param fromHere whether the proof holds from this place only
     */
    public record Sight(
            String method,
            boolean frontsOnly,
            Reason reason,
            double milliseconds,
            PictureWork work,
            boolean fromHere) {}

    public SightChoice(SightFacts facts, ViewedMesh view, Costs costs) {
        this.facts = facts;
        this.view = view;
        this.costs = costs;
    }

    /** Whether faces that show their backs can be left out of this view. */
    public static boolean frontsOnly(SightFacts facts, ViewedMesh view) {
        return view.clipPlaneCount() == 0 && !view.cutsOpen() && facts.closed();
    }

    /**
     * The cheapest of the methods whose pictures are one and the same to the bit: they light faces
     * by one paint, at the same places. The triangle pipeline is none of them, since it works in
     * floats; nor is a buffer with fewer bits.
     *
     * @param light of all faces
     * @param areas of the view's faces
     */
    public Sight exact(LightWork light, ScreenAreas areas) {
        PictureWork work = light.estimate(areas, false, false, 0);
        Optional<Sight> tree = tree(work);
        if (tree.isPresent()) return tree.get();
        double buffer = costs.milliseconds(Family.BUFFER, work, 1);
        if (!facts.glass())
            for (Sight painter : painters((1 - WORTH) * buffer, light, areas)) return painter;
        return new Sight("zfloat", false, facts.few() ? APART : MANY, buffer, work, false);
    }

    /**
     * The cheapest method that is right.
     *
     * @param direct how the pipeline lights
     * @param painted how the other methods light, which have one way for all faces
     * @param areas of the view's faces
     * @param cores that the pipeline works on
     */
    public Sight choose(LightWork direct, LightWork painted, ScreenAreas areas, int cores) {
        boolean fronts = frontsOnly(facts, view);
        PictureWork work = direct.estimate(areas, fronts, false, 0);
        Optional<Sight> tree = tree(work);
        if (tree.isPresent()) return tree.get();
        double pipeline = costs.milliseconds(Family.PIPELINE, work, cores);
        double enough = (1 - WORTH) * pipeline;
        if (!facts.glass()) {
            for (Sight painter : painters(enough, painted, areas)) return painter;
            PictureWork tested = painted.estimate(areas, false, false, 0);
            double buffer = costs.milliseconds(Family.BUFFER, tested, 1);
            if (buffer < enough && facts.few()) return buffered(buffer, tested);
        }
        Reason reason = fronts ? CLOSED : facts.few() ? APART : MANY;
        return new Sight(PIPELINE, fronts, reason, pipeline, work, false);
    }

    /** The tree, where no depth of a whole face is right. */
    private Optional<Sight> tree(PictureWork work) {
        if (facts.overlap(view))
            return forced(
                    Reason.of(
                            "overlap",
                            "faces over each other in one plane: the tree keeps an order"),
                    work);
        if (facts.glass() && facts.crossing(view))
            return forced(
                    Reason.of("crossing", "transparent faces cross: the tree cuts them"), work);
        return Optional.empty();
    }

    private Optional<Sight> forced(Reason reason, PictureWork work) {
        double milliseconds = costs.milliseconds(Family.PAINTER, work, 1);
        return Optional.of(new Sight("bsp", false, reason, milliseconds, work, false));
    }

    /** The painters that are right and take less than {@code enough}, the cheapest first. */
    private List<Sight> painters(double enough, LightWork painted, ScreenAreas areas) {
        List<Sight> right = new ArrayList<>();
        long faces = areas.faces();
        PictureWork all = painted.estimate(areas, false, true, faces * faces / 2);
        PictureWork fronts = painted.estimate(areas, !view.cutsOpen(), true, 4 * faces * faces);
        double convex = costs.milliseconds(Family.PAINTER, fronts, 1);
        if (convex < enough && facts.convex())
            right.add(
                    new Sight(
                            "convex",
                            true,
                            Reason.of(
                                    "convex",
                                    "one convex body: what faces the eye is what is seen"),
                            convex,
                            fronts,
                            false));
        double painter = costs.milliseconds(Family.PAINTER, all, 1);
        if (painter < enough && facts.few() && PaintOrder.proved(view))
            right.add(
                    new Sight(
                            "painter",
                            false,
                            Reason.of(
                                    "order",
                                    "the order by mean depth passes Newell's tests for every two"
                                            + " faces"),
                            painter,
                            all,
                            true));
        right.sort(Comparator.comparingDouble(Sight::milliseconds));
        return right;
    }

    private Sight buffered(double milliseconds, PictureWork work) {
        double separation = Separation.of(view);
        NearnessRange range = NearnessRange.of(view);
        double near = nearest();
        double far = farthest();
        if (!view.transform().central() || !(separation > 0) || !(range.nearest() > 0))
            return new Sight(
                    "zfloat",
                    false,
                    Reason.of("float", "a float tells depths apart"),
                    milliseconds,
                    work,
                    false);
        if (Double.isInfinite(separation)) separation = far - near;
        int bits = DepthBits.fewest(far, near, far, separation);
        String method = bits <= 16 ? "z16" : bits <= 24 ? "z24" : bits <= 32 ? "z32" : "zfloat";
        Reason reason =
                Reason.of(
                        "bits",
                        "faces are %.3g apart in depth: %d bits tell them apart (%.3g at %.4g)",
                        separation,
                        bits,
                        DepthBits.step(bits, far, near, far),
                        far);
        return new Sight(method, false, reason, milliseconds, work, true);
    }

    private double nearest() {
        double least = Double.POSITIVE_INFINITY;
        for (int v = 0; v < view.mesh().vertexCount(); v++) least = Math.min(least, view.eyeZ(v));
        return Math.max(view.near(), least);
    }

    private double farthest() {
        double most = 0;
        for (int v = 0; v < view.mesh().vertexCount(); v++) most = Math.max(most, view.eyeZ(v));
        return Math.min(view.far(), most);
    }
}
