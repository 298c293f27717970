package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.direct.Savings;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.sight.SightFacts;

/**
 * All combinations of what a plan chooses among, each drawn, held against the full picture and
 * timed: what a planner would know that measures everything first.
 *
 * <p>Visibility: all methods that are right for some scenes; shading: flat, Gouraud's, Phong's
 * where it counts, Phong's; textures: nearest, linear, mipmap; faces: the scene's and the plan's.
 */
public final class BruteForce {
    private static final List<String> METHODS =
            List.of("pipeline", "convex", "painter", "z16", "zfloat", "bsp");

    /** A combination that took so many times the best so far is not timed again. */
    private static final double HOPELESS = 3;

    private BruteForce() {}

    /**
     * @param rounds of timing each, at least 1
     * @return those within the tolerance, the cheapest first
     */
    public static List<Combination> within(
            Plan plan, Raster full, Tolerance tolerance, int rounds, BooleanSupplier cancelled) {
        List<Combination> enough = new ArrayList<>();
        double best = Double.POSITIVE_INFINITY;
        try (var renderer = Renderer.onOneThread()) {
            var out = new Raster(full.width(), full.height());
            for (Map.Entry<String, RenderRequest> way : ways(plan, tolerance).entrySet()) {
                double least = Double.POSITIVE_INFINITY;
                try {
                    least = PlanTrial.processor(renderer, way.getValue(), out, cancelled);
                } catch (IllegalArgumentException refused) {
                    continue;
                }
                ToleratedDifference error = ToleratedDifference.of(full, out, tolerance);
                if (!error.within(tolerance)) continue;
                for (int k = 0; k < rounds && least < HOPELESS * best; k++)
                    least =
                            Math.min(
                                    least,
                                    PlanTrial.processor(renderer, way.getValue(), out, cancelled));
                best = Math.min(best, least);
                enough.add(new Combination(way.getKey(), way.getValue(), error, least));
            }
        }
        enough.sort(Comparator.comparingDouble(Combination::processor));
        return enough;
    }

    private static Map<String, RenderRequest> ways(Plan plan, Tolerance tolerance) {
        var ways = new LinkedHashMap<String, RenderRequest>();
        boolean coarser = plan.least().scene().mesh() != plan.full().scene().mesh();
        add(ways, plan.full(), "all faces", tolerance);
        if (coarser) add(ways, plan.full().with(plan.least().scene()), "fewer faces", tolerance);
        return ways;
    }

    private static void add(
            Map<String, RenderRequest> ways,
            RenderRequest base,
            String faces,
            Tolerance tolerance) {
        boolean textured = base.look().texture() != TextureMode.NONE;
        boolean few = base.scene().mesh().faceCount() <= 2 * SightFacts.FEW_FACES;
        List<TextureMode> modes =
                textured
                        ? List.of(TextureMode.NEAREST, TextureMode.LINEAR, TextureMode.MIPMAP)
                        : List.of(TextureMode.NONE);
        for (String method : METHODS) {
            if (!few && !method.equals("pipeline")) continue;
            for (TextureMode mode : modes)
                for (ShadingMethod shading :
                        List.of(ShadingMethod.FLAT, ShadingMethod.GOURAUD, ShadingMethod.PHONG))
                    put(
                            ways,
                            base,
                            faces,
                            base.look()
                                    .withVisibility(method)
                                    .withTexture(mode)
                                    .withShading(shading)
                                    .withSavings(Savings.NONE));
            if (!method.equals("pipeline")) continue;
            for (TextureMode mode : modes) addSaving(ways, base, faces, mode, tolerance);
        }
    }

    private static void addSaving(
            Map<String, RenderRequest> ways,
            RenderRequest base,
            String faces,
            TextureMode mode,
            Tolerance tolerance) {
        Look look =
                base.look()
                        .withVisibility("pipeline")
                        .withTexture(mode)
                        .withShading(ShadingMethod.PHONG);
        var view = RequestView.of(base, base.width()).viewed();
        boolean fronts =
                view.clipPlaneCount() == 0
                        && !view.cutsOpen()
                        && new SightFacts(base.scene()).closed();
        put(ways, base, faces, look.withSavings(new Savings(tolerance.levels(), fronts)));
        if (!fronts) return;
        for (ShadingMethod shading :
                List.of(ShadingMethod.FLAT, ShadingMethod.GOURAUD, ShadingMethod.PHONG))
            put(ways, base, faces, look.withShading(shading).withSavings(new Savings(0, true)));
    }

    private static void put(
            Map<String, RenderRequest> ways, RenderRequest base, String faces, Look look) {
        String name =
                "%s, %s%s, %s%s, %s"
                        .formatted(
                                faces,
                                look.visibility(),
                                look.savings().frontsOnly() ? " (fronts only)" : "",
                                look.shading().code(),
                                look.savings().levels() > 0 ? " where it counts" : "",
                                look.texture().code());
        ways.put(name, base.with(look));
    }
}
