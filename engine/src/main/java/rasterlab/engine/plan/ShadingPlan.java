package rasterlab.engine.plan;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.MixedLight;
import rasterlab.engine.sight.LightWork;
import rasterlab.engine.sight.Reason;
import rasterlab.engine.sight.SightChoice.ChosenVisibility;
import rasterlab.engine.sight.cost.PictureWork;

/**
 * Where light must be worked out: once a face, at corners, at each pixel of some faces, or at each
 * pixel of all.
 *
 * @param direct by the pipeline
 * @param painted by the methods that light all faces alike
 * @param levels by which light mixed from corners may differ where some faces have the formula at
 *     each pixel; 0 where all have, or none
 * @param around whether that holds from all around, not near the camera alone
 * @param directWork of the pipeline
 * @param paintedWork of the other methods
 */
record ShadingPlan(
        ShadingMethod direct,
        ShadingMethod painted,
        double levels,
        boolean around,
        LightWork directWork,
        LightWork paintedWork) {
    /** The least share that mixing must save. */
    private static final double WORTH = 0.9;

    /**
     * The angle by which a camera within range may turn the direction to the eye, off the middle.
     */
    private static final double EYE_TURN = 2.5 * CameraRange.TURN;

    /**
     * The light formulas that asking one face of a whole mesh whether less is enough is worth, as
     * measured on meshes of 10⁵ faces and more.
     */
    private static final int ASKED = 6;

    /** The pictures that a plan is kept for at least, while the camera turns by half a degree. */
    private static final int PICTURES = 4;

    /** The share of the full picture's time that deciding may take. */
    private static final double DECIDING = 0.03;

    /** The cost of a picture's work, in milliseconds. */
    interface Price {
        double of(PictureWork work);
    }

    /** The shading of a plan whose faces are hidden by a method. */
    ShadingMethod planned(ChosenVisibility sight) {
        return sight.method().equals("pipeline") ? direct : painted;
    }

    /**
     * @param shown the faces, by a sample
     * @param reads texels read for a pixel
     * @param left levels that may still be changed
     * @param decisions gets what was decided
     */
    static ShadingPlan of(
            ShownFaces shown, int reads, double left, Price price, List<PlanDecision> decisions) {
        boolean[] drawn = shown.drawn(shown.seen());
        boolean[] now = drawn;
        boolean unasked = false;
        var phong = new LightWork(false, filled(drawn.length), reads, false);
        double all = price.of(phong.estimate(shown.areas(), shown.fronts(), false, 0));
        if (left > 0) {
            Sufficiency enough =
                    Sufficiency.of(shown, left, asking(shown, price) <= DECIDING * PICTURES * all);
            if (enough.smooth) return facewise(shown, reads, enough, left, decisions);
            unasked = enough.unasked;
            now = new MixedLight(shown.lights(shown.seen()), left).atPixels(drawn);
        }
        if (left > 0 && !shown.facts().glass()) {
            var mixed = new LightWork(true, now, reads, true);
            double some = price.of(mixed.estimate(shown.areas(), shown.fronts(), false, 0));
            if (some < WORTH * all) {
                Reason reason =
                        Reason.of(
                                "mixed",
                                "%d of %d faces that were looked at need the formula at each"
                                        + " pixel; on the others light mixed from corners is within"
                                        + " the bound",
                                count(now),
                                count(drawn));
                decisions.add(
                        new PlanDecision(
                                "shading", "phong where it counts", "phong", reason, left, 0));
                return new ShadingPlan(
                        ShadingMethod.PHONG, ShadingMethod.PHONG, left, true, mixed, phong);
            }
        }
        Reason reason =
                unasked
                        ? Reason.of(
                                "unasked",
                                "whether less is enough on each of %d faces is not asked: that"
                                        + " would take longer than %.0f %% of the pictures it"
                                        + " holds for",
                                shown.areas().allFaces(),
                                100 * DECIDING)
                        : Reason.of(
                                "phong",
                                "%d of %d faces that were looked at need the formula at each pixel",
                                count(now),
                                count(drawn));
        decisions.add(PlanDecision.exact("shading", "phong", "phong", reason));
        return new ShadingPlan(ShadingMethod.PHONG, ShadingMethod.PHONG, 0, true, phong, phong);
    }

    /**
     * Whether less than the formula at each pixel is enough on all faces.
     *
     * @param smooth whether light mixed from corners is
     * @param flat whether one colour a face is
     * @param everywhere whether that holds from all around
     * @param unasked whether it might be, but asking all faces would take too long
     */
    private record Sufficiency(boolean smooth, boolean flat, boolean everywhere, boolean unasked) {
        static final Sufficiency NEITHER = new Sufficiency(false, false, false, false);
        static final Sufficiency UNASKED = new Sufficiency(false, false, false, true);

        /**
         * Asks the sample first: one face of it that needs more decides.
         *
         * @param affordable whether all faces of a view may be asked where the sample does not
         *     decide; without that, each pixel keeps its formula
         */
        static Sufficiency of(ShownFaces shown, double left, boolean affordable) {
            Optional<MixedLight.Apart> always =
                    shown.known().apart(shown.request(), shown.fronts());
            if (always.isPresent()) return of(always.get(), left, true);
            // A lamp that goes with the eye would have to be proved again for each picture.
            if (shown.request().scene().light().atEye().isPresent()) return NEITHER;
            boolean[] sampled = shown.drawn(shown.seen(), EYE_TURN);
            var few = new MixedLight(shown.lights(shown.seen()), left, EYE_TURN).apart(sampled);
            if (few.mixed() > left || shown.areas().whole()) return of(few, left, false);
            if (!affordable) return UNASKED;
            RequestView all = shown.all();
            var light = new MixedLight(shown.lights(all), left, EYE_TURN);
            return of(light.apart(shown.drawn(all, EYE_TURN)), left, false);
        }

        private static Sufficiency of(MixedLight.Apart apart, double left, boolean everywhere) {
            if (apart.mixed() > left) return NEITHER;
            return new Sufficiency(true, apart.flat() <= left, everywhere, false);
        }
    }

    /** Predicts the milliseconds that asking all faces of a view takes. */
    private static double asking(ShownFaces shown, Price price) {
        long formulas = ASKED * shown.areas().allFaces();
        double picture = price.of(new PictureWork(0, 0, 0, 0, 0, 0, 0, 0, 0));
        return price.of(new PictureWork(0, 0, 0, formulas, 0, 0, 0, 0, 0)) - picture;
    }

    private static ShadingPlan facewise(
            ShownFaces shown,
            int reads,
            Sufficiency enough,
            double left,
            List<PlanDecision> decisions) {
        ShadingMethod way = enough.flat ? ShadingMethod.FLAT : ShadingMethod.GOURAUD;
        Reason reason =
                enough.flat
                        ? Reason.of(
                                "flat", "within each face light differs by less from its middle's")
                        : Reason.of(
                                "corners",
                                "light mixed from corners is within the bound on all faces");
        decisions.add(new PlanDecision("shading", way.code(), "phong", reason, left, 0));
        var work = new LightWork(!enough.flat, new boolean[shown.areas().faces()], reads, false);
        return new ShadingPlan(way, way, 0, enough.everywhere, work, work);
    }

    private static boolean[] filled(int faces) {
        var all = new boolean[faces];
        Arrays.fill(all, true);
        return all;
    }

    static int count(boolean[] faces) {
        int count = 0;
        for (boolean face : faces) if (face) count++;
        return count;
    }
}
