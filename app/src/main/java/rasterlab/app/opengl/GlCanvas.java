package rasterlab.app.opengl;

import java.awt.EventQueue;
import java.awt.Graphics;
import java.awt.event.ComponentEvent;
import java.util.Optional;
import org.lwjgl.opengl.GL;
import org.lwjgl.opengl.GLCapabilities;
import org.lwjgl.opengl.GLX;
import org.lwjgl.opengl.awt.AWTGLCanvas;
import org.lwjgl.opengl.awt.GLData;
import org.lwjgl.opengl.awt.PlatformLinuxGLCanvas;
import rasterlab.app.opengl.call.FrameCalls;
import rasterlab.app.opengl.call.GlObjects;
import rasterlab.app.opengl.call.GlPainter;
import rasterlab.app.opengl.context.GlReport;
import rasterlab.app.opengl.context.NoOpenGl;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.engine.raster.Raster;

/**
 * OpenGL's window in the lab: draws the model's frame and brings the picture back to the model.
 *
 * <p>Its context lives as long as the window has a place on the screen; taken out and put in again,
 * or after an error, it makes a new one with new objects. Used on the event thread, where making a
 * context, asking it what it can and drawing are events of their own; made on any thread. A thread
 * of its own would gain nothing: on X, who draws into a window of AWT holds AWT's one lock.
 */
class GlCanvas extends AWTGLCanvas {
    private static final long serialVersionUID = 1L;

    private final transient OpenGlLabModel model;
    private final transient Runnable failed;
    private transient Optional<GLCapabilities> capabilities = Optional.empty();
    private transient GlObjects objects = new GlObjects();
    private transient Optional<GlReport> report = Optional.empty();
    private transient Optional<Finished> finished = Optional.empty();
    private boolean asked;
    private boolean failedBefore;

    /** Whether nothing is drawn any more, since there is no OpenGL or it failed twice. */
    private boolean ended;

    private record Finished(GlFrame frame, Raster picture) {}

    /**
     * @param failed told once when OpenGL cannot draw here; the canvas then is of no use
     */
    GlCanvas(OpenGlLabModel model, Runnable failed) {
        super(wanted());
        this.model = model;
        this.failed = failed;
        setName("opengl.canvas");
        setFocusable(false);
    }

    /**
     * The wish for a version that still has everything since 1.0, which is made when none is named.
     */
    private static GLData wanted() {
        var data = new GLData();
        data.depthSize = 24;
        data.swapInterval = 0;
        return data;
    }

    /** Draws soon if the model has another frame than the last one drawn. */
    void drawIfStale() {
        if (!model.frame().equals(finished.map(Finished::frame))) ask();
    }

    /** Draws soon; many wishes become one picture. */
    void ask() {
        if (asked) return;
        asked = true;
        EventQueue.invokeLater(this::draw);
    }

    /** Shows the last picture, drawn elsewhere, until there is one of its own. */
    @Override
    public void paint(Graphics g) {
        if (capabilities.isEmpty())
            model.state()
                    .pictures()
                    .openGl()
                    .ifPresent(
                            last -> g.drawImage(last.image(), 0, 0, getWidth(), getHeight(), null));
        draw();
    }

    @Override
    public void update(Graphics g) {
        paint(g);
    }

    private void draw() {
        asked = false;
        if (ended) return;
        if (!isShowing() || getWidth() < 1 || getHeight() < 1 || model.frame().isEmpty()) return;
        try {
            if (step()) return;
            finished.ifPresent(
                    done -> model.drawn(done.frame(), done.picture(), report.orElseThrow()));
            failedBefore = false;
        } catch (RuntimeException | LinkageError | AssertionError e) {
            forget();
            ended = failedBefore || e instanceof NoOpenGl;
            if (ended) failed.run();
            else ask();
            failedBefore = true;
        }
    }

    /** The next step to a picture; whether there are more, which are then events of their own. */
    private boolean step() {
        if (!hasContext()) runInContext(() -> {});
        else if (capabilities.isEmpty()) runInContext(this::initGL);
        else {
            render();
            return false;
        }
        ask();
        return true;
    }

    @Override
    public void initGL() {
        initCalled = true;
        capabilities = Optional.of(GL.createCapabilities());
        objects = new GlObjects();
        report = Optional.of(GlReport.ofCurrent());
    }

    @Override
    public void paintGL() {
        GL.setCapabilities(capabilities.orElseThrow());
        GlFrame frame = model.frame().orElseThrow();
        GlPainter.draw(FrameCalls.of(frame), objects);
        Raster picture = GlPainter.read(frame);
        swapBuffers();
        finished = Optional.of(new Finished(frame, picture));
    }

    /** Whether there is a context now. */
    boolean hasContext() {
        return context != 0;
    }

    /**
     * Sizes told late, when the window is gone, would fail where the scale of its screen is asked.
     */
    @Override
    protected void processComponentEvent(ComponentEvent event) {
        if (getGraphicsConfiguration() != null) super.processComponentEvent(event);
    }

    /** Gives textures, lists and the context back while the window is still there. */
    @Override
    public void removeNotify() {
        if (context != 0 && capabilities.isPresent())
            runInContext(
                    () -> {
                        GL.setCapabilities(capabilities.get());
                        objects.delete();
                    });
        forget();
        super.removeNotify();
    }

    /** Ends the context, so that the next picture makes a new one. */
    private void forget() {
        long old = context;
        context = 0;
        initCalled = false;
        capabilities = Optional.empty();
        objects = new GlObjects();
        GL.setCapabilities(null);
        if (old != 0) destroy(old);
    }

    /** Gives the system back what the context holds. */
    void destroy(long ended) {
        // The binding for X leaves contexts to the program.
        if (platformCanvas instanceof PlatformLinuxGLCanvas linux)
            GLX.glXDestroyContext(linux.display, ended);
        else platformCanvas.deleteContext(ended);
    }
}
