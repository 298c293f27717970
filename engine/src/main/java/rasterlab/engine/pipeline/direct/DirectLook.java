package rasterlab.engine.pipeline.direct;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.pipeline.surface.TexelFilter;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.visibility.OutlineFaces;

/**
 * How a picture is lit and textured.
 *
 * @param light where the formula is worked out
 * @param texture how textures are looked up; {@code AUTO} is taken for mipmaps, which are the
 *     linear filter wherever nothing is made smaller
 * @param savings what may be left out
 */
public record DirectLook(LightingPlace light, TextureMode texture, Savings savings) {

    /** Where light is worked out. */
    public enum LightingPlace {
        /** Flat shading: light is computed once for each face. */
        FACES,
        /** Gouraud shading: light is computed at the corners. */
        CORNERS,
        /** Phong shading: light is computed at each pixel. */
        PIXELS
    }

    Optional<LaidTexture> laid(Appearance finish) {
        return texture == TextureMode.NONE ? Optional.empty() : finish.texture();
    }

    TexelFilter filter() {
        return switch (texture) {
            case NEAREST -> TexelFilter.NEAREST;
            case LINEAR -> TexelFilter.LINEAR;
            case MIPMAP, AUTO -> TexelFilter.MIPMAP;
            case AFFINE_NEAREST -> TexelFilter.AFFINE_NEAREST;
            case NONE -> throw new AssertionError("no texture is laid, so none is looked up");
        };
    }

    /** Whether each face is drawn at all. */
    boolean[] drawn(FaceLights lights) {
        if (savings.frontsOnly()) return OutlineFaces.andFronts(lights.view(), 0);
        var drawn = new boolean[lights.mesh().faceCount()];
        Arrays.fill(drawn, true);
        return drawn;
    }

    /** Whether each face hides all that is behind it. */
    boolean[] opaque(FaceLights lights) {
        List<Appearance> finishes = lights.scene().finishes();
        var front = new boolean[finishes.size()];
        var back = new boolean[finishes.size()];
        for (int i = 0; i < front.length; i++) {
            Appearance finish = finishes.get(i);
            boolean covers = laid(finish).map(LaidTexture::opaque).orElse(true);
            front[i] = covers && finish.front().alpha() == 1;
            back[i] = covers && finish.back().alpha() == 1;
        }
        var opaque = new boolean[lights.mesh().faceCount()];
        for (int f = 0; f < opaque.length; f++) {
            boolean ownBack = lights.twoSided() && lights.seenFromBehind(f);
            opaque[f] = (ownBack ? back : front)[lights.finishOf(f)];
        }
        return opaque;
    }
}
