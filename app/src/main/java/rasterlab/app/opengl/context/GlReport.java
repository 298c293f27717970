package rasterlab.app.opengl.context;

import java.util.Optional;
import org.lwjgl.opengl.GL;
import org.lwjgl.opengl.GL11;
import org.lwjgl.opengl.GLCapabilities;

/**
 * The report of the current context on itself.
 *
 * @param version OpenGL's, with what the driver adds
 * @param renderer what draws
 * @param textureSide GL_MAX_TEXTURE_SIZE
 * @param lights GL_MAX_LIGHTS
 * @param modelViews GL_MAX_MODELVIEW_STACK_DEPTH
 * @param anySize whether textures' sides need not be powers of two
 */
public record GlReport(
        String version,
        String renderer,
        int textureSide,
        int lights,
        int modelViews,
        boolean anySize) {
    /**
     * Asks the context that is current on this thread.
     *
     * @throws NoOpenGl where it lacks what the lab draws with; then nothing may be drawn
     */
    public static GlReport ofCurrent() {
        GLCapabilities has = GL.getCapabilities();
        String version = stringOf(GL11.GL_VERSION);
        if (!has.OpenGL14) throw new NoOpenGl("OpenGL " + version + " is older than 1.4");
        if (has.glBegin == 0 || has.glMatrixMode == 0 || has.glNewList == 0)
            throw new NoOpenGl(
                    "OpenGL " + version + " is a core profile: it has no glBegin and no lights");
        return new GlReport(
                version,
                stringOf(GL11.GL_RENDERER),
                GL11.glGetInteger(GL11.GL_MAX_TEXTURE_SIZE),
                GL11.glGetInteger(GL11.GL_MAX_LIGHTS),
                GL11.glGetInteger(GL11.GL_MAX_MODELVIEW_STACK_DEPTH),
                has.OpenGL20 || has.GL_ARB_texture_non_power_of_two);
    }

    private static String stringOf(int name) {
        return Optional.ofNullable(GL11.glGetString(name)).orElse("–");
    }

    /** The first error that OpenGL has noted since it was last asked; 0 for none. */
    public static int error() {
        int first = GL11.glGetError();
        for (int k = 0, next = first; next != 0 && k < 16; k++) next = GL11.glGetError();
        return first;
    }
}
