package rasterlab.tests.bench.pipeline;

import java.util.Optional;
import org.lwjgl.PointerBuffer;
import org.lwjgl.egl.EGL;
import org.lwjgl.egl.EGL10;
import org.lwjgl.egl.EGL12;
import org.lwjgl.egl.EGL14;
import org.lwjgl.egl.EGL15;
import org.lwjgl.opengl.GL;
import org.lwjgl.opengl.GL11C;
import org.lwjgl.system.JNI;
import org.lwjgl.system.MemoryStack;

/** An OpenGL context without a window or display, current on the thread that opened it. */
final class GlContext implements AutoCloseable {
    /** EGL_PLATFORM_SURFACELESS_MESA. */
    private static final int SURFACELESS = 0x31DD;

    private final long display;
    private final long context;

    private GlContext(long display, long context) {
        this.display = display;
        this.context = context;
    }

    /**
     * Opens a context of OpenGL 3.3.
     *
     * @throws NoOpenGl with the reason where there is none
     */
    static GlContext open() {
        try {
            return create();
        } catch (UnsatisfiedLinkError | IllegalStateException e) {
            throw new NoOpenGl(String.valueOf(e.getMessage()));
        }
    }

    private static GlContext create() {
        try (var stack = MemoryStack.stackPush()) {
            long display = display(stack.pointers(EGL10.EGL_NONE));
            require(display != EGL10.EGL_NO_DISPLAY, "no display without a surface");
            require(
                    EGL10.eglInitialize(display, stack.ints(0), stack.ints(0)),
                    "EGL does not start");
            EGL.createDisplayCapabilities(display);
            require(EGL12.eglBindAPI(EGL14.EGL_OPENGL_API), "EGL has no OpenGL");
            var config = stack.callocPointer(1);
            var found = stack.ints(0);
            var wanted =
                    stack.ints(
                            EGL10.EGL_SURFACE_TYPE,
                            EGL10.EGL_PBUFFER_BIT,
                            EGL12.EGL_RENDERABLE_TYPE,
                            EGL14.EGL_OPENGL_BIT,
                            EGL10.EGL_NONE);
            EGL10.eglChooseConfig(display, wanted, config, found);
            require(found.get(0) > 0, "EGL has no configuration for OpenGL");
            var version =
                    stack.ints(
                            EGL15.EGL_CONTEXT_MAJOR_VERSION,
                            3,
                            EGL15.EGL_CONTEXT_MINOR_VERSION,
                            3,
                            EGL10.EGL_NONE);
            long context =
                    EGL10.eglCreateContext(display, config.get(0), EGL10.EGL_NO_CONTEXT, version);
            require(context != EGL10.EGL_NO_CONTEXT, "no context of OpenGL 3.3");
            EGL10.eglMakeCurrent(display, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_SURFACE, context);
            GL.createCapabilities();
            return new GlContext(display, context);
        }
    }

    /** LWJGL's own method refuses the null that this platform wants for a native display. */
    private static long display(PointerBuffer attributes) {
        long function = EGL.getCapabilities().eglGetPlatformDisplay;
        require(function != 0, "EGL is older than 1.5");
        return JNI.callPPP(SURFACELESS, 0L, attributes.address(), function);
    }

    private static void require(boolean done, String otherwise) {
        if (!done) throw new NoOpenGl(otherwise);
    }

    /** What draws, such as llvmpipe. */
    String renderer() {
        return Optional.ofNullable(GL11C.glGetString(GL11C.GL_RENDERER)).orElse("unnamed")
                + ", "
                + GL11C.glGetString(GL11C.GL_VERSION);
    }

    @Override
    public void close() {
        GL.setCapabilities(null);
        EGL10.eglMakeCurrent(
                display, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_CONTEXT);
        EGL10.eglDestroyContext(display, context);
        EGL10.eglTerminate(display);
    }
}
