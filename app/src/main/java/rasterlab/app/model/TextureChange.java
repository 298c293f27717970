package rasterlab.app.model;

import java.util.Optional;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;

/**
 * How a scene's textures are to lie otherwise than the scene has them.
 *
 * @param wrap beyond their rims, along both directions
 * @param environment with the light
 */
public record TextureChange(Optional<Wrap> wrap, Optional<Mode> environment) {
    public boolean isNone() {
        return wrap.isEmpty() && environment.isEmpty();
    }

    /**
     * The scene with its textures so; a face without one stays as it is.
     *
     * @throws IllegalArgumentException if a texture has too few components for the environment
     */
    public Scene of(Scene scene) {
        if (isNone()) return scene;
        return scene.with(
                finish -> finish.texture().map(laid -> finish.with(of(laid))).orElse(finish));
    }

    private LaidTexture of(LaidTexture laid) {
        TextureEnvironment mixed =
                environment
                        .map(
                                mode ->
                                        new TextureEnvironment(
                                                mode,
                                                laid.texture().components(),
                                                laid.environment().argb()))
                        .orElse(laid.environment());
        return new LaidTexture(
                laid.texture(), wrap.orElse(laid.alongS()), wrap.orElse(laid.alongT()), mixed);
    }

    /**
     * A picture on all faces, repeated and mixed with their light.
     *
     * @throws IllegalArgumentException if the scene has no place for one
     */
    public static Scene covered(Scene scene, Texture texture) {
        if (!scene.mesh().hasTexture())
            throw new IllegalArgumentException(
                    "scene '%s' has no texture coordinates to lay a picture by"
                            .formatted(scene.name()));
        var laid =
                new LaidTexture(
                        texture,
                        Wrap.REPEAT,
                        Wrap.REPEAT,
                        TextureEnvironment.of(Mode.MODULATE, texture));
        return scene.with(finish -> finish.with(laid));
    }
}
