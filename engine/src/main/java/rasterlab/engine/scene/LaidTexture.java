package rasterlab.engine.scene;

import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.Wrap;

/**
 * A texture as it lies on faces.
 *
 * @param texture the picture
 * @param alongS what it is left and right of 0 to 1
 * @param alongT what it is below and above 0 to 1
 * @param environment how texel and light become one; of the texture's components
 */
public record LaidTexture(
        Texture texture, Wrap alongS, Wrap alongT, TextureEnvironment environment) {
    public LaidTexture {
        if (environment.components() != texture.components())
            throw new IllegalArgumentException(
                    "environment must be for the texture's %d components, got one for %d"
                            .formatted(texture.components(), environment.components()));
    }

    /** Whether what hides all that is behind it still does so with the texture on it. */
    public boolean opaque() {
        if (environment.keepsSurfaceAlpha()) return true;
        boolean border = alongS == Wrap.CLAMP || alongT == Wrap.CLAMP;
        return texture.opaque() && !border;
    }
}
