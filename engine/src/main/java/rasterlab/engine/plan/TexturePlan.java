package rasterlab.engine.plan;

import java.util.List;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.paint.Minification;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.sight.Reason;

/**
 * The least filter that textures need: the nearest texel where texels hardly differ, the linear
 * filter where nothing is made smaller, mipmaps elsewhere.
 *
 * @param mode the filter
 * @param reads texels that it reads for a pixel
 * @param levels by which it may change what is seen
 * @param fromHere whether that holds for this camera only
 */
record TexturePlan(TextureMode mode, int reads, double levels, boolean fromHere) {

    /**
     * @param shown the faces, by a sample
     * @param left levels that may still be changed
     * @param decisions gets what was decided
     */
    static TexturePlan of(
            RenderRequest full, ShownFaces shown, double left, List<PlanDecision> decisions) {
        if (full.look().texture() == TextureMode.NONE)
            return new TexturePlan(TextureMode.NONE, 0, 0, false);
        int contrast = shown.known().contrast(left);
        if (contrast <= left) {
            Reason reason =
                    Reason.of("contrast", "no two texels differ by more than %d levels", contrast);
            decisions.add(new PlanDecision("texture", "nearest", "mipmap", reason, contrast, 0));
            return new TexturePlan(TextureMode.NEAREST, 1, contrast, false);
        }
        RequestView sampled = shown.seen();
        var faces = Minification.of(sampled.scene(), sampled.viewed());
        if (faces.minified() == 0 && !shown.areas().whole()) {
            RequestView all = shown.all();
            faces = Minification.of(all.scene(), all.viewed());
        }
        if (faces.minified() == 0) {
            decisions.add(
                    PlanDecision.exact(
                            "texture",
                            "linear",
                            "mipmap",
                            Reason.of(
                                    "magnified",
                                    "no pixel steps over more than a texel, so no mipmap is read")));
            return new TexturePlan(TextureMode.LINEAR, 4, 0, true);
        }
        decisions.add(
                PlanDecision.exact(
                        "texture",
                        "mipmap",
                        "mipmap",
                        Reason.of(
                                "minified",
                                "pixels may step over texels on %d of %d faces that were looked"
                                        + " at; texels differ by %d levels or more",
                                faces.minified(),
                                faces.textured(),
                                contrast)));
        return new TexturePlan(TextureMode.MIPMAP, 8, 0, false);
    }
}
