package rasterlab.engine.sight;

import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.engine.sight.SightChoice.ChosenVisibility;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The cheapest visibility method that is right for all cameras of a range, by what is known of the
 * scene; only where its faces are very few is an order proved for one camera. Where textures are
 * read, the pipeline is always the cheapest: its own lookups go row by row.
 */
public final class SightPlan {
    /** The order of so many faces is proved in less time than it saves in one picture. */
    private static final int ORDERED = 24;

    private static final Reason CLOSED =
            Reason.of(
                    "closed",
                    "closed bodies: a back is always behind a front; depths decide the rest");

    private final SightFacts facts;
    private final Optional<DepthReach> reach;
    private final Costs costs;
    private final SightChoice choice;

    /**
     * @param reach of the scene; empty in parallel projection
     * @param view of the whole mesh, asked for where a proof needs it
     */
    public SightPlan(
            SightFacts facts, Optional<DepthReach> reach, Supplier<ViewedMesh> view, Costs costs) {
        this.facts = facts;
        this.reach = reach;
        this.costs = costs;
        choice = new SightChoice(facts, view, costs);
    }

    /**
     * The cheapest method that is right.
     *
     * @param direct how the pipeline lights
     * @param painted how the other methods light, which have one way for all faces
     * @param areas of the view's faces, or of a sample of them
     * @param fronts whether faces that show their backs are left out
     * @param cores that the pipeline works on
     */
    public ChosenVisibility choose(
            LightWork direct, LightWork painted, ScreenAreas areas, boolean fronts, int cores) {
        PictureWork work = direct.estimate(areas, fronts, false, 0);
        Optional<ChosenVisibility> tree = choice.tree(work);
        if (tree.isPresent()) return tree.get();
        double pipeline = costs.milliseconds(Family.PIPELINE, work, cores);
        double enough = (1 - SightChoice.WORTH) * pipeline;
        if (!facts.glass() && facts.few() && painted.texelReads() == 0) {
            boolean open = reach.isEmpty() || !reach.get().whole();
            boolean ordered = areas.allFaces() <= ORDERED;
            for (ChosenVisibility painter : choice.painters(enough, painted, areas, open, ordered))
                return painter;
            PictureWork tested = painted.estimate(areas, false, false, 0);
            double buffer = costs.milliseconds(Family.BUFFER, tested, 1);
            if (buffer < enough && !open && facts.separation() > 0)
                return buffered(buffer, tested, reach.get());
        }
        Reason reason = fronts ? CLOSED : facts.few() ? SightChoice.APART : SightChoice.MANY;
        return new ChosenVisibility(SightChoice.PIPELINE, fronts, reason, pipeline, work, false);
    }

    /**
     * The buffer with the fewest bits that tell the faces apart. Faces that touch have depths that
     * no number of bits does.
     */
    private ChosenVisibility buffered(double milliseconds, PictureWork work, DepthReach depths) {
        double near = depths.near();
        double far = depths.far();
        double separation = Math.min(far - near, facts.separation() / depths.secant());
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
        return new ChosenVisibility(method, false, reason, milliseconds, work, false);
    }
}
