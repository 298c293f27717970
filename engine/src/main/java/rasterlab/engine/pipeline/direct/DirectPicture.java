package rasterlab.engine.pipeline.direct;

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
        List<Batch> batches = Batches.of(lights, opaque);
        boolean lightShows = batches.stream().anyMatch(b -> lightShows(look, lights.scene(), b));
        Function<FaceTriangles, TriangleMesh> lit =
                lightShows ? lit(lights, look.light()) : FaceTriangles::uncolored;
        for (int k = 0; k < batches.size(); k++) {
            Batch batch = batches.get(k);
            Optional<LaidTexture> laid = look.laid(lights.scene().finishes().get(batch.finish()));
            Surface surface =
                    surface(
                            look,
                            laid,
                            lighting[batch.finish()],
                            batch.opaque(),
                            lights.mesh().hasColors());
            var triangles = new FaceTriangles(lights.mesh(), batch.faces());
            TriangleMesh mesh = lit.apply(triangles);
            if (batches.size() == 1)
                pipeline.drawOn(background, mesh, view, surface, out, cancelled);
            else if (k == 0)
                pipeline.drawOn(background, mesh, view, surface, withDepths(out), cancelled);
            else pipeline.draw(mesh, view, surface, withDepths(out), cancelled);
        }
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

    /** Lights all faces at once; a batch takes what is its own. */
    private static Function<FaceTriangles, TriangleMesh> lit(
            FaceLights lights, DirectLook.Light light) {
        return switch (light) {
            case FACES -> {
                int[] faceArgb = lights.atMiddles();
                yield triangles -> triangles.flat(faceArgb);
            }
            case CORNERS -> {
                float[] cornerRgba = lights.atCorners();
                yield triangles -> triangles.smooth(cornerRgba);
            }
            case PIXELS ->
                    lights.mesh().hasColors() ? FaceTriangles::tinted : FaceTriangles::uncolored;
        };
    }

    private static Surface surface(
            DirectLook look,
            Optional<LaidTexture> laid,
            PointLighting lighting,
            boolean opaque,
            boolean tinted) {
        Surface.OfVertices vertices =
                look.light() == DirectLook.Light.FACES
                        ? new Surface.Flat(VertexColors.own())
                        : new Surface.Smooth(VertexColors.own());
        boolean perPixel = look.light() == DirectLook.Light.PIXELS;
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
