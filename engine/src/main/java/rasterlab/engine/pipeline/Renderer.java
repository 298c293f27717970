package rasterlab.engine.pipeline;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.Paints;
import rasterlab.engine.pipeline.paint.Veil;
import rasterlab.engine.pipeline.wire.WirePicture;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Method;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.StereoPair;
import rasterlab.engine.visibility.FacePaint;
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

    /** The method that hides nothing, so that wires are seen whole. */
    private static final String HIDES_NOTHING = "none";

    /** To look names up; pictures are drawn by a renderer's own. */
    private static final Visibilities KNOWN = new Visibilities();

    private final Visibilities visibilities = new Visibilities();

    /** Names of the visibility methods, in teaching order. */
    public static List<String> visibilities() {
        return KNOWN.names();
    }

    /** Names of the shadings, in teaching order. */
    public static List<String> shadings() {
        return ShadingMethod.names();
    }

    /** Names of the projections, in teaching order. */
    public static List<String> projections() {
        return Projection.names();
    }

    /** The visibility methods with what a teacher says about each. */
    public static List<Method<Visibility>> visibilityMethods() {
        return KNOWN.methods();
    }

    static void checkNames(String visibility, boolean outline) {
        Method<Visibility> method = KNOWN.named(visibility);
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

    /** The shading that a request is drawn with, and why. */
    public static Choice shading(RenderRequest request) {
        return request.look().shading() == ShadingMethod.AUTO
                ? AutoShading.of(request.scene(), request.look().terms())
                : new Choice(request.look().shading().code(), "asked for");
    }

    /** The texture filter that a request is drawn with, and why. */
    public static Choice texture(RenderRequest request) {
        return AutoTexture.of(request);
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
        out.clear(0xFF000000 | request.scene().backgroundRgb());
        if (request.look().stereo().isEmpty())
            draw(request, RequestView.of(request, request.width()), out, cancelled);
        else drawEyes(request, request.look().stereo().get(), out, cancelled);
    }

    private void drawEyes(
            RenderRequest request, Stereo stereo, Raster out, BooleanSupplier cancelled) {
        int width = Eyes.width(stereo, out.width());
        double separation = stereo.separation(request.camera().rho());
        double half = new StereoPair(request.camera(), separation).separation() / 2;
        var left = new Raster(width, out.height());
        var right = new Raster(width, out.height());
        for (Raster eye : List.of(left, right)) {
            eye.clear(0xFF000000 | request.scene().backgroundRgb());
            double toTheRight = eye == left ? -half : half;
            draw(request, RequestView.of(request, width, toTheRight), eye, cancelled);
        }
        Eyes.join(stereo, left, right, out);
    }

    private void draw(
            RenderRequest request, RequestView seen, Raster out, BooleanSupplier cancelled) {
        Look look = request.look();
        ViewedMesh view = seen.viewed();
        int background = seen.scene().backgroundRgb();
        Optional<Veil> veil = look.cue().map(cue -> new Veil(cue, view, background));
        Visibility method = visibilities.named(look.visibility()).implementation();
        if (look.shading() == ShadingMethod.WIRE)
            new WirePicture(view, wire(look), background, veil, out).draw(method, cancelled);
        else method.draw(view, paint(request, seen, veil), out, cancelled);
    }

    private static WireStyle wire(Look look) {
        boolean whole = look.visibility().equals(HIDES_NOTHING);
        return whole ? look.wire().withoutHiding() : look.wire();
    }

    private static FacePaint paint(RenderRequest request, RequestView seen, Optional<Veil> veil) {
        Look look = request.look();
        var lights = new FaceLights(seen.scene(), seen.viewed(), look.terms(), look.sides());
        var paints = new Paints(lights, look.texture(), veil, look.outline());
        return switch (ShadingMethod.named(shading(request).chosen())) {
            case TONE -> paints.tone();
            case FLAT -> paints.flat();
            case GOURAUD -> paints.gouraud();
            case PHONG -> paints.phong();
            case WIRE, AUTO -> throw new AssertionError("no paint for " + look.shading());
        };
    }
}
