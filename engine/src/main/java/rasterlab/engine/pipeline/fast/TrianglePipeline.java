package rasterlab.engine.pipeline.fast;

import java.util.Arrays;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.TriangleMesh;

/**
 * Draws triangle meshes by depth, on several threads, the same picture bit for bit on any number.
 *
 * <p>One frame at a time: vertices by blocks, triangles by chunks, what triangles in sight want of
 * their vertices by blocks, pixels by bands of 32 rows, the fullest first; each stage begins when
 * the one before has ended; where a triangle may be clipped, which needs all of its vertices, the
 * second comes third. A chunk is sorted into bands by one thread and a band drawn by one thread in
 * the mesh's order, so no result depends on which thread was first. Once each thread has drawn a
 * band nothing is allocated until a larger mesh or picture comes.
 */
public final class TrianglePipeline implements AutoCloseable {
    private static final float[] NOT_KEPT = {};

    private final WorkerTeam team;
    private final Worker[] workers;
    private final FrameState frame = new FrameState();
    private final WorkerTeam.SharedTask vertexTask = this::vertices;
    private final WorkerTeam.SharedTask attributeTask = this::attributes;
    private final WorkerTeam.SharedTask binTask = this::bin;
    private final WorkerTeam.SharedTask bandTask = this::band;
    private final BandOrder order = new BandOrder();
    private TriangleChunk[] chunks = new TriangleChunk[0];
    private int chunkCount;
    private BooleanSupplier cancelled;

    /** The working memory of each thread. */
    private record Worker(VertexStage vertices, Binner binner, BandStage bands) {}

    /** A pipeline that works on all cores. */
    public TrianglePipeline() {
        this(Math.min(WorkerTeam.MOST, Runtime.getRuntime().availableProcessors()));
    }

    /**
     * @param threads 1 to 256, the caller's included
     */
    public TrianglePipeline(int threads) {
        WorkerTeam.checkSize(threads);
        workers = new Worker[threads];
        for (int k = 0; k < threads; k++)
            workers[k] = new Worker(new VertexStage(), new Binner(), new BandStage());
        team = new WorkerTeam(threads);
    }

    /**
     * Draws over what the picture holds.
     *
     * @param cancelled asked by all threads, often; a picture then is half drawn
     * @throws CancellationException soon after {@code cancelled} says true
     * @throws IllegalArgumentException where the surface wants what the mesh has not
     */
    public void draw(
            TriangleMesh mesh,
            TriangleView view,
            Surface surface,
            DepthRaster out,
            BooleanSupplier cancelled) {
        run(false, 0, mesh, view, surface, out.raster(), out.depth(), cancelled);
    }

    /** Draws on a picture that is given one colour 0xAARRGGBB at the far plane first. */
    public void drawOn(
            int background,
            TriangleMesh mesh,
            TriangleView view,
            Surface surface,
            DepthRaster out,
            BooleanSupplier cancelled) {
        run(true, background, mesh, view, surface, out.raster(), out.depth(), cancelled);
    }

    /** Draws where nobody asks for depths afterwards: they last as long as their band. */
    public void drawOn(
            int background,
            TriangleMesh mesh,
            TriangleView view,
            Surface surface,
            Raster out,
            BooleanSupplier cancelled) {
        run(true, background, mesh, view, surface, out, NOT_KEPT, cancelled);
    }

    private synchronized void run(
            boolean clears,
            int background,
            TriangleMesh mesh,
            TriangleView view,
            Surface surface,
            Raster out,
            float[] depth,
            BooleanSupplier cancelled) {
        this.cancelled = cancelled;
        frame.clears = clears;
        frame.background = background;
        try {
            frame.begin(mesh, view, surface, out, depth);
            runStages(mesh);
        } finally {
            this.cancelled = null;
            frame.end();
            for (Worker worker : workers) worker.bands.end();
        }
    }

    private void runStages(TriangleMesh mesh) {
        chunkCount = Binner.chunks(mesh.triangleCount());
        int had = chunks.length;
        if (had < chunkCount) {
            chunks = Arrays.copyOf(chunks, chunkCount);
            for (int k = had; k < chunkCount; k++) chunks[k] = new TriangleChunk();
        }
        int blocks = VertexStage.blocks(mesh);
        team.run(vertexTask, blocks);
        Arrays.fill(frame.vertices.needed, frame.clips);
        if (frame.clips) team.run(attributeTask, blocks);
        team.run(binTask, chunkCount);
        if (!frame.clips) team.run(attributeTask, blocks);
        order.find(chunks, chunkCount, frame.bands);
        team.run(bandTask, frame.bands);
    }

    private void vertices(int block, int worker) {
        checkCancelled();
        workers[worker].vertices.place(frame, block);
    }

    private void attributes(int block, int worker) {
        checkCancelled();
        workers[worker].vertices.fill(frame, block);
    }

    private void bin(int chunk, int worker) {
        checkCancelled();
        workers[worker].binner.run(frame, chunk, chunks[chunk]);
    }

    private void band(int before, int worker) {
        checkCancelled();
        workers[worker].bands.run(frame, order.band(before), chunks, chunkCount);
    }

    private void checkCancelled() {
        if (cancelled.getAsBoolean()) throw new CancellationException("the picture is cancelled");
    }

    /** Ends the threads; nothing can be drawn afterwards. */
    @Override
    public void close() {
        team.close();
    }
}
