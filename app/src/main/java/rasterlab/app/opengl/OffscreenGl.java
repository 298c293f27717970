package rasterlab.app.opengl;

import java.util.Optional;
import rasterlab.app.opengl.call.FrameCalls;
import rasterlab.app.opengl.call.GlObjects;
import rasterlab.app.opengl.call.GlPainter;
import rasterlab.app.opengl.context.GlReport;
import rasterlab.app.opengl.context.NoOpenGl;
import rasterlab.app.opengl.context.OffscreenContext;
import rasterlab.app.opengl.context.OffscreenTarget;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.engine.raster.Raster;

/** OpenGL without a window, for pictures of the lab where no window is; on any thread. */
final class OffscreenGl implements AutoCloseable {
    private final GlObjects objects = new GlObjects();
    private Optional<OffscreenContext> context = Optional.empty();

    /** A picture with what OpenGL says of itself. */
    record OffscreenPicture(Raster picture, GlReport report) {}

    /**
     * @throws NoOpenGl with the reason where there is none
     */
    synchronized OffscreenPicture draw(GlFrame frame) {
        if (context.isEmpty())
            context = Optional.of(OffscreenContext.open(OffscreenContext.ContextProfile.OLD));
        context.get().take();
        try {
            GlReport report = GlReport.ofCurrent();
            var target = new OffscreenTarget(frame.width(), frame.height());
            try {
                GlPainter.draw(FrameCalls.of(frame), objects);
                return new OffscreenPicture(GlPainter.read(frame), report);
            } finally {
                target.close();
            }
        } finally {
            context.get().leave();
        }
    }

    @Override
    public synchronized void close() {
        context.ifPresent(
                open -> {
                    open.take();
                    objects.delete();
                    open.close();
                });
        context = Optional.empty();
    }
}
