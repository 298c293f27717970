package rasterlab.tests.bench.pipeline;

import java.util.Optional;
import java.util.function.Supplier;
import org.lwjgl.opengl.GL11C;
import rasterlab.engine.light.Material;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.Wrap;

/** The looks of the torus, by a user's call and by OpenGL. */
enum TorusLook {
    GOURAUD("Gouraud", 3.5, "gouraud", TextureMode.NONE, GlProgram::smooth),
    PHONG("Phong", 2.5, "phong", TextureMode.NONE, GlProgram::phong),
    NEAREST("Gouraud and nearest texel", 3, "gouraud", TextureMode.NEAREST, GlProgram::textured),
    TRILINEAR(
            "Gouraud and trilinear texture", 2, "gouraud", TextureMode.MIPMAP, GlProgram::textured),
    GLASS("half transparent", 0, "gouraud", TextureMode.NONE, GlProgram::glass);

    static final int BASE_RGB = 0xE69950;
    static final double SPECULAR = 0.5;
    static final int SHININESS = 32;

    /** The goal of Gouraud's shading on one core. */
    private static final double ALONE = 2.2;

    private static final int SIDE = 512;

    private final String text;
    private final double goal;
    private final String shading;
    private final TextureMode texture;
    private final Supplier<GlProgram> program;

    TorusLook(
            String text,
            double goal,
            String shading,
            TextureMode texture,
            Supplier<GlProgram> program) {
        this.text = text;
        this.goal = goal;
        this.shading = shading;
        this.texture = texture;
        this.program = program;
    }

    String text() {
        return text;
    }

    double goal(int cores) {
        return this == GOURAUD && cores == 1 ? ALONE : goal;
    }

    String shading() {
        return shading;
    }

    TextureMode texture() {
        return texture;
    }

    Appearance finish() {
        Material opaque = Material.dull(base(16), base(8), base(0)).shiny(SPECULAR, SHININESS);
        Material material = this == GLASS ? new Material(opaque.surface(), 0.5) : opaque;
        Texture waves = waves();
        Optional<LaidTexture> laid =
                texture == TextureMode.NONE
                        ? Optional.empty()
                        : Optional.of(
                                new LaidTexture(
                                        waves,
                                        Wrap.REPEAT,
                                        Wrap.REPEAT,
                                        TextureEnvironment.of(
                                                TextureEnvironment.Mode.MODULATE, waves)));
        return new Appearance(material, material, laid);
    }

    /** A share of the material's colour, 0 to 1. */
    static double base(int shift) {
        return (BASE_RGB >> shift & 255) / 255.0;
    }

    GlProgram program() {
        return program.get();
    }

    GlTexture glTexture() {
        return new GlTexture(waves(), this == TRILINEAR);
    }

    /** Sets what OpenGL does with depth and colours. */
    void begin() {
        GL11C.glDepthMask(this != GLASS);
        GL11C.glBlendFunc(GL11C.GL_SRC_ALPHA, GL11C.GL_ONE_MINUS_SRC_ALPHA);
        if (this == GLASS) GL11C.glEnable(GL11C.GL_BLEND);
    }

    /** Leaves OpenGL as it was: no clear touches depths that cannot be written. */
    void end() {
        GL11C.glDepthMask(true);
        GL11C.glDisable(GL11C.GL_BLEND);
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
