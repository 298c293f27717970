package rasterlab.engine.plan;

import java.util.List;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.sight.cost.PictureWork;
import rasterlab.engine.transform.SphericalView;

/**
 * The least that must be drawn of a scene, why, and for which cameras that holds.
 *
 * @param full what the full pipeline draws
 * @param least what is drawn instead
 * @param tolerance within which both are alike
 * @param decisions what was decided, each with its reason
 * @param range the cameras for which the proofs hold
 * @param fullCost of the full picture, predicted
 * @param cost of the least one, predicted
 * @param decidingMilliseconds that the decisions took
 */
public record Plan(
        RenderRequest full,
        RenderRequest least,
        Tolerance tolerance,
        List<PlanDecision> decisions,
        CameraRange range,
        PlanCost fullCost,
        PlanCost cost,
        double decidingMilliseconds) {
    public Plan {
        decisions = List.copyOf(decisions);
    }

    /**
     * The work that a picture takes.
     *
     * @param work estimated
     * @param milliseconds predicted from the work
     */
    public record PlanCost(PictureWork work, double milliseconds) {}

    /** Whether the plan may be kept for a camera. */
    public boolean within(SphericalView camera) {
        return range.within(camera);
    }

    /**
     * The picture to draw from a camera.
     *
     * @throws IllegalArgumentException if the plan's proofs do not hold there
     */
    public RenderRequest from(SphericalView camera) {
        if (!within(camera))
            throw new IllegalArgumentException(
                    "camera must be within %s, got %s".formatted(range, camera));
        return least.from(camera);
    }

    /** Whether another plan is of the same picture, but for the camera, and as strict. */
    public boolean isLike(Plan other) {
        return tolerance.equals(other.tolerance) && KnownScene.alike(full, other.full);
    }

    /** Whether anything is left out. */
    public boolean saves() {
        return decisions.stream().anyMatch(PlanDecision::saves);
    }

    /** The largest bound of the decisions together, in levels. */
    public double predictedLevels() {
        return decisions.stream().mapToDouble(PlanDecision::levels).sum();
    }

    /** The largest distance that something may be moved by, in pixels. */
    public double predictedPixels() {
        return decisions.stream().mapToDouble(PlanDecision::pixels).max().orElse(0);
    }
}
