package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.sight.cost.Family;
import rasterlab.engine.visibility.painter.ConvexBody;

/**
 * Measures what the parts of a picture's work cost on this machine.
 *
 * <p>Scenes are drawn in several sizes, shadings and methods; what each takes, the least processor
 * time of several rounds, is explained as a sum of counted work times unknown costs. The costs,
 * none below 0, are those with the least sum of squared relative errors.
 *
 * <p>Source of the fit by one unknown after the other: V. Franc, V. Hlaváč, M. Navara, Sequential
 * coordinate-wise algorithm for the non-negative least squares problem, CAIP 2005.
 */
public final class CostStudy {
    private static final int ROUNDS = 9;
    private static final int PASSES = 5000;

    /** A scene of more faces is drawn by the pipeline only. */
    private static final int MOST_FACES = 600;

    private static final List<String> SCENES =
            List.of(
                    "vase",
                    "cube",
                    "sphere",
                    "torus",
                    "globe",
                    "textured-quad",
                    "interpenetrating");

    private static final int[][] SIZES = {{64, 48}, {200, 150}, {480, 360}};

    private CostStudy() {}

    /** A picture's work and what it took, in nanoseconds. */
    private record Sample(Family family, Map<String, Double> work, double nanos) {}

    /**
     * The lines of a table of costs, without those that name machine, day and method.
     *
     * @param progress told each picture
     */
    public static List<String> lines(Consumer<String> progress) {
        List<Sample> samples = new ArrayList<>();
        try (var renderer = Renderer.onOneThread()) {
            for (String name : SCENES)
                for (int[] size : SIZES)
                    measure(renderer, Scenes.named(name), size, samples, progress);
            measure(renderer, Scenes.named("torus", 160), SIZES[2], samples, progress);
        }
        List<String> lines = new ArrayList<>();
        for (Family family : Family.values())
            fit(samples.stream().filter(s -> s.family == family).toList())
                    .forEach(
                            (stage, nanos) ->
                                    lines.add("%s.%s=%.4g".formatted(family.code(), stage, nanos)));
        return lines;
    }

    private static void measure(
            Renderer renderer,
            Scene scene,
            int[] size,
            List<Sample> samples,
            Consumer<String> progress) {
        boolean few = scene.mesh().faceCount() <= MOST_FACES;
        boolean convex = few && ConvexBody.flaw(scene.mesh()).isEmpty();
        for (String method : List.of("pipeline", "painter", "z16", "convex")) {
            if (!few && !method.equals("pipeline") || !convex && method.equals("convex")) continue;
            for (ShadingMethod shading :
                    List.of(ShadingMethod.FLAT, ShadingMethod.GOURAUD, ShadingMethod.PHONG)) {
                var request =
                        new RenderRequest(
                                scene,
                                method,
                                shading.code(),
                                "perspective",
                                scene.defaultCamera(),
                                size[0],
                                size[1]);
                double nanos = nanos(renderer, request);
                samples.add(new Sample(Family.of(method), work(request), nanos));
                progress.accept(
                        "%s %dx%d %s %s: %.3f ms"
                                .formatted(
                                        scene.name(),
                                        size[0],
                                        size[1],
                                        method,
                                        shading.code(),
                                        nanos / 1e6));
            }
        }
    }

    private static Map<String, Double> work(RenderRequest request) {
        var parts = new LinkedHashMap<String, Double>();
        parts.put("frame", 1.0);
        WorkEstimate.of(request).stages().forEach((stage, n) -> parts.put(stage, n.doubleValue()));
        return parts;
    }

    private static double nanos(Renderer renderer, RenderRequest request) {
        renderer.render(request, () -> false);
        double least = Double.POSITIVE_INFINITY;
        for (int k = 0; k < ROUNDS; k++) {
            int repeats = least < 2e6 ? 10 : 1;
            long before = PlanTrial.processorNanos();
            for (int i = 0; i < repeats; i++) renderer.render(request, () -> false);
            least = Math.min(least, (double) (PlanTrial.processorNanos() - before) / repeats);
        }
        return least;
    }

    private static Map<String, Double> fit(List<Sample> samples) {
        var costs = new LinkedHashMap<String, Double>();
        for (String stage : samples.get(0).work.keySet()) costs.put(stage, 0.0);
        for (int pass = 0; pass < PASSES; pass++)
            for (String stage : costs.keySet()) {
                double own = 0;
                double rest = 0;
                for (Sample sample : samples) {
                    double part = sample.work.get(stage) / sample.nanos;
                    own += part * part;
                    rest += part * (1 - without(sample, costs, stage));
                }
                costs.put(stage, own > 0 ? Math.max(0, rest / own) : 0);
            }
        return costs;
    }

    /** The share of a sample's time that the other stages explain. */
    private static double without(Sample sample, Map<String, Double> costs, String stage) {
        double sum = 0;
        for (Map.Entry<String, Double> cost : costs.entrySet())
            if (!cost.getKey().equals(stage))
                sum += cost.getValue() * sample.work.get(cost.getKey());
        return sum / sample.nanos;
    }
}
