package rasterlab.engine.plan;

import java.util.Arrays;
import java.util.List;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.MixedLight;
import rasterlab.engine.sight.LightWork;
import rasterlab.engine.sight.Reason;
import rasterlab.engine.sight.ScreenAreas;
import rasterlab.engine.sight.SightChoice.Sight;
import rasterlab.engine.sight.cost.PictureWork;

/**
 * Where light must be worked out: once a face, at corners, at each pixel of some faces, or at each
 * pixel of all.
 *
 * @param direct by the pipeline
 * @param painted by the methods that light all faces alike
 * @param levels by which light mixed from corners may differ where some faces have the formula at
 *     each pixel; 0 where all have, or none
 * @param fromHere whether that holds for this camera only
 * @param directWork of the pipeline
 * @param paintedWork of the other methods
 */
record ShadingPlan(
        ShadingMethod direct,
        ShadingMethod painted,
        double levels,
        boolean fromHere,
        LightWork directWork,
        LightWork paintedWork) {
    /** The least share that mixing must save. */
    private static final double WORTH = 0.9;

    /**
     * The angle by which a camera within range may turn the direction to the eye, off the middle.
     */
    private static final double EYE_TURN = 2.5 * CameraRange.TURN;

    /** The cost of a picture's work, in milliseconds. */
    interface Price {
        double of(PictureWork work);
    }

    /**
     * The faces that are shaded.
     *
     * @param fronts whether backs are left out
     * @param glass whether something is seen through faces, whose order needs one way of lighting
     * @param reads texels read for a pixel
     */
    record Shown(
            RenderRequest request,
            RequestView seen,
            ScreenAreas areas,
            boolean fronts,
            boolean glass,
            int reads) {
        boolean[] drawn() {
            var drawn = new boolean[areas.faces()];
            for (int f = 0; f < drawn.length; f++) drawn[f] = !fronts || !areas.back(f);
            return drawn;
        }

        FaceLights lights() {
            return new FaceLights(
                    seen.scene(), seen.viewed(), request.look().terms(), request.look().sides());
        }
    }

    /** The shading of a plan whose faces are hidden by a method. */
    ShadingMethod planned(Sight sight) {
        return sight.method().equals("pipeline") ? direct : painted;
    }

    /**
     * @param left levels that may still be changed
     * @param decisions gets what was decided
     */
    static ShadingPlan of(Shown shown, double left, Price price, List<PlanDecision> decisions) {
        boolean[] drawn = shown.drawn();
        boolean atEye = shown.seen.scene().light().atEye().isPresent();
        var light = new MixedLight(shown.lights(), left, atEye ? 0 : EYE_TURN);
        boolean[] exact = left > 0 ? light.atPixels(drawn) : drawn;
        if (count(exact) == 0)
            return facewise(shown, light.flatIsEnough(drawn), atEye, left, decisions);
        var phong = new LightWork(false, filled(drawn.length), shown.reads, false);
        if (left > 0 && !shown.glass) {
            boolean[] now = new MixedLight(shown.lights(), left).atPixels(drawn);
            var mixed = new LightWork(true, now, shown.reads, true);
            double all = price.of(phong.estimate(shown.areas, shown.fronts, false, 0));
            double some = price.of(mixed.estimate(shown.areas, shown.fronts, false, 0));
            if (some < WORTH * all) {
                decisions.add(
                        new PlanDecision(
                                "shading",
                                "phong where it counts",
                                "phong",
                                Reason.of(
                                        "mixed",
                                        "%d of %d faces need the formula at each pixel; on the"
                                                + " others light mixed from corners is within the"
                                                + " bound",
                                        count(now),
                                        count(drawn)),
                                left,
                                0));
                return new ShadingPlan(
                        ShadingMethod.PHONG, ShadingMethod.PHONG, left, false, mixed, phong);
            }
        }
        decisions.add(
                PlanDecision.exact(
                        "shading",
                        "phong",
                        "phong",
                        Reason.of(
                                "phong",
                                "%d of %d faces need the formula at each pixel",
                                count(exact),
                                count(drawn))));
        return new ShadingPlan(ShadingMethod.PHONG, ShadingMethod.PHONG, 0, false, phong, phong);
    }

    private static ShadingPlan facewise(
            Shown shown, boolean flat, boolean atEye, double left, List<PlanDecision> decisions) {
        ShadingMethod way = flat ? ShadingMethod.FLAT : ShadingMethod.GOURAUD;
        Reason reason =
                flat
                        ? Reason.of(
                                "flat", "within each face light differs by less from its middle's")
                        : Reason.of(
                                "corners",
                                "light mixed from corners is within the bound on all faces");
        decisions.add(new PlanDecision("shading", way.code(), "phong", reason, left, 0));
        var work = new LightWork(!flat, new boolean[shown.areas.faces()], shown.reads, false);
        return new ShadingPlan(way, way, 0, atEye, work, work);
    }

    private static boolean[] filled(int faces) {
        var all = new boolean[faces];
        Arrays.fill(all, true);
        return all;
    }

    private static int count(boolean[] faces) {
        int count = 0;
        for (boolean face : faces) if (face) count++;
        return count;
    }
}
