package rasterlab.app.cli.render;

import rasterlab.app.outcome.Complaint;
import rasterlab.engine.pipeline.Look;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.ShadingMethod;

/** Refuses pictures that Java has no memory for, before they are begun. */
final class RenderMemory {
    private static final int MEBIBYTE = 1 << 20;

    private RenderMemory() {}

    /**
     * @param pictures how many more of the size are held beside the one that is made
     * @throws Complaint with what is needed and what there is
     */
    static void require(RenderRequest request, int pictures) {
        Look look = request.look();
        int planes = 2 + pictures;
        if (look.shading() == ShadingMethod.WIRE) planes++;
        if (look.stereo().isPresent()) planes += 2;
        long needed = (long) request.width() * request.height() * Integer.BYTES * planes;
        Runtime java = Runtime.getRuntime();
        long free = java.maxMemory() - java.totalMemory() + java.freeMemory();
        if (needed > free)
            throw Complaint.gaveUp(
                    "a picture of %d×%d needs about %d MiB, and Java has %d here; give a smaller"
                                    .formatted(
                                            request.width(),
                                            request.height(),
                                            needed / MEBIBYTE,
                                            free / MEBIBYTE)
                            + " --size, or more with JAVA_TOOL_OPTIONS=-Xmx4g");
    }
}
