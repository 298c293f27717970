package rasterlab.tests.bench.pipeline;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import java.util.function.Function;
import rasterlab.engine.pipeline.triangle.DepthRaster;
import rasterlab.engine.pipeline.triangle.Surface;
import rasterlab.engine.pipeline.triangle.TrianglePipeline;
import rasterlab.tests.bench.BenchWords;

/** A million triangles in a process of its own whose heap is small. */
final class HeapBench {
    private static final String HEAP = "-Xmx600m";
    private static final TorusScene SCENE = new TorusScene(1_000_000, 1920, 1080);

    private HeapBench() {}

    /** Makes the mesh and draws it, with all that belongs to it in the heap. */
    public static void main(String[] none) {
        try (var pipeline = new TrianglePipeline()) {
            var mesh = SCENE.mesh();
            var out = new DepthRaster(SCENE.width(), SCENE.height());
            for (TorusLook look : TorusLook.values()) {
                Surface surface = look.surface(SCENE);
                for (int k = 0; k < 3; k++)
                    pipeline.drawOn(0, mesh, SCENE.view(), surface, out, () -> false);
            }
        }
    }

    static Row run() {
        return new Row(
                SCENE + ", every look, in a heap of 600 MB",
                "–",
                "–",
                Double.NaN,
                0,
                note(ended()));
    }

    private static Function<BenchWords, String> note(boolean drawn) {
        return words -> words.text(drawn ? "note.drawn" : "note.drawn.not");
    }

    private static boolean ended() {
        try {
            return new OwnProcess(List.of(HEAP), HeapBench.class, List.of())
                    .run(System.out, System.err);
        } catch (IOException e) {
            throw new UncheckedIOException("no process for the small heap", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }
}
