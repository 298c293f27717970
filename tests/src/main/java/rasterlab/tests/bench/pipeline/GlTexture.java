package rasterlab.tests.bench.pipeline;

import static org.lwjgl.opengl.GL30C.*;

import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureLevel;

/** A texture with the very levels of ours, so that only the filter differs. */
final class GlTexture implements AutoCloseable {
    private final int texture = glGenTextures();

    /**
     * @param trilinear between two levels rather than the nearest texel of the picture
     */
    GlTexture(Texture picture, boolean trilinear) {
        bind();
        for (int k = 0; k < picture.levelCount(); k++) upload(k, picture.level(k));
        glTexParameteri(
                GL_TEXTURE_2D,
                GL_TEXTURE_MIN_FILTER,
                trilinear ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, trilinear ? GL_LINEAR : GL_NEAREST);
    }

    void bind() {
        glBindTexture(GL_TEXTURE_2D, texture);
    }

    private static void upload(int index, TextureLevel level) {
        int[] argb = new int[level.width() * level.height()];
        for (int i = 0; i < argb.length; i++)
            argb[i] = level.texel(i % level.width(), i / level.width());
        glTexImage2D(
                GL_TEXTURE_2D,
                index,
                GL_RGBA8,
                level.width(),
                level.height(),
                0,
                GL_BGRA,
                GL_UNSIGNED_INT_8_8_8_8_REV,
                argb);
    }

    @Override
    public void close() {
        glDeleteTextures(texture);
    }
}
