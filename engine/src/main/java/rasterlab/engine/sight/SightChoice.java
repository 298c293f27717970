package rasterlab.engine.sight;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;
import rasterlab.engine.visibility.ViewedMesh;

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
    static final double WORTH = 0.35;

    static final Reason APART =
            Reason.of("apart", "no two faces lie over each other in one plane: depths are right");

    static final Reason MANY =
            Reason.of(
                    "many",
                    "depths are right, unless faces lie over each other in one plane or transparent"
                            + " ones cross");

    private final SightFacts facts;
    private final Supplier<ViewedMesh> view;
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
    public record ChosenVisibility(
            String method,
            boolean frontsOnly,
            Reason reason,
            double milliseconds,
            PictureWork work,
            boolean fromHere) {}

    /**
     * @param view of the whole mesh, asked for where a proof needs it
     */
    public SightChoice(SightFacts facts, Supplier<ViewedMesh> view, Costs costs) {
        this.facts = facts;
        this.view = view;
        this.costs = costs;
    }

    /**
     * The cheapest of the methods whose pictures are one and the same to the bit: they light faces
     * by one paint, at the same places. The triangle pipeline is none of them, since it works in
     * floats; nor is a buffer with fewer bits.
     *
     * @param light of all faces
     * @param areas of the view's faces
     */
    public ChosenVisibility exact(LightWork light, ScreenAreas areas) {
        PictureWork work = light.estimate(areas, false, false, 0);
        Optional<ChosenVisibility> tree = tree(work);
        if (tree.isPresent()) return tree.get();
        double buffer = costs.milliseconds(Family.BUFFER, work, 1);
        if (!facts.glass())
            for (ChosenVisibility painter :
                    painters((1 - WORTH) * buffer, light, areas, view.get().cutsOpen(), true))
                return painter;
        return new ChosenVisibility(
                "zfloat", false, facts.few() ? APART : MANY, buffer, work, false);
    }

    /** The tree, where no depth of a whole face is right. */
    Optional<ChosenVisibility> tree(PictureWork work) {
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

    private Optional<ChosenVisibility> forced(Reason reason, PictureWork work) {
        double milliseconds = costs.milliseconds(Family.PAINTER, work, 1);
        return Optional.of(new ChosenVisibility("bsp", false, reason, milliseconds, work, false));
    }

    /**
     * The painters that are right and take less than {@code enough}, the cheapest first.
     *
     * @param open whether the near plane may cut the mesh open
     * @param ordered whether an order of the faces may be proved, pair by pair
     */
    List<ChosenVisibility> painters(
            double enough, LightWork painted, ScreenAreas areas, boolean open, boolean ordered) {
        List<ChosenVisibility> right = new ArrayList<>();
        long faces = areas.allFaces();
        PictureWork all = painted.estimate(areas, false, true, faces * faces / 2);
        PictureWork fronts = painted.estimate(areas, !open, true, 4 * faces * faces);
        double convex = costs.milliseconds(Family.PAINTER, fronts, 1);
        if (convex < enough && facts.convex())
            right.add(
                    new ChosenVisibility(
                            "convex",
                            true,
                            Reason.of(
                                    "convex",
                                    "one convex body: what faces the eye is what is seen"),
                            convex,
                            fronts,
                            false));
        double painter = costs.milliseconds(Family.PAINTER, all, 1);
        if (ordered && painter < enough && facts.few() && PaintOrder.proved(view.get()))
            right.add(
                    new ChosenVisibility(
                            "painter",
                            false,
                            Reason.of(
                                    "order",
                                    "the order by mean depth passes Newell's tests for every two"
                                            + " faces"),
                            painter,
                            all,
                            true));
        right.sort(Comparator.comparingDouble(ChosenVisibility::milliseconds));
        return right;
    }
}
