package rasterlab.engine.pipeline;

import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.light.Shadings;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Method;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibilities;
import rasterlab.engine.visibility.Visibility;

/**
 * Draws requests. The same request gives the same pixels; a renderer may serve several threads and
 * keeps working memory between frames.
 */
public final class Renderer {
    /** The visibility method that the others are held against: one ray for each pixel. */
    public static final String REFERENCE = "raycast";

    /** To look names up; pictures are drawn by a renderer's own. */
    private static final Visibilities KNOWN = new Visibilities();

    private static final Shadings SHADINGS = new Shadings();

    private final Visibilities visibilities = new Visibilities();

    /** Names of the visibility methods, in teaching order. */
    public static List<String> visibilities() {
        return KNOWN.names();
    }

    /** Names of the shadings, in teaching order. */
    public static List<String> shadings() {
        return SHADINGS.names();
    }

    /** Names of the projections, in teaching order. */
    public static List<String> projections() {
        return Projection.names();
    }

    /** The visibility methods with what a teacher says about each. */
    public static List<Method<Visibility>> visibilityMethods() {
        return KNOWN.methods();
    }

    static void checkNames(String visibility, String shading, boolean outline) {
        Method<Visibility> method = KNOWN.named(visibility);
        SHADINGS.named(shading);
        if (outline && !method.implementation().drawsOutlines())
            throw new IllegalArgumentException(
                    "visibility '%s' draws no outlines; those that do are %s"
                            .formatted(visibility, String.join(", ", outlining())));
    }

    private static List<String> outlining() {
        return KNOWN.methods().stream()
                .filter(method -> method.implementation().drawsOutlines())
                .map(Method::name)
                .toList();
    }

    /**
     * @param cancelled asked at least once per face or row, possibly by several threads
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public Raster render(RenderRequest request, BooleanSupplier cancelled) {
        var out = new Raster(request.width(), request.height());
        render(request, out, cancelled);
        return out;
    }

    /** The same into a picture of the request's size, whatever it holds before. */
    public void render(RenderRequest request, Raster out, BooleanSupplier cancelled) {
        if (out.width() != request.width() || out.height() != request.height())
            throw new IllegalArgumentException(
                    "picture must have the requested size %d×%d, got %d×%d"
                            .formatted(
                                    request.width(), request.height(), out.width(), out.height()));
        if (cancelled.getAsBoolean()) throw new CancellationException("the picture is cancelled");
        var scene = request.scene();
        var view =
                new ViewedMesh(
                        scene.mesh(),
                        new ViewTransform(request.camera(), Projection.named(request.projection())),
                        PictureFit.of(request.width(), request.height(), scene.pictureScale()));
        var paint =
                FaceLighting.paint(
                        view,
                        scene.faceRgb(),
                        SHADINGS.named(request.shading()),
                        request.outline());
        out.clear(0xFF000000 | scene.backgroundRgb());
        visibilities.named(request.visibility()).implementation().draw(view, paint, out, cancelled);
    }
}
