package rasterlab.tests.bench.pipeline;

import java.util.List;
import rasterlab.engine.pipeline.fast.DepthRaster;
import rasterlab.engine.pipeline.fast.Surface;
import rasterlab.engine.pipeline.fast.TrianglePipeline;

/** A million triangles in a process whose heap is small. */
final class HeapBench {
    static final List<String> OPTIONS = List.of("-Xmx600m");
    private static final TorusScene SCENE = new TorusScene(1_000_000, 1920, 1080);

    private HeapBench() {}

    /**
     * Makes the mesh and draws it, with all that belongs to it in the heap.
     *
     * @throws OutOfMemoryError if that is more than the heap has
     */
    static Row draw(TrianglePipeline pipeline) {
        var mesh = SCENE.mesh();
        var out = new DepthRaster(SCENE.width(), SCENE.height());
        for (TorusLook look : TorusLook.values()) {
            Surface surface = look.surface(SCENE);
            for (int k = 0; k < 3; k++)
                pipeline.drawOn(0, mesh, SCENE.view(), surface, out, () -> false);
        }
        return new Row(
                SCENE + ", every look, in a heap of 600 MB",
                "–",
                "–",
                Double.NaN,
                0,
                words -> words.text("note.drawn"));
    }
}
