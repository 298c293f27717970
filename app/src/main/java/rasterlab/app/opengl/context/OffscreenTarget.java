package rasterlab.app.opengl.context;

import org.lwjgl.opengl.GL;
import org.lwjgl.opengl.GL11;
import org.lwjgl.opengl.GL30;

/** Colours of 8 bits and depths of 24 bits to draw into without a window. */
public final class OffscreenTarget implements AutoCloseable {
    private final int framebuffer;
    private final int color;
    private final int depth;

    /**
     * Makes it the target of the current context.
     *
     * @throws NoOpenGl where OpenGL cannot draw without a window
     */
    public OffscreenTarget(int width, int height) {
        if (!GL.getCapabilities().OpenGL30)
            throw new NoOpenGl("OpenGL before 3.0 draws into windows only");
        framebuffer = GL30.glGenFramebuffers();
        color = GL30.glGenRenderbuffers();
        depth = GL30.glGenRenderbuffers();
        GL30.glBindFramebuffer(GL30.GL_FRAMEBUFFER, framebuffer);
        attach(color, GL11.GL_RGBA8, GL30.GL_COLOR_ATTACHMENT0, width, height);
        attach(depth, GL30.GL_DEPTH_COMPONENT24, GL30.GL_DEPTH_ATTACHMENT, width, height);
        int status = GL30.glCheckFramebufferStatus(GL30.GL_FRAMEBUFFER);
        if (status != GL30.GL_FRAMEBUFFER_COMPLETE) {
            close();
            throw new NoOpenGl("no picture of %d×%d: 0x%X".formatted(width, height, status));
        }
    }

    private static void attach(int buffer, int format, int place, int width, int height) {
        GL30.glBindRenderbuffer(GL30.GL_RENDERBUFFER, buffer);
        GL30.glRenderbufferStorage(GL30.GL_RENDERBUFFER, format, width, height);
        GL30.glFramebufferRenderbuffer(GL30.GL_FRAMEBUFFER, place, GL30.GL_RENDERBUFFER, buffer);
    }

    @Override
    public void close() {
        GL30.glBindFramebuffer(GL30.GL_FRAMEBUFFER, 0);
        GL30.glDeleteFramebuffers(framebuffer);
        GL30.glDeleteRenderbuffers(color);
        GL30.glDeleteRenderbuffers(depth);
    }
}
