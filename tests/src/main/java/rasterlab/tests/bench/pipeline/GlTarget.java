package rasterlab.tests.bench.pipeline;

import static org.lwjgl.opengl.GL30C.*;

import org.lwjgl.BufferUtils;
import org.lwjgl.opengl.GL;
import org.lwjgl.opengl.GL43C;

/** A framebuffer of 8-bit colours with depths of 24 bits. */
final class GlTarget implements AutoCloseable {
    private final int width;
    private final int height;
    private final int framebuffer = glGenFramebuffers();
    private final int[] buffers = {glGenRenderbuffers(), glGenRenderbuffers()};

    GlTarget(int width, int height) {
        this.width = width;
        this.height = height;
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        attach(buffers[0], GL_RGBA8, GL_COLOR_ATTACHMENT0);
        attach(buffers[1], GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            throw new AssertionError("the framebuffer is not complete");
        glViewport(0, 0, width, height);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
    }

    private void attach(int buffer, int format, int place) {
        glBindRenderbuffer(GL_RENDERBUFFER, buffer);
        glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, place, GL_RENDERBUFFER, buffer);
    }

    void clear(int argb) {
        glClearColor((argb >> 16 & 255) / 255f, (argb >> 8 & 255) / 255f, (argb & 255) / 255f, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }

    /** Says that nobody will read the depths, where there is a call that says so. */
    void forgetDepths() {
        if (GL.getCapabilities().OpenGL43)
            GL43C.glInvalidateFramebuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT);
    }

    /** The picture as 0xAARRGGBB, the top row first. */
    int[] read() {
        var bytes = BufferUtils.createByteBuffer(4 * width * height);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, bytes);
        int[] argb = new int[width * height];
        for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++) {
                int at = 4 * ((height - 1 - y) * width + x);
                argb[y * width + x] =
                        0xFF000000
                                | (bytes.get(at) & 255) << 16
                                | (bytes.get(at + 1) & 255) << 8
                                | bytes.get(at + 2) & 255;
            }
        return argb;
    }

    @Override
    public void close() {
        glDeleteFramebuffers(framebuffer);
        glDeleteRenderbuffers(buffers);
    }
}
