package rasterlab.engine.plan;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.direct.Savings;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.sight.LightWork;
import rasterlab.engine.sight.Reason;
import rasterlab.engine.sight.ScreenAreas;
import rasterlab.engine.sight.SightChoice;
import rasterlab.engine.sight.SightChoice.Sight;
import rasterlab.engine.sight.SightFacts;
import rasterlab.engine.sight.cost.Costs;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.sight.cost.PictureWork;
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
    /** Scenes of which the facts are kept: what is asked for and what is drawn, now and before. */
    private static final int KEPT = 4;

    private final Costs costs;
    private final int cores;
    private final Deque<SightFacts> known = new ArrayDeque<>();

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

    /** Where the costs come from. */
    public String costOrigin() {
        return costs.origin();
    }

    /** The full pipeline's picture of a view: what a plan is held against. */
    public RenderRequest full(RenderRequest asked) {
        RequestView seen = RequestView.of(asked, asked.width());
        SightFacts facts = facts(seen.scene());
        ViewedMesh view = seen.viewed();
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
    public Plan plan(RenderRequest asked, Tolerance tolerance) {
        long start = System.nanoTime();
        RenderRequest full = full(asked);
        List<PlanDecision> decisions = new ArrayList<>();
        LampPlan.Result lamps = LampPlan.of(full.scene(), tolerance.levels(), decisions);
        Scene scene = withoutDarkTerms(lamps.scene(), decisions);
        ViewedMesh whole = RequestView.of(full, full.width()).viewed();
        Optional<ShapePlan.Result> parts = new ShapePlan(scene, whole, tolerance).plan();
        if (parts.isPresent()) {
            scene = parts.get().scene();
            decisions.addAll(parts.get().decisions());
        }
        double left = tolerance.levels() - lamps.levels() - ofFaces(parts);
        RenderRequest request = full.with(scene);
        RequestView seen = RequestView.of(request, request.width());
        var areas = new ScreenAreas(seen.viewed());
        TexturePlan texturing = TexturePlan.of(full, seen, left, decisions);
        left -= texturing.levels();
        boolean fronts = SightChoice.frontsOnly(facts(scene), seen.viewed());
        var shown =
                new ShadingPlan.Shown(
                        request, seen, areas, fronts, facts(scene).glass(), texturing.reads());
        ShadingPlan shading = ShadingPlan.of(shown, left, this::predicted, decisions);
        Sight sight = sight(shown, shading, decisions);
        Look look =
                request.look()
                        .withVisibility(sight.method())
                        .withShading(shading.planned(sight))
                        .withTexture(texturing.mode())
                        .withSavings(new Savings(shading.levels(), sight.frontsOnly()));
        boolean here = sight.fromHere() || texturing.fromHere() || shading.fromHere();
        return new Plan(
                full,
                request.with(look),
                tolerance,
                decisions,
                here ? CameraRange.only(full.camera()) : CameraRange.around(full.camera()),
                fullCost(full, whole),
                new Plan.Cost(sight.work(), sight.milliseconds()),
                (System.nanoTime() - start) / 1e6);
    }

    /** The plan that leaves nothing out, for what no other plan is enough. */
    public Plan nothingLeftOut(RenderRequest asked, Tolerance tolerance) {
        long start = System.nanoTime();
        RenderRequest full = full(asked);
        Plan.Cost cost = fullCost(full, RequestView.of(full, full.width()).viewed());
        return new Plan(
                full,
                full,
                tolerance,
                List.of(),
                CameraRange.around(full.camera()),
                cost,
                cost,
                (System.nanoTime() - start) / 1e6);
    }

    /** The levels that coarser faces may change; parts are beside each other. */
    private static double ofFaces(Optional<ShapePlan.Result> parts) {
        return parts.stream()
                .flatMap(result -> result.decisions().stream())
                .mapToDouble(PlanDecision::levels)
                .max()
                .orElse(0);
    }

    /** Highlights are left out where neither a material nor a lamp has any. */
    private static Scene withoutDarkTerms(Scene scene, List<PlanDecision> decisions) {
        LightModel model = scene.light().model();
        boolean bright =
                Stream.concat(
                                model.lights().stream().map(Light::source),
                                scene.light().atEye().stream())
                        .anyMatch(source -> any(source.specular()));
        boolean mirror =
                scene.finishes().stream()
                        .flatMap(f -> Stream.of(f.front(), f.back()))
                        .anyMatch(material -> any(material.surface().specular()));
        if (model.reflection() == Reflection.LAMBERT || bright && mirror) return scene;
        decisions.add(
                PlanDecision.exact(
                        "terms",
                        "ambient, diffuse, emission",
                        "ambient, diffuse, specular, emission",
                        bright
                                ? Reason.of("dull", "no material mirrors light")
                                : Reason.of("lamps", "no lamp gives highlights")));
        return new Scene(
                scene.name(),
                scene.mesh(),
                scene.finishes(),
                scene.finishOf(),
                new SceneLight(model.with(Reflection.LAMBERT), scene.light().atEye()),
                scene.backgroundRgb(),
                scene.defaultCamera(),
                scene.pictureScale(),
                scene.surfaces());
    }

    private static boolean any(double[] shares) {
        return shares[0] > 0 || shares[1] > 0 || shares[2] > 0;
    }

    private double predicted(PictureWork work) {
        return costs.milliseconds(Family.PIPELINE, work, cores);
    }

    private Sight sight(
            ShadingPlan.Shown shown, ShadingPlan shading, List<PlanDecision> decisions) {
        ViewedMesh view = shown.seen().viewed();
        var choice = new SightChoice(facts(shown.seen().scene()), view, costs);
        Sight sight =
                choice.choose(shading.directWork(), shading.paintedWork(), shown.areas(), cores);
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

    private Plan.Cost fullCost(RenderRequest full, ViewedMesh view) {
        var areas = new ScreenAreas(view);
        int reads = full.look().texture() == TextureMode.NONE ? 0 : 8;
        var all = new boolean[areas.faces()];
        Arrays.fill(all, true);
        var light = new LightWork(false, all, reads, false);
        PictureWork work = light.estimate(areas, false, false, 0);
        Family family = Family.of(full.visibility());
        return new Plan.Cost(
                work, costs.milliseconds(family, work, family == Family.PIPELINE ? cores : 1));
    }

    private synchronized SightFacts facts(Scene scene) {
        for (SightFacts facts : known) if (facts.of(scene)) return facts;
        var facts = new SightFacts(scene);
        known.addFirst(facts);
        if (known.size() > KEPT) known.removeLast();
        return facts;
    }
}
