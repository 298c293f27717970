package rasterlab.engine.plan;

import java.util.Arrays;
import java.util.Locale;
import rasterlab.engine.pipeline.Choice;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.MixedLight;
import rasterlab.engine.sight.SightFacts;
import rasterlab.engine.visibility.OutlineFaces;

/**
 * Chooses the cheapest shading that is proved to be within some levels of Phong's: one colour a
 * face, light mixed from corners, or the formula at each pixel. The proof is a plan's, from how
 * normal, light and eye turn over a face.
 */
public final class ShadingChoice {
    private ShadingChoice() {}

    /**
     * @param request the picture; what it says of shading does not count
     * @param levels by which a channel may differ, 0 to 255
     * @throws IllegalArgumentException for other levels, or two eyes
     */
    public static Choice of(RenderRequest request, double levels) {
        if (!(levels >= 0 && levels <= 255))
            throw new IllegalArgumentException("levels must be from 0 to 255, got " + levels);
        Look look = request.look();
        if (look.stereo().isPresent())
            throw new IllegalArgumentException("levels are for one eye, not for two");
        RequestView seen = RequestView.of(request, request.width());
        var lights = new FaceLights(seen.scene(), seen.viewed(), look.terms(), look.sides());
        var light = new MixedLight(lights, levels);
        boolean[] drawn = drawn(seen);
        MixedLight.Apart apart = light.apart(drawn);
        if (apart.flat() <= levels)
            return choice(
                    ShadingMethod.FLAT,
                    "one colour a face is at most %.2f of %s levels off",
                    apart.flat(),
                    levels);
        if (apart.mixed() <= levels)
            return choice(
                    ShadingMethod.GOURAUD,
                    "light mixed from corners is at most %.2f of %s levels off",
                    apart.mixed(),
                    levels);
        return choice(
                ShadingMethod.PHONG,
                "light mixed from corners may be more than %s levels off on %d of %d faces",
                levels,
                ShadingPlan.count(light.beyond(drawn)),
                ShadingPlan.count(drawn));
    }

    /** The faces that can be seen: backs of closed bodies are hidden by their fronts. */
    private static boolean[] drawn(RequestView seen) {
        if (new SightFacts(seen.scene()).closed() && !seen.viewed().cutsOpen())
            return OutlineFaces.andFronts(seen.viewed(), 0);
        var all = new boolean[seen.scene().mesh().faceCount()];
        Arrays.fill(all, true);
        return all;
    }

    private static Choice choice(ShadingMethod method, String reason, Object... values) {
        return new Choice(method.code(), String.format(Locale.ROOT, reason, values));
    }
}
