package rasterlab.exercises.scene;

import java.util.Optional;
import rasterlab.engine.transform.SphericalView;

/**
 * A scene as it is looked at; what is empty is left to whoever draws it.
 *
 * @param projection one of {@code Renderer.projections()}
 * @param visibility one of {@code Renderer.visibilities()}
 * @param shading one of {@code Renderer.shadings()}
 * @param texture one of {@code TextureMode.names()}
 */
public record SceneView(
        SceneSource source,
        Optional<SphericalView> camera,
        Optional<String> projection,
        Optional<String> visibility,
        Optional<String> shading,
        Optional<String> texture)
        implements SceneFile {
    @Override
    public String write() {
        return ViewJson.write(this);
    }
}
