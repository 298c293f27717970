package rasterlab.app.light;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.pipeline.DrawnDepths;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.pipeline.ShadingMethod;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.transform.Projection;

/** A body of the chosen material in the chosen light, to be drawn. */
final class LitScene {
    private LitScene() {}

    /** The body in the light, in its own size. */
    static Scene scene(LightChoice choice, Scene body) {
        return new Scene(
                body.name(),
                body.mesh(),
                List.of(Appearance.of(choice.material().material())),
                new int[body.mesh().faceCount()],
                new SceneLight(choice.model(), Optional.empty()),
                body.backgroundRgb(),
                body.defaultCamera(),
                body.pictureScale());
    }

    /**
     * The picture by one of the shadings.
     *
     * @param body the choice's scene
     */
    static RenderRequest request(
            LightChoice choice, Scene body, ShadingMethod shading, int width, int height) {
        Look look =
                Look.of(Renderer.PIPELINE, shading)
                        .withTexture(TextureMode.NONE)
                        .withLight(choice.terms(), Sides.SCENE);
        return new RenderRequest(
                scene(choice, body).zoomed(choice.zoom()),
                choice.camera(),
                Projection.PERSPECTIVE,
                DrawnDepths.all(Projection.PERSPECTIVE, choice.camera().rho()),
                width,
                height,
                look);
    }
}
