package rasterlab.engine.pipeline.direct;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.pipeline.direct.Batches.Batch;
import rasterlab.engine.pipeline.fast.Blending;
import rasterlab.engine.pipeline.fast.DepthRaster;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.pipeline.fast.VertexColors;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.MixedLight;
import rasterlab.engine.pipeline.surface.ColoredPixels;
import rasterlab.engine.pipeline.surface.LitPixels;
import rasterlab.engine.pipeline.surface.TexelPixels;
import rasterlab.engine.pipeline.surface.TexturedPixels;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.TriangleMesh;
import rasterlab.engine.texture.TextureSampler;

/** One picture after the other by one pipeline; keeps its working memory. One thread at a time. */
public final class DirectPicture implements AutoCloseable {
    private final TrianglePipeline pipeline;
    private float[] depths = {};

    /**
     * @param pipeline draws for this alone, and ends with it
     */
    public DirectPicture(TrianglePipeline pipeline) {
        this.pipeline = pipeline;
    }

    /**
     * Draws the whole picture, whatever it held.
     *
     * @param background 0xAARRGGBB
     * @param cancelled asked by several threads
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public synchronized void draw(
            FaceLights lights,
            DirectLook look,
            int background,
            Raster out,
            BooleanSupplier cancelled) {
        var space = new ClipSpace(lights.view());
        if (space.empty()) {
            out.clear(background);
            return;
        }
        boolean[] opaque = look.opaque(lights);
        PointLighting[] lighting = lights.forThread();
        TriangleView view = space.view();
        boolean[] drawn = look.drawn(lights);
        boolean mixed = look.light() == DirectLook.Light.PIXELS && look.savings().levels() > 0;
        boolean[] atPixels = new boolean[drawn.length];
        if (mixed) atPixels = mixed(lights, look, drawn, opaque);
        else Arrays.fill(atPixels, look.light() == DirectLook.Light.PIXELS);
        List<Batch> batches = Batches.of(lights, opaque, drawn, atPixels);
        if (batches.isEmpty()) {
            out.clear(background);
            return;
        }
        Function<FaceTriangles, TriangleMesh> lit =
                shownLight(lights, look, drawn, atPixels, batches);
        for (int k = 0; k < batches.size(); k++) {
            Batch batch = batches.get(k);
            Optional<LaidTexture> laid = look.laid(lights.scene().finishes().get(batch.finish()));
            Surface surface =
                    surface(look, laid, lighting[batch.finish()], batch, lights.mesh().hasColors());
            var triangles = new FaceTriangles(lights.mesh(), batch.faces());
            TriangleMesh mesh =
                    !batch.atPixels()
                            ? lit.apply(triangles)
                            : lights.mesh().hasColors()
                                    ? triangles.tinted()
                                    : triangles.uncolored();
            if (batches.size() == 1)
                pipeline.drawOn(background, mesh, view, surface, out, cancelled);
            else if (k == 0)
                pipeline.drawOn(background, mesh, view, surface, withDepths(out), cancelled);
            else pipeline.draw(mesh, view, surface, withDepths(out), cancelled);
        }
    }

    /** Transparent faces keep one way of lighting: each change of it in their order is a pass. */
    private static boolean[] mixed(
            FaceLights lights, DirectLook look, boolean[] drawn, boolean[] opaque) {
        boolean[] asked = new boolean[drawn.length];
        for (int f = 0; f < asked.length; f++) asked[f] = drawn[f] && opaque[f];
        boolean[] atPixels = new MixedLight(lights, look.savings().levels()).atPixels(asked);
        for (int f = 0; f < asked.length; f++) if (!opaque[f]) atPixels[f] = true;
        return atPixels;
    }

    /** Lights what is not worked out at pixels, if anything of it is seen. */
    private static Function<FaceTriangles, TriangleMesh> shownLight(
            FaceLights lights,
            DirectLook look,
            boolean[] drawn,
            boolean[] atPixels,
            List<Batch> batches) {
        boolean shows =
                batches.stream()
                        .anyMatch(b -> !b.atPixels() && lightShows(look, lights.scene(), b));
        if (!shows) return FaceTriangles::uncolored;
        boolean[] wanted = new boolean[drawn.length];
        for (int f = 0; f < wanted.length; f++) wanted[f] = drawn[f] && !atPixels[f];
        return look.light() == DirectLook.Light.FACES
                ? flat(lights.atMiddles(wanted))
                : smooth(lights.atCorners(wanted));
    }

    private static Function<FaceTriangles, TriangleMesh> flat(int[] faceArgb) {
        return triangles -> triangles.flat(faceArgb);
    }

    private static Function<FaceTriangles, TriangleMesh> smooth(float[] cornerRgba) {
        return triangles -> triangles.smooth(cornerRgba);
    }

    /** Whether anything is seen of a batch's own colours, or a texture hides them. */
    private static boolean lightShows(DirectLook look, Scene scene, Batch batch) {
        return look.laid(scene.finishes().get(batch.finish()))
                .filter(laid -> hidesLight(laid, batch.opaque()))
                .isEmpty();
    }

    private static boolean hidesLight(LaidTexture laid, boolean opaque) {
        return opaque && laid.environment().hidesSurface();
    }

    private DepthRaster withDepths(Raster out) {
        int cells = out.argb().length;
        if (depths.length != cells) depths = new float[cells];
        return new DepthRaster(out, depths);
    }

    private static Surface surface(
            DirectLook look,
            Optional<LaidTexture> laid,
            PointLighting lighting,
            Batch batch,
            boolean tinted) {
        boolean opaque = batch.opaque();
        boolean perPixel = batch.atPixels();
        Surface.OfVertices vertices =
                look.light() == DirectLook.Light.FACES
                        ? new Surface.Flat(VertexColors.own())
                        : new Surface.Smooth(VertexColors.own());
        if (opaque && !perPixel && laid.isEmpty()) return vertices;
        PixelColors light =
                !perPixel
                        ? new ColoredPixels()
                        : tinted ? LitPixels.tinted(lighting) : new LitPixels(lighting);
        PixelColors colours = laid.map(l -> textured(look, l, light, opaque)).orElse(light);
        return new Surface.PerPixel(colours)
                .over(vertices)
                .with(opaque ? Blending.OPAQUE : Blending.GLASS);
    }

    private static PixelColors textured(
            DirectLook look, LaidTexture laid, PixelColors light, boolean opaque) {
        var sampler = new TextureSampler(laid.texture(), laid.alongS(), laid.alongT());
        if (hidesLight(laid, opaque)) return new TexelPixels(sampler, look.filter());
        return new TexturedPixels(sampler, look.filter(), laid.environment(), light);
    }

    @Override
    public void close() {
        pipeline.close();
    }
}
