package rasterlab.app.opengl.call;

import java.nio.ByteBuffer;
import java.util.List;
import org.lwjgl.opengl.GL11;
import org.lwjgl.system.MemoryUtil;
import rasterlab.app.opengl.context.GlReport;
import rasterlab.app.opengl.state.GlFrame;
import rasterlab.engine.raster.Raster;

/** Runs calls in the current context and reads pictures back. */
public final class GlPainter {
    private GlPainter() {}

    /**
     * Draws a frame.
     *
     * @throws IllegalStateException with OpenGL's own error
     */
    public static void draw(List<GlCall> calls, GlObjects objects) {
        GlReport.error();
        for (GlCall call : calls) call.action().accept(objects);
        int error = GlReport.error();
        if (error != 0)
            throw new IllegalStateException("OpenGL notes the error 0x%X".formatted(error));
    }

    /** The picture of that size in the buffer that is drawn into. */
    public static Raster read(GlFrame frame) {
        int width = frame.width();
        int height = frame.height();
        var raster = new Raster(width, height);
        ByteBuffer bytes = MemoryUtil.memAlloc(4 * width * height);
        try {
            GL11.glPixelStorei(GL11.GL_PACK_ALIGNMENT, 1);
            GL11.glReadPixels(0, 0, width, height, GL11.GL_RGBA, GL11.GL_UNSIGNED_BYTE, bytes);
            turnOver(bytes, raster);
        } finally {
            MemoryUtil.memFree(bytes);
        }
        return raster;
    }

    /** OpenGL's first row is the lowest one. */
    private static void turnOver(ByteBuffer bytes, Raster raster) {
        int width = raster.width();
        int[] argb = raster.argb();
        for (int y = 0; y < raster.height(); y++)
            for (int x = 0, at = 4 * (raster.height() - 1 - y) * width; x < width; x++, at += 4)
                argb[y * width + x] =
                        0xFF000000
                                | (bytes.get(at) & 255) << 16
                                | (bytes.get(at + 1) & 255) << 8
                                | bytes.get(at + 2) & 255;
    }
}
