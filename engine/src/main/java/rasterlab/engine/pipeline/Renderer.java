package rasterlab.engine.pipeline;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import java.util.stream.Stream;
import rasterlab.engine.naming.Named;
import rasterlab.engine.pipeline.direct.DirectLook;
import rasterlab.engine.pipeline.direct.DirectPicture;
import rasterlab.engine.pipeline.direct.NumberedFaces;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.paint.DepthFade;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.Paints;
import rasterlab.engine.pipeline.paint.SurfacePicture;
import rasterlab.engine.pipeline.plain.PlainPipeline;
import rasterlab.engine.pipeline.wire.WirePicture;
import rasterlab.engine.pipeline.wire.WireStyle;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.study.Method;
import rasterlab.engine.transform.Projection;
import rasterlab.engine.transform.StereoPair;
import rasterlab.engine.visibility.Cancellation;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityWork;
import rasterlab.engine.visibility.exact.ExactVisibility;
import rasterlab.engine.visibility.hidden.Visibilities;

/**
 * Draws requests. The same request gives the same pixels; a renderer may serve several threads and
 * keeps working memory between frames.
 */
public final class Renderer implements AutoCloseable {
    /** Draws the exact picture, which all visibility methods are held against; not one of them. */
    public static final String REFERENCE = "exact";

    /** Draws a scene's surfaces instead of its faces; no method of the faces' visibility. */
    public static final String SURFACES = "raycast-surface";

    /** The method that hides nothing, so that wires are seen whole. */
    private static final String HIDES_NOTHING = "none";

    /** The triangle pipeline on one page, for a lecture. */
    public static final String PLAIN = "plain";

    /** The triangle pipeline, on all cores. */
    public static final String PIPELINE = "pipeline";

    /** The cheapest method whose picture of a scene is exact. */
    public static final String AUTO = "auto";

    /** The methods by which names are looked up; pictures are drawn by a renderer's own. */
    private static final List<Method<Visibility>> KNOWN = methods();

    private final List<Method<Visibility>> visibilities = methods();
    private final Supplier<TrianglePipeline> pipelines;
    private final AutoVisibility auto = new AutoVisibility();
    private Optional<DirectPicture> direct = Optional.empty();

    public Renderer() {
        this(TrianglePipeline::new);
    }

    /** A renderer that works on the caller's thread alone, so that its processor time is all. */
    public static Renderer onOneThread() {
        return new Renderer(() -> new TrianglePipeline(1));
    }

    /**
     * @param pipelines makes what draws by the method {@link #PIPELINE}
     */
    Renderer(Supplier<TrianglePipeline> pipelines) {
        this.pipelines = pipelines;
    }

    private static List<Method<Visibility>> methods() {
        List<Method<Visibility>> methods = new ArrayList<>(new Visibilities().methods());
        methods.add(Method.failing(PLAIN, PlainPipeline::draw));
        methods.add(Method.failing(PIPELINE, new NumberedFaces()));
        return List.copyOf(methods);
    }

    /** Names of the visibility methods, in teaching order. */
    public static List<String> visibilities() {
        return Stream.concat(KNOWN.stream().map(Method::name), Stream.of(AUTO)).toList();
    }

    /** Names of the shadings, in teaching order. */
    public static List<String> shadings() {
        return ShadingMethod.names();
    }

    /** Names of the projections, in teaching order. */
    public static List<String> projections() {
        return Projection.names();
    }

    /** The visibility methods, in teaching order. */
    public static List<Method<Visibility>> visibilityMethods() {
        return KNOWN;
    }

    static void checkNames(String visibility, boolean outline) {
        if (visibility.equals(SURFACES) || visibility.equals(REFERENCE)) {
            if (outline) throw new IllegalArgumentException(visibility + " draws no outlines");
            return;
        }
        List<String> known = Stream.concat(visibilities().stream(), Stream.of(SURFACES)).toList();
        Named.find("visibility method", visibility, known, name -> name);
        if (visibility.equals(AUTO)) return;
        Method<Visibility> method = named(KNOWN, visibility);
        if (outline && !method.implementation().drawsOutlines())
            throw new IllegalArgumentException(
                    "visibility '%s' draws no outlines; those that do are %s"
                            .formatted(visibility, String.join(", ", outlining())));
    }

    /** Checks what a method is called that is given itself. */
    static void checkGiven(String name, Visibility method, boolean outline) {
        if (visibilities().contains(name) || name.equals(SURFACES) || name.equals(REFERENCE))
            throw new IllegalArgumentException(
                    "a given visibility method needs a name of its own, got '%s'".formatted(name));
        if (outline && !method.drawsOutlines())
            throw new IllegalArgumentException("visibility '%s' draws no outlines".formatted(name));
    }

    /** Whether a method of that name can draw the faces' edges. */
    public static boolean drawsOutlines(String visibility) {
        return visibility.equals(AUTO) || outlining().contains(visibility);
    }

    private static List<String> outlining() {
        return KNOWN.stream()
                .filter(method -> method.implementation().drawsOutlines())
                .map(Method::name)
                .toList();
    }

    /** Finds what draws: the method that a look gives, the one of that name, or the reference. */
    static Visibility drawing(Look look, List<Method<Visibility>> methods, String name) {
        return look.given().orElseGet(() -> drawing(methods, name));
    }

    static Visibility drawing(List<Method<Visibility>> methods, String name) {
        return name.equals(REFERENCE)
                ? new ExactVisibility()
                : named(methods, name).implementation();
    }

    private static Method<Visibility> named(List<Method<Visibility>> methods, String name) {
        return Named.find("visibility method", name, methods, Method::name);
    }

    /** The visibility method that a request is drawn with, and why. */
    public static Choice visibility(RenderRequest request) {
        return new AutoVisibility().of(request);
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

    /**
     * Renders into a picture of the request's size, whatever it holds before.
     *
     * @return what the visibility method counted; nothing where another part of the pipeline drew
     */
    public Optional<VisibilityWork> render(
            RenderRequest request, Raster out, BooleanSupplier cancelled) {
        if (out.width() != request.width() || out.height() != request.height())
            throw new IllegalArgumentException(
                    "picture must have the requested size %d×%d, got %d×%d"
                            .formatted(
                                    request.width(), request.height(), out.width(), out.height()));
        Cancellation.check(cancelled);
        if (request.look().stereo().isEmpty())
            return draw(request, RequestView.of(request, request.width()), out, cancelled);
        drawEyes(request, request.look().stereo().get(), out, cancelled);
        return Optional.empty();
    }

    private void drawEyes(
            RenderRequest request, Stereo stereo, Raster out, BooleanSupplier cancelled) {
        int width = Eyes.width(stereo, out.width());
        double separation = stereo.separation(request.camera().rho());
        double half = new StereoPair(request.camera(), separation).separation() / 2;
        out.clear(0xFF000000 | request.scene().backgroundRgb());
        var left = new Raster(width, out.height());
        var right = new Raster(width, out.height());
        for (Raster eye : List.of(left, right)) {
            double toTheRight = eye == left ? -half : half;
            draw(request, RequestView.of(request, width, toTheRight), eye, cancelled);
        }
        Eyes.join(stereo, left, right, out);
    }

    private Optional<VisibilityWork> draw(
            RenderRequest request, RequestView seen, Raster out, BooleanSupplier cancelled) {
        Look look = request.look();
        ViewedMesh view = seen.viewed();
        int background = seen.scene().backgroundRgb();
        int opaque = 0xFF000000 | background;
        if (look.visibility().equals(SURFACES)) {
            look.requireSurfaces();
            var lights = new FaceLights(seen.scene(), view, look.terms(), look.sides());
            out.clear(opaque);
            new SurfacePicture(lights, look.texture()).draw(out, cancelled);
            return Optional.empty();
        }
        boolean open = look.visibility().equals(AUTO);
        String chosen = open ? auto.sight(request, seen).method() : look.visibility();
        ShadingMethod shading = ShadingMethod.named(shading(request).chosen());
        Visibility method = drawing(look, visibilities, chosen);
        boolean wire = shading == ShadingMethod.WIRE;
        if (!wire && chosen.equals(PIPELINE) && drawsDirectly(look, shading)) {
            direct().draw(lights(look, seen), directLook(look, shading), opaque, out, cancelled);
            return Optional.empty();
        }
        out.clear(opaque);
        if (!wire)
            return Optional.of(method.draw(view, paint(look, shading, seen), out, cancelled));
        new WirePicture(view, wire(look), background, fade(look, seen), out)
                .draw(method, cancelled);
        return Optional.empty();
    }

    private static FaceLights lights(Look look, RequestView seen) {
        return new FaceLights(seen.scene(), seen.viewed(), look.terms(), look.sides());
    }

    /** Whether the pipeline itself lights and textures, rather than a paint after it. */
    private static boolean drawsDirectly(Look look, ShadingMethod shading) {
        return shading != ShadingMethod.TONE && look.cue().isEmpty();
    }

    private static DirectLook directLook(Look look, ShadingMethod shading) {
        DirectLook.LightingPlace light =
                switch (shading) {
                    case FLAT -> DirectLook.LightingPlace.FACES;
                    case GOURAUD -> DirectLook.LightingPlace.CORNERS;
                    case PHONG -> DirectLook.LightingPlace.PIXELS;
                    default -> throw new AssertionError("the pipeline does not draw " + shading);
                };
        return new DirectLook(light, look.texture(), look.savings());
    }

    private synchronized DirectPicture direct() {
        if (direct.isEmpty()) direct = Optional.of(new DirectPicture(pipelines.get()));
        return direct.get();
    }

    /** Ends the pipeline's threads; a later picture starts them again. */
    @Override
    public synchronized void close() {
        direct.ifPresent(DirectPicture::close);
        direct = Optional.empty();
    }

    private static WireStyle wire(Look look) {
        boolean whole = look.visibility().equals(HIDES_NOTHING);
        return whole ? look.wire().withoutHiding() : look.wire();
    }

    private static Optional<DepthFade> fade(Look look, RequestView seen) {
        int background = seen.scene().backgroundRgb();
        return look.cue().map(cue -> new DepthFade(cue, seen.viewed(), background));
    }

    /** The colours of the faces that a request shows, with a shading that is not wire or auto. */
    static FacePaint paint(Look look, ShadingMethod shading, RequestView seen) {
        var paints =
                new Paints(lights(look, seen), look.texture(), fade(look, seen), look.outline());
        return switch (shading) {
            case TONE -> paints.tone();
            case FLAT -> paints.flat();
            case GOURAUD -> paints.gouraud();
            case PHONG -> paints.phong();
            case WIRE, AUTO -> throw new AssertionError("no paint for " + shading);
        };
    }
}
