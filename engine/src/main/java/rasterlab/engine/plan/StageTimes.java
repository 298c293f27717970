package rasterlab.engine.plan;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleSupplier;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.direct.Savings;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.raster.Raster;

/**
 * The processor time that the stages of a picture take, found by leaving them out.
 *
 * <p>No clock runs in the loops that draw. The picture is drawn again and again on one thread, and
 * each time without one stage more: without light at pixels, without light at corners, without
 * texture, so small that no pixels count, and not at all but for its vertices. A stage takes what
 * is saved when it goes. Of several rounds the least times count, and no picture may take longer
 * than one that has a stage more, so that stages are never below 0 and their sum is the whole
 * picture's time.
 *
 * @param milliseconds by stage, named as those of the counted work; {@code faces} has all that is
 *     done for each face: cutting, ordering, set-up, one light formula
 * @param rounds in which every picture was drawn
 */
public record StageTimes(Map<String, Double> milliseconds, int rounds) {
    /** A picture of so many pixels across shows hardly any. */
    private static final int TINY = 4;

    private static final int LEAST_ROUNDS = 2;
    private static final int MOST_ROUNDS = 50;

    public StageTimes {
        milliseconds = Collections.unmodifiableMap(new LinkedHashMap<>(milliseconds));
        for (double time : milliseconds.values()) Bounds.requireAtLeast("milliseconds", time, 0);
        Bounds.requireAtLeast("rounds", rounds, 1);
    }

    /**
     * Measures a picture of faces.
     *
     * @param budget milliseconds after which no round begins, once there were two
     * @param cancelled asked often
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public static StageTimes of(RenderRequest request, double budget, BooleanSupplier cancelled) {
        RenderRequest known = request.withVisibility(Renderer.visibility(request).chosen());
        var timed = new LinkedHashMap<String, DoubleSupplier>();
        withLessLight(known)
                .forEach((stage, left) -> timed.put(stage, () -> drawn(left, cancelled)));
        var out = new Raster(request.width(), request.height());
        timed.put("vertices", () -> processor(() -> RequestView.of(known, known.width())));
        var least = new LinkedHashMap<String, Double>();
        double clear = Double.POSITIVE_INFINITY;
        long start = System.nanoTime();
        int rounds = 0;
        while (rounds < LEAST_ROUNDS
                || rounds < MOST_ROUNDS && (System.nanoTime() - start) / 1e6 < budget) {
            timed.forEach((stage, one) -> least.merge(stage, one.getAsDouble(), Math::min));
            clear = Math.min(clear, processor(() -> out.clear(0)));
            rounds++;
        }
        return new StageTimes(stages(least, clear), rounds);
    }

    /** Milliseconds of all stages. */
    public double total() {
        return milliseconds.values().stream().mapToDouble(Double::doubleValue).sum();
    }

    /** The share of the whole that a stage takes, 0 to 1. */
    public double share(String stage) {
        double all = total();
        return all > 0 ? milliseconds.getOrDefault(stage, 0.0) / all : 0;
    }

    /**
     * The picture, and what is left of it stage by stage, under the name of the stage that goes
     * next.
     */
    private static Map<String, RenderRequest> withLessLight(RenderRequest request) {
        var left = new LinkedHashMap<String, RenderRequest>();
        RenderRequest now = request;
        ShadingMethod shading = ShadingMethod.named(Renderer.shading(request).chosen());
        if (shading == ShadingMethod.PHONG) {
            left.put("pixel-lights", now);
            boolean mixed = request.look().savings().levels() > 0;
            shading = mixed ? ShadingMethod.GOURAUD : ShadingMethod.FLAT;
            Look look = now.look();
            now =
                    now.with(
                            look.withShading(shading)
                                    .withSavings(new Savings(0, look.savings().frontsOnly())));
        }
        if (shading == ShadingMethod.GOURAUD) {
            left.put("lights", now);
            now = now.withShading(ShadingMethod.FLAT);
        }
        if (textured(now)) {
            left.put("texels", now);
            now = now.with(now.look().withTexture(TextureMode.NONE));
        }
        left.put("fragments", now);
        left.put("faces", tiny(now));
        return left;
    }

    private static boolean textured(RenderRequest request) {
        return request.look().texture() != TextureMode.NONE
                && request.scene().finishes().stream().anyMatch(f -> f.texture().isPresent());
    }

    private static RenderRequest tiny(RenderRequest request) {
        int height = Math.max(1, Math.round((float) TINY * request.height() / request.width()));
        return new RenderRequest(
                request.scene(),
                request.camera(),
                request.projection(),
                request.depth(),
                TINY,
                Math.min(height, TINY * TINY),
                request.look());
    }

    /** A renderer packs a scene at its first picture, which is no part of the next one. */
    private static double drawn(RenderRequest request, BooleanSupplier cancelled) {
        var out = new Raster(request.width(), request.height());
        try (var alone = Renderer.onOneThread()) {
            alone.render(request, out, cancelled);
            return PlanTrial.processor(alone, request, out, cancelled);
        }
    }

    private static double processor(Runnable work) {
        long before = PlanTrial.processorNanos();
        work.run();
        return (PlanTrial.processorNanos() - before) / 1e6;
    }

    /** Each stage's share of what was measured, in the order in which a picture is made. */
    private static Map<String, Double> stages(Map<String, Double> least, double clear) {
        var took = new LinkedHashMap<String, Double>();
        String stage = "";
        double before = Double.POSITIVE_INFINITY;
        for (Map.Entry<String, Double> next : least.entrySet()) {
            double here = Math.min(before, next.getValue());
            if (!stage.isEmpty()) took.put(stage, before - here);
            stage = next.getKey();
            before = here;
        }
        took.put(stage, before);
        double pixels = Math.min(clear, took.get("fragments"));
        took.merge("fragments", -pixels, Double::sum);
        var stages = new LinkedHashMap<String, Double>();
        for (String name : new String[] {"vertices", "faces", "lights", "fragments"})
            stages.put(name, took.getOrDefault(name, 0.0));
        stages.put("pixel-lights", took.getOrDefault("pixel-lights", 0.0));
        stages.put("texels", took.getOrDefault("texels", 0.0));
        stages.put("pixels", pixels);
        return stages;
    }
}
