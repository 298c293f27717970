package rasterlab.tests.bench.pipeline;

import java.util.function.Function;
import java.util.function.Supplier;
import org.lwjgl.opengl.GL11C;
import rasterlab.engine.pipeline.fast.Blending;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.surface.ColoredPixels;
import rasterlab.engine.pipeline.surface.TexelFilter;
import rasterlab.engine.pipeline.surface.TexturedPixels;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureSampler;
import rasterlab.engine.texture.Wrap;

/** What the torus is drawn with, by the pipeline and by OpenGL. */
enum TorusLook {
    GOURAUD("Gouraud", 3.5, Surface.Smooth::new, GlProgram::smooth),
    PHONG("Phong", 2.5, Surface.PerPixel::new, GlProgram::phong),
    NEAREST(
            "Gouraud and nearest texel",
            3,
            light -> textured(light, TexelFilter.NEAREST),
            GlProgram::textured),
    TRILINEAR(
            "Gouraud and trilinear texture",
            2,
            light -> textured(light, TexelFilter.MIPMAP),
            GlProgram::textured),
    GLASS(
            "half transparent",
            0,
            light -> new Surface.PerPixel(new ColoredPixels(), half(light), Blending.GLASS),
            GlProgram::glass);

    /** The goal of Gouraud's shading on one core. */
    private static final double ALONE = 2.2;

    private static final int SIDE = 512;

    private final String text;
    private final double goal;
    private final Function<DistantLight, Surface> surface;
    private final Supplier<GlProgram> program;

    TorusLook(
            String text,
            double goal,
            Function<DistantLight, Surface> surface,
            Supplier<GlProgram> program) {
        this.text = text;
        this.goal = goal;
        this.surface = surface;
        this.program = program;
    }

    String text() {
        return text;
    }

    double goal(int cores) {
        return this == GOURAUD && cores == 1 ? ALONE : goal;
    }

    Surface surface(TorusScene scene) {
        return surface.apply(scene.light());
    }

    GlProgram program() {
        return program.get();
    }

    GlTexture texture() {
        return new GlTexture(waves(), this == TRILINEAR);
    }

    /** Sets what OpenGL does with depth and colours. */
    void begin() {
        GL11C.glEnable(GL11C.GL_CULL_FACE);
        GL11C.glDepthMask(this != GLASS);
        GL11C.glBlendFunc(GL11C.GL_SRC_ALPHA, GL11C.GL_ONE_MINUS_SRC_ALPHA);
        if (this == GLASS) GL11C.glEnable(GL11C.GL_BLEND);
    }

    /** Leaves OpenGL as it was: no clear touches depths that cannot be written. */
    void end() {
        GL11C.glDepthMask(true);
        GL11C.glDisable(GL11C.GL_BLEND);
    }

    private static Surface.OfVertices half(DistantLight light) {
        return new Surface.Smooth(
                block -> {
                    light.color(block);
                    for (int i = 0; i < block.count; i++) block.alpha[i] = 0.5f;
                });
    }

    private static Surface textured(DistantLight light, TexelFilter filter) {
        Texture waves = waves();
        var pixels =
                new TexturedPixels(
                        new TextureSampler(waves, Wrap.REPEAT, Wrap.REPEAT),
                        filter,
                        TextureEnvironment.of(TextureEnvironment.Mode.MODULATE, waves),
                        new ColoredPixels());
        return new Surface.PerPixel(pixels).over(new Surface.Smooth(light));
    }

    /** Four waves each way; a texel differs from its neighbours by 6 levels at most. */
    private static Texture waves() {
        int[] argb = new int[SIDE * SIDE];
        for (int i = 0; i < argb.length; i++) {
            int across = wave(i % SIDE);
            int up = wave(i / SIDE);
            argb[i] = 0xFF000000 | across << 16 | up << 8 | 255 - (across + up) / 2;
        }
        return Texture.of(SIDE, SIDE, 3, argb);
    }

    private static int wave(int texel) {
        return (int) Math.round(128 + 100 * Math.sin(texel * 8 * Math.PI / SIDE));
    }
}
