package rasterlab.engine.plan;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.direct.Savings;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.sight.DepthReach;
import rasterlab.engine.sight.LightWork;
import rasterlab.engine.sight.Reason;
import rasterlab.engine.sight.ScreenAreas;
import rasterlab.engine.sight.SightChoice.ChosenVisibility;
import rasterlab.engine.sight.SightFacts;
import rasterlab.engine.sight.SightPlan;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.SphericalView;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * Decides what of a scene must be drawn so that the picture stays within a tolerance of the full
 * pipeline's: all faces by depth, the light formula at each pixel, mipmaps.
 *
 * <p>The levels of the tolerance are a budget: what coarser faces may change of it is taken off
 * first, the rest is left to shading and textures. What is known of a scene is kept for its next
 * plan.
 */
public final class Planner {
    /** Scenes that are kept: what is asked for, lit and drawn, now and before. */
    private static final int KEPT = 9;

    /** A plan must be predicted to take less than this share of the full picture's time. */
    private static final double WORTH = 0.95;

    private final Costs costs;
    private final int cores;
    private final Deque<KnownScene> known = new ArrayDeque<>();

    public Planner() {
        this(Runtime.getRuntime().availableProcessors(), Costs.measured());
    }

    /**
     * @param cores that pictures are drawn on
     * @param costs by which the cheapest way is chosen
     */
    public Planner(int cores, Costs costs) {
        this.cores = cores;
        this.costs = costs;
    }

    /** A planner with the same costs that has met no scene. */
    public Planner fresh() {
        return new Planner(cores, costs);
    }

    /** Where the costs come from. */
    public String costOrigin() {
        return costs.origin();
    }

    /** The full pipeline's picture of a view: what a plan is held against. */
    public RenderRequest full(RenderRequest asked) {
        SightFacts facts = known(asked.scene()).facts();
        Supplier<ViewedMesh> view = () -> RequestView.of(asked, asked.width()).viewed();
        boolean tree = facts.overlap(view) || facts.glass() && facts.crossing(view);
        boolean textured =
                asked.look().texture() != TextureMode.NONE
                        && asked.scene().finishes().stream().anyMatch(f -> f.texture().isPresent());
        Look look =
                asked.look()
                        .withSavings(Savings.NONE)
                        .withVisibility(tree ? "bsp" : Renderer.PIPELINE)
                        .withShading(ShadingMethod.PHONG)
                        .withTexture(textured ? TextureMode.MIPMAP : TextureMode.NONE);
        return asked.with(look);
    }

    /**
     * @param asked the scene, camera and size; how it says it is drawn does not count
     */
    public synchronized Plan plan(RenderRequest asked, Tolerance tolerance) {
        long start = System.nanoTime();
        RenderRequest full = full(asked);
        var whole = ShownFaces.of(full, known(full.scene()), false);
        LeastLight light = whole.known().light(tolerance.levels());
        List<PlanDecision> decisions = new ArrayList<>(light.decisions());
        ViewedMesh view = whole.seen().viewed();
        KnownScene lit = known(light.scene());
        Plan.PlanCost all = fullCost(full, whole.areas());
        Optional<ShapePlan.PlannedShapes> parts =
                new ShapePlan(lit, view.transform(), view.fit(), tolerance, all.milliseconds())
                        .plan();
        parts.ifPresent(result -> decisions.addAll(result.decisions()));
        RenderRequest request =
                full.with(parts.map(ShapePlan.PlannedShapes::scene).orElse(light.scene()));
        KnownScene known = known(request.scene());
        Optional<DepthReach> reach = reach(request, view, known.facts());
        ShownFaces shown = ShownFaces.of(request, known, fronts(request, reach, known.facts()));
        double left = tolerance.levels() - light.levels() - ofFaces(parts);
        TexturePlan texturing = TexturePlan.of(full, shown, left, decisions);
        left -= texturing.levels();
        ShadingPlan shading =
                ShadingPlan.of(shown, texturing.reads(), left, this::predicted, decisions);
        ChosenVisibility sight = sight(shown, reach, shading, decisions);
        Look look =
                request.look()
                        .withVisibility(sight.method())
                        .withShading(shading.planned(sight))
                        .withTexture(texturing.mode())
                        .withSavings(new Savings(shading.levels(), sight.frontsOnly()));
        if (sight.milliseconds() > WORTH * all.milliseconds())
            return whole(full, tolerance, kept(decisions, full, sight, all), all, start);
        boolean here = sight.fromHere() || texturing.fromHere();
        double turn =
                Math.min(
                        shading.around() ? CameraRange.WIDE : CameraRange.TURN,
                        parts.map(ShapePlan.PlannedShapes::turn).orElse(CameraRange.WIDE));
        return new Plan(
                full,
                request.with(look),
                tolerance,
                decisions,
                range(full.camera(), here, turn),
                all,
                new Plan.PlanCost(sight.work(), sight.milliseconds()),
                (System.nanoTime() - start) / 1e6);
    }

    private static CameraRange range(SphericalView at, boolean here, double turn) {
        return here ? CameraRange.only(at) : CameraRange.turned(at, turn);
    }

    /** The depths that a scene has in a plan's range; empty in parallel projection. */
    private static Optional<DepthReach> reach(
            RenderRequest request, ViewedMesh view, SightFacts facts) {
        if (!view.transform().central()) return Optional.empty();
        double rho = view.transform().distance();
        PictureFit fit = view.fit();
        double tangent =
                Math.hypot(
                                Math.max(-fit.toPlaneX(0), fit.toPlaneX(fit.width())),
                                Math.max(fit.toPlaneY(0), -fit.toPlaneY(fit.height())))
                        / rho;
        return Optional.of(
                DepthReach.of(
                        facts.radius(),
                        rho / CameraRange.ZOOM,
                        rho * CameraRange.ZOOM,
                        request.depth().near(),
                        tangent));
    }

    /** Whether faces that show their backs can be left out, wherever the camera is in its range. */
    private static boolean fronts(
            RenderRequest request, Optional<DepthReach> reach, SightFacts facts) {
        return request.look().clipPlanes().isEmpty()
                && reach.map(DepthReach::whole).orElse(false)
                && facts.closed();
    }

    /** The plan that leaves nothing out, for what no other plan is enough. */
    public Plan nothingLeftOut(RenderRequest asked, Tolerance tolerance) {
        long start = System.nanoTime();
        RenderRequest full = full(asked);
        ShownFaces shown = ShownFaces.of(full, known(full.scene()), false);
        return whole(full, tolerance, List.of(), fullCost(full, shown.areas()), start);
    }

    private static Plan whole(
            RenderRequest full,
            Tolerance tolerance,
            List<PlanDecision> decisions,
            Plan.PlanCost cost,
            long start) {
        return new Plan(
                full,
                full,
                tolerance,
                decisions,
                CameraRange.turned(full.camera(), CameraRange.WIDE),
                cost,
                cost,
                (System.nanoTime() - start) / 1e6);
    }

    /** Decisions of a plan that keeps all, since what it could leave out is worth too little. */
    private static List<PlanDecision> kept(
            List<PlanDecision> decisions,
            RenderRequest full,
            ChosenVisibility sight,
            Plan.PlanCost all) {
        List<PlanDecision> kept = new ArrayList<>();
        for (PlanDecision decision : decisions)
            if (!decision.saves() && !decision.subject().equals("visibility")) kept.add(decision);
        kept.add(
                PlanDecision.exact(
                        "visibility",
                        full.visibility(),
                        full.visibility(),
                        Reason.of(
                                "small",
                                "what could be left out is %.0f %% of the predicted cost; a gain"
                                        + " below %.0f %% may be lost on another machine",
                                Math.max(0, 100 * (1 - sight.milliseconds() / all.milliseconds())),
                                100 * (1 - WORTH))));
        return kept;
    }

    /** The levels that coarser faces may change; parts are beside each other. */
    private static double ofFaces(Optional<ShapePlan.PlannedShapes> parts) {
        return parts.stream()
                .flatMap(result -> result.decisions().stream())
                .mapToDouble(PlanDecision::levels)
                .max()
                .orElse(0);
    }

    private double predicted(PictureWork work) {
        return costs.milliseconds(Family.PIPELINE, work, cores);
    }

    private ChosenVisibility sight(
            ShownFaces shown,
            Optional<DepthReach> reach,
            ShadingPlan shading,
            List<PlanDecision> decisions) {
        var choice = new SightPlan(shown.facts(), reach, () -> shown.all().viewed(), costs);
        ChosenVisibility sight =
                choice.choose(
                        shading.directWork(),
                        shading.paintedWork(),
                        shown.areas(),
                        shown.fronts(),
                        cores);
        String method = sight.method();
        boolean fronts = sight.frontsOnly() && method.equals(Renderer.PIPELINE);
        decisions.add(
                PlanDecision.exact(
                        "visibility",
                        fronts ? "pipeline, fronts only" : method,
                        shown.request().look().visibility(),
                        sight.reason()));
        return sight;
    }

    private Plan.PlanCost fullCost(RenderRequest full, ScreenAreas areas) {
        int reads = full.look().texture() == TextureMode.NONE ? 0 : 8;
        var all = new boolean[areas.faces()];
        Arrays.fill(all, true);
        var light = new LightWork(false, all, reads, false);
        PictureWork work = light.estimate(areas, false, false, 0);
        Family family = Family.of(full.visibility());
        return new Plan.PlanCost(
                work, costs.milliseconds(family, work, family == Family.PIPELINE ? cores : 1));
    }

    private synchronized KnownScene known(Scene scene) {
        for (KnownScene each : known)
            if (each.of(scene)) {
                known.remove(each);
                known.addFirst(each);
                return each;
            }
        SightFacts facts =
                known.stream()
                        .map(KnownScene::facts)
                        .filter(other -> other.of(scene))
                        .findFirst()
                        .orElseGet(() -> new SightFacts(scene));
        var found = new KnownScene(scene, facts);
        known.addFirst(found);
        if (known.size() > KEPT) known.removeLast();
        return found;
    }
}
