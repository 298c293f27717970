package rasterlab.engine.pipeline;

import rasterlab.engine.pipeline.paint.Minification;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Appearance;

/**
 * The choice of {@code --texture auto}: mipmaps on the faces that may be made smaller, the linear
 * filter on the others, where it gives the same pixels.
 */
final class AutoTexture {
    private AutoTexture() {}

    static Choice of(RenderRequest request) {
        TextureMode asked = request.look().texture();
        if (request.look().shading() == ShadingMethod.WIRE)
            return choice(TextureMode.NONE, "edges have no texture");
        if (request.scene().finishes().stream().map(Appearance::texture).allMatch(t -> t.isEmpty()))
            return choice(TextureMode.NONE, "the scene has no texture");
        if (asked != TextureMode.AUTO) return choice(asked, "asked for");
        RequestView seen = RequestView.of(request, request.width());
        var faces = Minification.of(seen.scene(), seen.viewed());
        if (faces.minified() == 0)
            return choice(TextureMode.LINEAR, "no pixel steps over more than a texel");
        return choice(
                TextureMode.MIPMAP,
                "pixels may step over texels on %d of %d textured faces; linear on the others"
                        .formatted(faces.minified(), faces.textured()));
    }

    private static Choice choice(TextureMode filter, String reason) {
        return new Choice(filter.code(), reason);
    }
}
