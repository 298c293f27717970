package rasterlab.engine.pipeline;

import java.lang.ref.SoftReference;
import java.util.stream.IntStream;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.sight.LightWork;
import rasterlab.engine.sight.Reason;
import rasterlab.engine.sight.ScreenAreas;
import rasterlab.engine.sight.SightChoice;
import rasterlab.engine.sight.SightChoice.ChosenVisibility;
import rasterlab.engine.sight.SightFacts;
import rasterlab.engine.sight.cost.Costs;

/**
 * The cheapest visibility method whose picture is exact, found by {@link SightChoice}; what it
 * knows of a scene is kept for the next picture of it. Which one is chosen changes how long a
 * picture takes and no pixel of it.
 *
 * <p>Outlines are drawn by painters only; transparent faces that a paint colours by itself need a
 * buffer that mixes them.
 */
final class AutoVisibility {
    private final Costs costs = Costs.measured();

    /** Given up where memory is short, and the scene with it. */
    private SoftReference<SightFacts> known = new SoftReference<>(null);

    /** The choice for a request that may name a method itself. */
    Choice of(RenderRequest request) {
        Look look = request.look();
        if (!look.visibility().equals(Renderer.AUTO))
            return new Choice(look.visibility(), "asked for");
        ChosenVisibility sight = sight(request, RequestView.of(request, request.width()));
        return new Choice(sight.method(), sight.reason().english());
    }

    /** The method that {@code auto} stands for in a view. */
    ChosenVisibility sight(RenderRequest request, RequestView seen) {
        Look look = request.look();
        var areas = new ScreenAreas(seen.viewed());
        ShadingMethod shading = ShadingMethod.named(Renderer.shading(request).chosen());
        LightWork light = light(request, shading, areas.faces());
        if (look.outline())
            return plain(
                    "painter", Reason.of("outlines", "outlines are drawn by painters only"), areas);
        SightFacts facts = facts(seen);
        boolean direct = look.cue().isEmpty() && shading != ShadingMethod.TONE;
        if (facts.glass() && !direct)
            return plain(
                    "zfloat",
                    Reason.of("paint", "transparent faces, coloured by a paint of their own"),
                    areas);
        return new SightChoice(facts, seen::viewed, costs).exact(light, areas);
    }

    private static ChosenVisibility plain(String method, Reason reason, ScreenAreas areas) {
        var light = new LightWork(false, new boolean[areas.faces()], 0, false);
        return new ChosenVisibility(
                method, false, reason, 0, light.estimate(areas, false, true, 0), false);
    }

    /** How much light and texture a request asks for. */
    static LightWork light(RenderRequest request, ShadingMethod shading, int faces) {
        var atPixels = new boolean[faces];
        if (shading == ShadingMethod.PHONG)
            IntStream.range(0, faces).forEach(f -> atPixels[f] = true);
        boolean textured =
                request.look().texture() != TextureMode.NONE
                        && request.scene().finishes().stream()
                                .anyMatch(f -> f.texture().isPresent());
        int reads =
                !textured
                        ? 0
                        : switch (request.look().texture()) {
                            case NEAREST, AFFINE_NEAREST -> 1;
                            case LINEAR -> 4;
                            default -> 8;
                        };
        return new LightWork(shading == ShadingMethod.GOURAUD, atPixels, reads, false);
    }

    private synchronized SightFacts facts(RequestView seen) {
        SightFacts kept = known.get();
        if (kept != null && kept.of(seen.scene())) return kept;
        var facts = new SightFacts(seen.scene());
        known = new SoftReference<>(facts);
        return facts;
    }
}
