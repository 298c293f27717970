package rasterlab.tests.bench.pipeline;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.fast.TrianglePipeline;

/** What there is to measure, in the table's order. */
final class PipelineJobs {
    private static final int[][] SIZES = {{1280, 720}, {1920, 1080}};
    private static final int[] TRIANGLES = {10_000, 100_000, 1_000_000};

    private final InterleavedTimes.Length length;
    private final List<Way> ways;
    private final List<Job> all = new ArrayList<>();

    /**
     * @param openGl whether it needs a context of OpenGL
     * @param options of Java's own for its process
     */
    record Job(String work, boolean openGl, List<String> options, Supplier<List<Row>> rows) {}

    private PipelineJobs(boolean quick, List<Way> ways) {
        length = InterleavedTimes.Length.of(quick);
        this.ways = ways;
        addTori(Runtime.getRuntime().availableProcessors());
        addFills();
        addOwn();
    }

    /**
     * @param ways may be empty where nothing is measured
     */
    static List<Job> all(boolean quick, List<Way> ways) {
        return new PipelineJobs(quick, ways).all;
    }

    private void addTori(int cores) {
        var torus = new TorusBench(length);
        for (TorusLook look : TorusLook.values())
            for (int triangles : TRIANGLES)
                for (int[] size : SIZES) {
                    var scene = new TorusScene(triangles, size[0], size[1]);
                    double goal = look.goal(cores);
                    String work = scene + ", " + look.text();
                    addOpenGl(work, () -> torus.run(scene, look, goal, ways));
                }
    }

    private void addFills() {
        var fill = new FillBench(length);
        double[][] fills = {{10, 2.3, 2}, {50, 2.5, 1.5}, {200, 3.5, 1.5}};
        for (double[] each : fills) {
            int side = (int) each[0];
            var goals = Map.of(Lanes.EIGHT, each[1], Lanes.ONE, each[2]);
            String work = "triangles of " + side + " px with depth";
            addOpenGl(work, () -> fill.run(side, goals, ways));
        }
    }

    private void addOwn() {
        var own = new OwnBench(length);
        Supplier<TrianglePipeline> pipeline = () -> ways.get(0).pipeline();
        add("threads", () -> own.threads(pipeline.get()));
        add("clear", () -> own.clear(pipeline.get()));
        add("present a frame", own::present);
        add("memory limit", () -> own.memory(pipeline.get()));
        Supplier<List<Row>> million = () -> List.of(HeapBench.draw(pipeline.get()));
        all.add(new Job("heap", false, HeapBench.OPTIONS, million));
        add("Java2D", () -> own.java2d(pipeline.get()));
        add("the page of the course", own::page);
    }

    private void addOpenGl(String work, Supplier<List<Row>> rows) {
        all.add(new Job(work, true, List.of(), rows));
    }

    private void add(String work, Supplier<Row> row) {
        all.add(new Job(work, false, List.of(), () -> List.of(row.get())));
    }
}
