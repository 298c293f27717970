package rasterlab.app.opengl.call;

import java.nio.ByteBuffer;
import org.lwjgl.BufferUtils;
import org.lwjgl.opengl.GL11;
import rasterlab.app.opengl.state.GlChoice;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.app.opengl.state.GlName;
import rasterlab.app.opengl.state.Setting;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureLevel;

/** The calls of a texture: its levels, filters, what is outside, environment and matrix. */
final class TextureCalls {
    private static final int[] FORMATS = {
        GL11.GL_LUMINANCE, GL11.GL_LUMINANCE_ALPHA, GL11.GL_RGB, GL11.GL_RGBA
    };
    private static final String[] FORMAT_NAMES = {
        "GL_LUMINANCE", "GL_LUMINANCE_ALPHA", "GL_RGB", "GL_RGBA"
    };

    /** The sized formats, by which no texel is stored with fewer bits. */
    private static final int[] STORED = {
        GL11.GL_LUMINANCE8, GL11.GL_LUMINANCE8_ALPHA8, GL11.GL_RGB8, GL11.GL_RGBA8
    };

    private static final String[] STORED_NAMES = {
        "GL_LUMINANCE8", "GL_LUMINANCE8_ALPHA8", "GL_RGB8", "GL_RGBA8"
    };

    private final GlChoice choice;
    private final CallList calls;

    TextureCalls(GlFrame frame, CallList calls) {
        choice = frame.choice();
        this.calls = calls;
    }

    void add(Texture texture) {
        upload(texture);
        calls.of(Setting.MIN_FILTER)
                .textureParameter(GlName.GL_TEXTURE_MIN_FILTER, choice.named(Setting.MIN_FILTER));
        calls.of(Setting.MAG_FILTER)
                .textureParameter(GlName.GL_TEXTURE_MAG_FILTER, choice.named(Setting.MAG_FILTER));
        calls.of(Setting.WRAP_S)
                .textureParameter(GlName.GL_TEXTURE_WRAP_S, choice.named(Setting.WRAP_S));
        calls.of(Setting.WRAP_T)
                .textureParameter(GlName.GL_TEXTURE_WRAP_T, choice.named(Setting.WRAP_T));
        environment();
        matrix();
        calls.of(Setting.TEXTURE_2D).enable(GlName.GL_TEXTURE_2D, true);
    }

    private void upload(Texture texture) {
        int kind = texture.components() - 1;
        calls.of(Setting.IMAGE)
                .add("glBindTexture(GL_TEXTURE_2D, texture)", objects -> objects.bind(texture));
        calls.of(Setting.COMPONENTS)
                .add(
                        "glTexImage2D(GL_TEXTURE_2D, 0…%d, %s, %d, %d, 0, %s, GL_UNSIGNED_BYTE, …)"
                                .formatted(
                                        texture.levelCount() - 1,
                                        STORED_NAMES[kind],
                                        texture.width(),
                                        texture.height(),
                                        FORMAT_NAMES[kind]),
                        objects -> objects.upload(texture, () -> levels(texture, kind)));
    }

    private static void levels(Texture texture, int kind) {
        GL11.glPixelStorei(GL11.GL_UNPACK_ALIGNMENT, 1);
        for (int k = 0; k < texture.levelCount(); k++) {
            TextureLevel level = texture.level(k);
            GL11.glTexImage2D(
                    GL11.GL_TEXTURE_2D,
                    k,
                    STORED[kind],
                    level.width(),
                    level.height(),
                    0,
                    FORMATS[kind],
                    GL11.GL_UNSIGNED_BYTE,
                    bytes(level, texture.components()));
        }
    }

    /** Texels as OpenGL takes them: luminance or red, green, blue, then alpha. */
    private static ByteBuffer bytes(TextureLevel level, int components) {
        int count = level.width() * level.height();
        ByteBuffer bytes = BufferUtils.createByteBuffer(count * components);
        for (int i = 0; i < count; i++) {
            int texel = level.texel(i % level.width(), i / level.width());
            bytes.put((byte) (texel >> 16));
            if (components > 2) bytes.put((byte) (texel >> 8)).put((byte) texel);
            if (components % 2 == 0) bytes.put((byte) (texel >> 24));
        }
        return bytes.flip();
    }

    private void environment() {
        GlName mode = choice.named(Setting.ENV_MODE);
        calls.of(Setting.ENV_MODE)
                .add(
                        "glTexEnvi(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, " + mode + ")",
                        () ->
                                GL11.glTexEnvi(
                                        GL11.GL_TEXTURE_ENV,
                                        GL11.GL_TEXTURE_ENV_MODE,
                                        mode.value()));
        if (mode != GlName.GL_BLEND) return;
        double red = FrameCalls.share(GlFrame.ENVIRONMENT, 16);
        double green = FrameCalls.share(GlFrame.ENVIRONMENT, 8);
        double blue = FrameCalls.share(GlFrame.ENVIRONMENT, 0);
        calls.add(
                "glTexEnvfv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, {%s})"
                        .formatted(CallList.numbers(red, green, blue, 1)),
                () ->
                        GL11.glTexEnvfv(
                                GL11.GL_TEXTURE_ENV,
                                GL11.GL_TEXTURE_ENV_COLOR,
                                new float[] {(float) red, (float) green, (float) blue, 1}));
    }

    private void matrix() {
        calls.of(Setting.TEXTURE_MATRIX).matrixMode(GlName.GL_TEXTURE);
        switch (choice.get(Setting.TEXTURE_MATRIX)) {
            case "scale" -> calls.add("glScaled(2, 2, 1)", () -> GL11.glScaled(2, 2, 1));
            case "rotate" -> calls.rotate(GlFrame.TURNED_TEXTURE, 0, 0, 1);
            case "translate" -> calls.translate(0.25, 0.25, 0);
            default -> {}
        }
        calls.add(
                "glMatrixMode(" + GlName.GL_MODELVIEW + ")",
                () -> GL11.glMatrixMode(GL11.GL_MODELVIEW));
    }
}
