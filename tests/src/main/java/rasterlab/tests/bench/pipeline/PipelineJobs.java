package rasterlab.tests.bench.pipeline;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import java.util.function.Supplier;
import rasterlab.engine.pipeline.fast.TrianglePipeline;

/** The measurements, in the table's order. */
final class PipelineJobs {
    private static final int[][] SIZES = {{1280, 720}, {1920, 1080}};
    private static final int[] TRIANGLES = {10_000, 100_000, 1_000_000};

    private final InterleavedTimes.Length length;
    private final List<Job> all = new ArrayList<>();

    /**
     * @param openGl whether it needs a context of OpenGL
     * @param options of Java's own for its process
     */
    record Job(String work, boolean openGl, List<String> options, Supplier<Row> row) {}

    private PipelineJobs(boolean quick) {
        length = InterleavedTimes.Length.of(quick);
        addTori(Runtime.getRuntime().availableProcessors());
        addFills();
        addOwn();
    }

    static List<Job> all(boolean quick) {
        return new PipelineJobs(quick).all;
    }

    private void addTori(int cores) {
        var torus = new TorusBench(length);
        for (TorusLook look : TorusLook.values())
            for (int triangles : TRIANGLES)
                for (int[] size : SIZES) {
                    var scene = new TorusScene(triangles, size[0], size[1]);
                    double goal = look.goal(cores);
                    String work = scene + ", " + look.text();
                    all.add(new Job(work, true, List.of(), () -> torus.run(scene, look, goal)));
                }
    }

    private void addFills() {
        var fill = new FillBench(length);
        double[][] fills = {{10, 2}, {50, 1.5}, {200, 1.5}};
        for (double[] each : fills) {
            int side = (int) each[0];
            String work = "triangles of " + side + " px with depth";
            addOpenGl(work, pipeline -> fill.run(side, each[1], pipeline));
        }
    }

    private void addOwn() {
        var own = new OwnBench(length);
        add("threads", own::threads);
        add("clear", own::clear);
        add("present a frame", own::present);
        add("memory limit", own::memory);
        all.add(new Job("heap", false, HeapBench.OPTIONS, HeapBench::draw));
        add("Java2D", own::java2d);
        add("the page of the course", own::page);
    }

    private void addOpenGl(String work, Function<TrianglePipeline, Row> row) {
        all.add(new Job(work, true, List.of(), () -> users(row)));
    }

    private void add(String work, Function<TrianglePipeline, Row> row) {
        add(work, () -> users(row));
    }

    private void add(String work, Supplier<Row> row) {
        all.add(new Job(work, false, List.of(), row));
    }

    /** Measures the pipeline that a user's call has. */
    private static Row users(Function<TrianglePipeline, Row> row) {
        try (var pipeline = new TrianglePipeline()) {
            return row.apply(pipeline);
        }
    }
}
