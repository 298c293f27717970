package rasterlab.app.opengl.software;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import org.joml.Matrix4d;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.GlShape;
import rasterlab.app.opengl.state.Setting;
import rasterlab.engine.pipeline.fast.Blending;
import rasterlab.engine.pipeline.fast.Culling;
import rasterlab.engine.pipeline.fast.DepthRaster;
import rasterlab.engine.pipeline.fast.PixelColors;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.engine.pipeline.fast.TriangleView;
import rasterlab.engine.pipeline.fast.VertexColors;
import rasterlab.engine.pipeline.surface.ColoredPixels;
import rasterlab.engine.pipeline.surface.MinMag;
import rasterlab.engine.pipeline.surface.MinMagPixels;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureMatrix;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;

/** Draws frames with the engine's pipeline. One thread at a time. */
public final class SoftwarePainter implements AutoCloseable {
    private final TrianglePipeline pipeline = new TrianglePipeline();

    /**
     * @throws CancellationException soon after {@code cancelled} says true
     */
    public Raster draw(GlFrame frame, BooleanSupplier cancelled) {
        GlChoice choice = frame.choice();
        var out = new DepthRaster(frame.width(), frame.height());
        out.raster().clear(GlFrame.BACKGROUND);
        var assembly = new ShapeAssembly(frame);
        var lampsToEye = new Matrix4d().translate(0, 0, -choice.distance());
        var colored = new ColoredPixels();
        for (GlShape lamp : frame.lamps())
            add(frame, assembly.assemble(lamp, lampsToEye, 1), colored, out, cancelled);
        PixelColors colors =
                frame.texture().map(texture -> textured(texture, frame)).orElse(colored);
        double alpha = choice.number(Setting.ALPHA);
        for (GlShape shape : frame.shapes())
            add(frame, assembly.assemble(shape, frame.modelView(), alpha), colors, out, cancelled);
        if (choice.is(Setting.SCISSOR_TEST, "on")) cut(out.raster(), frame.scissors());
        return out.raster();
    }

    private void add(
            GlFrame frame,
            TriangleCorners corners,
            PixelColors colors,
            DepthRaster out,
            BooleanSupplier cancelled) {
        if (corners.isEmpty()) return;
        var view = new TriangleView(new Matrix4d(), frame.projection(), List.of(), Culling.NONE);
        var surface =
                new Surface.PerPixel(
                        colors, new Surface.Smooth(VertexColors.own()), blending(frame.choice()));
        pipeline.draw(corners.mesh(), view, surface, out, cancelled);
    }

    private static PixelColors textured(Texture texture, GlFrame frame) {
        GlChoice choice = frame.choice();
        var sampler =
                new TextureSampler(
                        texture, wrap(choice, Setting.WRAP_S), wrap(choice, Setting.WRAP_T));
        var filters =
                new MinMag(
                        MinMag.MinificationFilter.valueOf(
                                withoutPrefix(choice, Setting.MIN_FILTER)),
                        choice.is(Setting.MAG_FILTER, "GL_LINEAR"));
        var environment = environment(choice, texture.components());
        PixelColors under = new ColoredPixels();
        if (environment.isEmpty()) return under;
        return new MinMagPixels(
                sampler,
                filters,
                environment.get(),
                new TextureMatrix(frame.textureMatrix()),
                choice.is(Setting.INTERPOLATION, "affine"),
                under);
    }

    /** The environment; empty where OpenGL leaves open what is to come out. */
    private static Optional<TextureEnvironment> environment(GlChoice choice, int components) {
        var mode = TextureEnvironment.Mode.valueOf(withoutPrefix(choice, Setting.ENV_MODE));
        return mode == TextureEnvironment.Mode.DECAL && components < 3
                ? Optional.empty()
                : Optional.of(new TextureEnvironment(mode, components, GlFrame.ENVIRONMENT));
    }

    private static Wrap wrap(GlChoice choice, Setting setting) {
        return choice.is(setting, "GL_MIRRORED_REPEAT")
                ? Wrap.MIRRORED
                : Wrap.valueOf(withoutPrefix(choice, setting));
    }

    private static String withoutPrefix(GlChoice choice, Setting setting) {
        return choice.get(setting).substring("GL_".length());
    }

    /** The engine's form of alpha test, blending and depth test. */
    private static Blending blending(GlChoice choice) {
        boolean mixed = choice.is(Setting.BLEND, "GL_SRC_ALPHA:GL_ONE_MINUS_SRC_ALPHA");
        Blending blending = mixed ? Blending.OVER : Blending.OPAQUE;
        if (choice.is(Setting.ALPHA_TEST, "GL_GEQUAL"))
            blending = blending.dropBelow((int) Math.ceil(255 * GlFrame.ALPHA_REFERENCE));
        if (choice.is(Setting.DEPTH_TEST, "off")) return blending.withoutDepth();
        return choice.is(Setting.DEPTH_MASK, "GL_FALSE") ? blending.withoutWriting() : blending;
    }

    /** The scissors take away what lies outside of their rectangle. */
    private static void cut(Raster raster, int[] rectangle) {
        int left = rectangle[0];
        int right = left + rectangle[2];
        int bottom = raster.height() - rectangle[1];
        int top = bottom - rectangle[3];
        for (int y = 0; y < raster.height(); y++) {
            int row = y * raster.width();
            if (y < top || y >= bottom)
                Arrays.fill(raster.argb(), row, row + raster.width(), GlFrame.BACKGROUND);
            Arrays.fill(raster.argb(), row, row + left, GlFrame.BACKGROUND);
            Arrays.fill(raster.argb(), row + right, row + raster.width(), GlFrame.BACKGROUND);
        }
    }

    /** Ends the pipeline's threads. */
    @Override
    public void close() {
        pipeline.close();
    }
}
