package rasterlab.engine.pipeline.paint;

import java.util.Optional;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * How many faces of a view have textures, and on how many of them some pixel may step over more
 * than a texel.
 */
public record Minification(int textured, int minified) {
    public static Minification of(Scene scene, ViewedMesh view) {
        var step = new TextureStep(view, new CornerWeights(view));
        int textured = 0;
        int minified = 0;
        for (int f = 0; f < view.mesh().faceCount(); f++) {
            Optional<LaidTexture> laid = scene.finish(f).texture();
            if (laid.isEmpty()) continue;
            textured++;
            if (step.minified(f, laid.get().texture())) minified++;
        }
        return new Minification(textured, minified);
    }
}
