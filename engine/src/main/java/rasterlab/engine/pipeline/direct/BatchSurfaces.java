package rasterlab.engine.pipeline.direct;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.pipeline.direct.Batches.Batch;
import rasterlab.engine.pipeline.fast.Blending;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.VertexColors;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.surface.ColoredPixels;
import rasterlab.engine.pipeline.surface.LitPixels;
import rasterlab.engine.pipeline.surface.TexelPixels;
import rasterlab.engine.pipeline.surface.TexturedPixels;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.texture.TextureSampler;

/** The surfaces of one picture's batches: their light, texture and transparency. */
final class BatchSurfaces {
    private static final boolean[] NOT_TOLD = {};

    private final FaceLights lights;
    private final DirectLook look;
    private final PointLighting[] lighting;

    /** One colour 0xAARRGGBB a face where light is worked out so and seen. */
    private final int[] faceArgb;

    private final boolean[] behind;

    /**
     * @param drawn whether each face is drawn at all
     */
    BatchSurfaces(FaceLights lights, DirectLook look, boolean[] drawn, List<Batch> batches) {
        this.lights = lights;
        this.look = look;
        lighting = lights.forThread();
        boolean flat = look.light() == DirectLook.LightingPlace.FACES;
        faceArgb =
                flat && batches.stream().anyMatch(this::lightShows)
                        ? lights.atMiddles(drawn)
                        : new int[lights.mesh().faceCount()];
        behind = lights.twoSided() ? behind(lights) : NOT_TOLD;
    }

    private static boolean[] behind(FaceLights lights) {
        boolean[] behind = new boolean[lights.mesh().faceCount()];
        for (int f = 0; f < behind.length; f++) behind[f] = lights.seenFromBehind(f);
        return behind;
    }

    Surface of(Batch batch, PackedFaces faces) {
        Optional<LaidTexture> laid = laid(batch);
        Surface.OfVertices vertices = ofVertices(batch, faces);
        if (batch.opaque() && !batch.atPixels() && laid.isEmpty()) return vertices;
        PixelColors light = batch.atPixels() ? litPixels(batch) : new ColoredPixels();
        return new Surface.PerPixel(laid.map(l -> textured(l, light, batch)).orElse(light))
                .over(vertices)
                .with(batch.opaque() ? Blending.OPAQUE : Blending.GLASS);
    }

    private Surface.OfVertices ofVertices(Batch batch, PackedFaces faces) {
        if (look.light() == DirectLook.LightingPlace.FACES)
            return new Surface.Flat(new FaceTint(faces, faceArgb));
        return new Surface.Smooth(
                batch.atPixels()
                        ? VertexColors.own()
                        : new CornerLight(faces, lighting[batch.finish()], behind));
    }

    private PixelColors litPixels(Batch batch) {
        PointLighting own = lighting[batch.finish()];
        return lights.mesh().hasColors() ? LitPixels.tinted(own) : new LitPixels(own);
    }

    private PixelColors textured(LaidTexture laid, PixelColors light, Batch batch) {
        var sampler = new TextureSampler(laid.texture(), laid.alongS(), laid.alongT());
        if (hidesLight(laid, batch)) return new TexelPixels(sampler, look.filter());
        return new TexturedPixels(sampler, look.filter(), laid.environment(), light);
    }

    private Optional<LaidTexture> laid(Batch batch) {
        return look.laid(lights.scene().finishes().get(batch.finish()));
    }

    /** Whether anything is seen of a batch's own colours, or a texture hides them. */
    private boolean lightShows(Batch batch) {
        return laid(batch).filter(laid -> hidesLight(laid, batch)).isEmpty();
    }

    private static boolean hidesLight(LaidTexture laid, Batch batch) {
        return batch.opaque() && laid.environment().hidesSurface();
    }
}
