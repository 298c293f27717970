package rasterlab.tests.bench.pipeline;

import java.util.List;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.Renderer;
import rasterlab.engine.raster.Raster;

/** A million triangles in a process whose heap is small. */
final class HeapBench {
    static final List<String> OPTIONS = List.of("-Xmx600m");
    private static final TorusScene SCENE = new TorusScene(1_000_000, 1920, 1080);

    private HeapBench() {}

    /**
     * Makes the scenes and draws them, with all that belongs to it in the heap.
     *
     * @throws OutOfMemoryError if that is more than the heap has
     */
    static Row draw() {
        var out = new Raster(SCENE.width(), SCENE.height());
        try (var renderer = new Renderer()) {
            for (TorusLook look : TorusLook.values()) {
                RenderRequest request = SCENE.request(look);
                for (int k = 0; k < 3; k++) renderer.render(request, out, () -> false);
            }
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
