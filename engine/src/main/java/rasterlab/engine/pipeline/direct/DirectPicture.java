package rasterlab.engine.pipeline.direct;

import java.lang.ref.SoftReference;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.pipeline.direct.Batches.Batch;
import rasterlab.engine.pipeline.fast.DepthRaster;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.MixedLight;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;

/**
 * One picture after the other by one pipeline; keeps its working memory and the last scene's faces
 * as the pipeline reads them. One thread at a time.
 */
public final class DirectPicture implements AutoCloseable {
    private final TrianglePipeline pipeline;
    private float[] depths = {};

    /** Given up where memory is short: the scene that is packed need not be in use any more. */
    private SoftReference<PackedScene> known = new SoftReference<>(null);

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
        boolean[] drawn = look.drawn(lights);
        boolean[] atPixels = atPixels(lights, look, drawn, opaque);
        List<Batch> batches = Batches.of(lights, opaque, drawn, atPixels);
        if (batches.isEmpty()) {
            out.clear(background);
            return;
        }
        TriangleView view = space.view();
        PackedScene packed = packed(lights, look);
        var surfaces = new BatchSurfaces(lights, look, drawn, batches);
        for (int k = 0; k < batches.size(); k++) {
            Batch batch = batches.get(k);
            PackedFaces faces = packed.with(batch);
            Surface surface = surfaces.of(batch, faces);
            TriangleMesh mesh = faces.triangles(batch.faces());
            if (batches.size() == 1)
                pipeline.drawOn(background, mesh, view, surface, out, cancelled);
            else if (k == 0)
                pipeline.drawOn(background, mesh, view, surface, withDepths(out), cancelled);
            else pipeline.draw(mesh, view, surface, withDepths(out), cancelled);
        }
    }

    /** Packs the faces again only where the scene or what is told apart has changed. */
    private PackedScene packed(FaceLights lights, DirectLook look) {
        boolean apart = look.light() == DirectLook.LightingPlace.FACES || lights.twoSided();
        PackedScene kept = known.get();
        if (kept != null && kept.holds(lights.scene(), apart)) return kept;
        var packed = new PackedScene(lights.scene(), apart);
        known = new SoftReference<>(packed);
        return packed;
    }

    /** Which faces have their light worked out at each pixel. */
    private static boolean[] atPixels(
            FaceLights lights, DirectLook look, boolean[] drawn, boolean[] opaque) {
        boolean pixels = look.light() == DirectLook.LightingPlace.PIXELS;
        if (pixels && look.savings().levels() > 0) return mixed(lights, look, drawn, opaque);
        boolean[] atPixels = new boolean[drawn.length];
        Arrays.fill(atPixels, pixels);
        return atPixels;
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

    private DepthRaster withDepths(Raster out) {
        int cells = out.argb().length;
        if (depths.length != cells) depths = new float[cells];
        return new DepthRaster(out, depths);
    }

    @Override
    public void close() {
        pipeline.close();
    }
}
