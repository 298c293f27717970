package rasterlab.engine.plan;

import java.util.Optional;
import rasterlab.engine.pipeline.RenderRequest;

/**
 * Keeps a plan while a camera moves within the range that it was proved for, so that most pictures
 * cost no decision.
 *
 * <p>One thread at a time.
 */
public final class PlanKeeper {
    private final Planner planner;
    private final Tolerance tolerance;
    private Optional<RenderRequest> asked = Optional.empty();
    private Optional<Plan> kept = Optional.empty();

    public PlanKeeper(Planner planner, Tolerance tolerance) {
        this.planner = planner;
        this.tolerance = tolerance;
    }

    /** A plan whose range holds a picture's camera: the one before, or a new one. */
    public Plan plan(RenderRequest picture) {
        if (kept.isEmpty() || !sameBut(asked.orElseThrow(), picture)) {
            kept = Optional.of(planner.plan(picture, tolerance));
            asked = Optional.of(picture);
        }
        return kept.get();
    }

    /** Whether two pictures differ in nothing but a camera that the plan holds for. */
    private boolean sameBut(RenderRequest before, RenderRequest now) {
        return KnownScene.alike(before, now)
                && kept.orElseThrow().within(now.camera())
                && before.from(now.camera()).depth().equals(now.depth());
    }
}
