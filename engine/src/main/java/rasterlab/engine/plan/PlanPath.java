package rasterlab.engine.plan;

import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.transform.SphericalView;

/**
 * The time that deciding takes while a camera goes round a scene: by half a degree a picture,
 * nearer and farther by a tenth meanwhile.
 *
 * @param pictures along the path
 * @param plans that were made for them
 * @param firstMilliseconds of processor time for the first picture, its scene unknown before
 * @param milliseconds of processor time for all pictures together, the first one's too
 */
public record PlanPath(int pictures, int plans, double firstMilliseconds, double milliseconds) {
    private static final double STEP = Math.toRadians(0.5);
    private static final double NEARER = 0.1;

    /**
     * Goes along a path that begins at a picture's camera.
     *
     * @param planner that has not met the scene
     */
    public static PlanPath of(
            Planner planner, RenderRequest first, Tolerance tolerance, int pictures) {
        var keeper = new PlanKeeper(planner, tolerance);
        Plan last = null;
        int plans = 0;
        double firstMilliseconds = 0;
        double sum = 0;
        for (int k = 0; k < pictures; k++) {
            RenderRequest picture = moved(first, k, pictures);
            long before = PlanTrial.processorNanos();
            Plan plan = keeper.plan(picture);
            double took = (PlanTrial.processorNanos() - before) / 1e6;
            if (k == 0) firstMilliseconds = took;
            sum += took;
            if (plan != last) plans++;
            last = plan;
        }
        return new PlanPath(pictures, plans, firstMilliseconds, sum);
    }

    /** Milliseconds of processor time for a picture, all being counted. */
    public double perPicture() {
        return milliseconds / pictures;
    }

    private static RenderRequest moved(RenderRequest first, int k, int pictures) {
        SphericalView at = first.camera();
        double wave = 1 - NEARER * Math.sin(2 * Math.PI * k / pictures);
        double rho = Math.max(SphericalView.NEAREST, at.rho() * wave);
        var camera =
                new SphericalView(
                        at.thetaRadians() + k * STEP,
                        at.phiRadians(),
                        Math.min(SphericalView.FARTHEST, rho));
        return first.from(camera);
    }
}
