package rasterlab.engine.pipeline;

import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.SteppedVisibility;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityWalk;
import rasterlab.engine.visibility.buffer.DepthBuffer;
import rasterlab.engine.visibility.buffer.PixelHistory;
import rasterlab.engine.visibility.buffer.PixelTouch;

/**
 * A request's faces, their colours and the method that draws them, for those who watch it at work.
 *
 * @param view the faces as the eye sees them
 * @param paint their colours
 * @param method draws them
 * @param backgroundArgb the colour 0xAARRGGBB before anything is drawn
 */
public record FaceDrawing(ViewedMesh view, FacePaint paint, Visibility method, int backgroundArgb) {
    /** The buffer that is looked at where the method keeps none. */
    public static final String USUAL_BUFFER = "zfloat";

    /**
     * How the request draws faces; empty for wires, for the surfaces themselves and for two eyes.
     */
    public static Optional<FaceDrawing> of(RenderRequest request) {
        Look look = request.look();
        ShadingMethod shading = ShadingMethod.named(Renderer.shading(request).chosen());
        boolean faces =
                look.stereo().isEmpty()
                        && shading != ShadingMethod.WIRE
                        && !look.visibility().equals(Renderer.SURFACES);
        if (!faces) return Optional.empty();
        RequestView seen = RequestView.of(request, request.width());
        return Optional.of(
                new FaceDrawing(
                        seen.viewed(),
                        Renderer.paint(look, shading, seen),
                        Renderer.drawing(
                                look,
                                Renderer.visibilityMethods(),
                                Renderer.visibility(request).chosen()),
                        0xFF000000 | request.scene().backgroundRgb()));
    }

    private static Visibility method(String name) {
        return Renderer.drawing(Renderer.visibilityMethods(), name);
    }

    /** A picture of the right size with nothing drawn yet. */
    public Raster blank() {
        var out = new Raster(view.fit().width(), view.fit().height());
        out.clear(backgroundArgb);
        return out;
    }

    /** Whether the method can be watched step by step. */
    public boolean hasSteps() {
        return method instanceof SteppedVisibility;
    }

    /**
     * A walk of a method that has steps.
     *
     * @throws IllegalArgumentException if it has none or refuses the scene
     */
    public VisibilityWalk walk(Raster out) {
        if (method instanceof SteppedVisibility stepped) return stepped.walk(view, paint, out);
        throw new IllegalArgumentException("the method has no steps to watch");
    }

    /** Everything that touches a pixel. */
    public List<PixelTouch> history(int x, int y, BooleanSupplier cancelled) {
        return PixelHistory.of(view, method, paint, backgroundArgb, x, y, cancelled);
    }

    /** Whether the method keeps a depth for each pixel. */
    public boolean keepsDepths() {
        return DepthBuffer.keptBy(method);
    }

    /**
     * The method's own depths after so many steps; where it keeps none, all those of {@value
     * #USUAL_BUFFER}, whose steps are others.
     */
    public DepthBuffer depths(int steps, BooleanSupplier cancelled) {
        if (keepsDepths()) return DepthBuffer.of(view, method, paint, steps, cancelled);
        return DepthBuffer.of(view, method(USUAL_BUFFER), paint, Integer.MAX_VALUE, cancelled);
    }
}
