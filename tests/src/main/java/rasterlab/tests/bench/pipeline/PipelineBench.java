package rasterlab.tests.bench.pipeline;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import java.util.stream.Stream;
import rasterlab.app.language.Complaints;
import rasterlab.app.opengl.context.NoOpenGl;
import rasterlab.app.opengl.context.OffscreenContext;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.triangle.TrianglePipeline;
import rasterlab.tests.bench.BenchWords;

/**
 * The pipeline's goals: one line each, printed as soon as it is measured.
 *
 * <p>Where the Vector API is there, each is measured with it and without.
 *
 * <p>On one core (LP_NUM_THREADS=0 taskset -c 1 ./lab bench pipeline) the goals are those of one
 * core, and the figures the steadiest.
 */
public final class PipelineBench {
    private static final int[][] SIZES = {{1280, 720}, {1920, 1080}};
    private static final int[] TRIANGLES = {10_000, 100_000, 1_000_000};

    private final boolean quick;
    private final String only;
    private final BenchWords words;
    private final PrintStream out;

    /**
     * @param only what a line's work must contain
     */
    public PipelineBench(boolean quick, String only, BenchWords words, PrintStream out) {
        this.quick = quick;
        this.only = only;
        this.words = words;
        this.out = out;
    }

    private record Job(String work, Supplier<List<Row>> rows) {}

    /** Prints the table, without OpenGL's lines where there is no OpenGL. */
    public void run() {
        int cores = Runtime.getRuntime().availableProcessors();
        List<Way> ways = Way.all();
        try {
            out.println(Way.names(words));
            String missing = "";
            try (var gl = OffscreenContext.open(OffscreenContext.Profile.CORE)) {
                out.println(words.machine() + "; OpenGL: " + gl.renderer());
                print(wanted(openGlJobs(quick, ways, cores)));
            } catch (NoOpenGl e) {
                missing =
                        words.text(
                                "no-opengl",
                                Complaints.saidToTypist(words.language(), e.getMessage()));
                out.println(words.machine() + "; " + missing);
                out.println(words.head("head.pipeline"));
                for (Job job : wanted(openGlJobs(quick, ways, cores)))
                    out.println(Row.without(job.work, missing).line(words));
            }
            printRows(wanted(ownJobs(quick, ways)));
        } finally {
            ways.forEach(Way::close);
        }
    }

    /** What there is to measure, in the table's order. */
    public static List<String> works() {
        List<Way> none = List.of();
        return Stream.concat(openGlJobs(true, none, 1).stream(), ownJobs(true, none).stream())
                .map(Job::work)
                .toList();
    }

    private static List<Job> openGlJobs(boolean quick, List<Way> ways, int cores) {
        var torus = new TorusBench(quick);
        var fill = new FillBench(quick);
        var jobs = new ArrayList<Job>();
        for (TorusLook look : TorusLook.values())
            for (int triangles : TRIANGLES)
                for (int[] size : SIZES) {
                    var scene = new TorusScene(triangles, size[0], size[1]);
                    double goal = look.goal(cores);
                    jobs.add(
                            new Job(
                                    scene + ", " + look.text(),
                                    () -> torus.run(scene, look, goal, ways)));
                }
        double[][] fills = {{10, 2.3, 2}, {50, 2.5, 1.5}, {200, 3.5, 1.5}};
        for (double[] each : fills) {
            var goals = Map.of(Lanes.EIGHT, each[1], Lanes.ONE, each[2]);
            jobs.add(
                    new Job(
                            "triangles of " + (int) each[0] + " px with depth",
                            () -> fill.run((int) each[0], goals, ways)));
        }
        return jobs;
    }

    private static List<Job> ownJobs(boolean quick, List<Way> ways) {
        var own = new OwnBench(quick);
        Supplier<TrianglePipeline> pipeline = () -> ways.get(0).pipeline();
        return List.of(
                new Job("threads", () -> List.of(own.threads(pipeline.get()))),
                new Job("clear", () -> List.of(own.clear(pipeline.get()))),
                new Job("present a frame", () -> List.of(own.present())),
                new Job("memory limit", () -> List.of(own.memory(pipeline.get()))),
                new Job("heap", () -> List.of(HeapBench.run())),
                new Job("Java2D", () -> List.of(own.java2d(pipeline.get()))));
    }

    private List<Job> wanted(List<Job> jobs) {
        return jobs.stream().filter(job -> job.work.contains(only)).toList();
    }

    private void print(List<Job> jobs) {
        out.println(words.head("head.pipeline"));
        printRows(jobs);
    }

    private void printRows(List<Job> jobs) {
        for (Job job : jobs) for (Row row : job.rows.get()) out.println(row.line(words));
    }
}
