package rasterlab.app.opengl.context;

import java.nio.IntBuffer;
import org.lwjgl.PointerBuffer;
import org.lwjgl.egl.EGL;
import org.lwjgl.egl.EGL10;
import org.lwjgl.egl.EGL12;
import org.lwjgl.egl.EGL14;
import org.lwjgl.egl.EGL15;
import org.lwjgl.opengl.GL;
import org.lwjgl.opengl.GLCapabilities;
import org.lwjgl.system.JNI;
import org.lwjgl.system.MemoryStack;

/** An OpenGL context without a window or display, current on the thread that opened it. */
public final class OffscreenContext implements AutoCloseable {
    /** The number of EGL_PLATFORM_SURFACELESS_MESA. */
    private static final int SURFACELESS = 0x31DD;

    private final long display;
    private final long context;
    private final GLCapabilities capabilities;

    private OffscreenContext(long display, long context, GLCapabilities capabilities) {
        this.display = display;
        this.context = context;
        this.capabilities = capabilities;
    }

    /** The part of OpenGL that a context has. */
    public enum ContextProfile {
        /** Everything since 1.0, for programs of OpenGL 1 and 2. */
        OLD(2, 1, 0),
        /** OpenGL 3.3 without what was taken out of it. */
        CORE(3, 3, EGL15.EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT);

        private final int major;
        private final int minor;
        private final int mask;

        ContextProfile(int major, int minor, int mask) {
            this.major = major;
            this.minor = minor;
            this.mask = mask;
        }

        private IntBuffer attributes(MemoryStack stack) {
            return stack.ints(
                    EGL15.EGL_CONTEXT_MAJOR_VERSION,
                    major,
                    EGL15.EGL_CONTEXT_MINOR_VERSION,
                    minor,
                    mask == 0 ? EGL10.EGL_NONE : EGL15.EGL_CONTEXT_OPENGL_PROFILE_MASK,
                    mask,
                    EGL10.EGL_NONE);
        }
    }

    /**
     * Opens a context and makes it current on this thread.
     *
     * @throws NoOpenGl with the reason where there is none
     */
    public static OffscreenContext open(ContextProfile profile) {
        try {
            return create(profile);
        } catch (LinkageError | IllegalStateException e) {
            throw new NoOpenGl(e);
        }
    }

    private static OffscreenContext create(ContextProfile profile) {
        try (var stack = MemoryStack.stackPush()) {
            long display = display(stack.pointers(EGL10.EGL_NONE));
            require(display != EGL10.EGL_NO_DISPLAY, "EGL has no display without a surface");
            require(
                    EGL10.eglInitialize(display, stack.ints(0), stack.ints(0)),
                    "EGL does not start");
            EGL.createDisplayCapabilities(display);
            require(EGL12.eglBindAPI(EGL14.EGL_OPENGL_API), "EGL has no OpenGL");
            var config = stack.callocPointer(1);
            var found = stack.ints(0);
            EGL10.eglChooseConfig(display, wanted(stack), config, found);
            require(found.get(0) > 0, "EGL has no configuration for OpenGL");
            long context =
                    EGL10.eglCreateContext(
                            display,
                            config.get(0),
                            EGL10.EGL_NO_CONTEXT,
                            profile.attributes(stack));
            require(
                    context != EGL10.EGL_NO_CONTEXT,
                    "no context of OpenGL %d.%d".formatted(profile.major, profile.minor));
            EGL10.eglMakeCurrent(display, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_SURFACE, context);
            return new OffscreenContext(display, context, GL.createCapabilities());
        }
    }

    private static IntBuffer wanted(MemoryStack stack) {
        return stack.ints(
                EGL10.EGL_SURFACE_TYPE,
                EGL10.EGL_PBUFFER_BIT,
                EGL12.EGL_RENDERABLE_TYPE,
                EGL14.EGL_OPENGL_BIT,
                EGL10.EGL_NONE);
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

    /** Makes the context current on this thread, where it must not be current elsewhere. */
    public void take() {
        EGL10.eglMakeCurrent(display, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_SURFACE, context);
        GL.setCapabilities(capabilities);
    }

    /** Leaves this thread without a context. */
    public void leave() {
        GL.setCapabilities(null);
        EGL10.eglMakeCurrent(
                display, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_SURFACE, EGL10.EGL_NO_CONTEXT);
    }

    /** Ends the context; the display is every context's of this program and stays. */
    @Override
    public void close() {
        leave();
        EGL10.eglDestroyContext(display, context);
    }
}
