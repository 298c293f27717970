package rasterlab.app.canvas;

import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;

/** Makes a picture, or throws CancellationException once it is of no use any more. */
@FunctionalInterface
public interface PictureMaker extends AutoCloseable {
    Raster picture(RenderRequest request, BooleanSupplier cancelled);

    /** Gives back what drawing used, when nothing is drawn any more. */
    @Override
    default void close() {}

    /** Draws by a renderer, which is closed with it. */
    static PictureMaker by(Renderer renderer) {
        return new PictureMaker() {
            @Override
            public Raster picture(RenderRequest request, BooleanSupplier cancelled) {
                return renderer.render(request, cancelled);
            }

            @Override
            public void close() {
                renderer.close();
            }
        };
    }
}
