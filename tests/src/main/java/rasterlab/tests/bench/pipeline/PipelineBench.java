package rasterlab.tests.bench.pipeline;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import rasterlab.app.opengl.context.NoOpenGl;
import rasterlab.app.opengl.context.OffscreenContext;
import rasterlab.engine.pipeline.triangle.TrianglePipeline;

/**
 * The pipeline's goals: one line each, printed as soon as it is measured.
 *
 * <p>On one core (LP_NUM_THREADS=0 taskset -c 1 ./lab bench pipeline) the goals are those of one
 * core, and the figures the steadiest.
 */
public final class PipelineBench {
    private static final int[][] SIZES = {{1280, 720}, {1920, 1080}};
    private static final int[] TRIANGLES = {10_000, 100_000, 1_000_000};

    private final boolean quick;
    private final String only;
    private final PrintStream out;

    /**
     * @param only what a line's work must contain
     */
    public PipelineBench(boolean quick, String only, PrintStream out) {
        this.quick = quick;
        this.only = only;
        this.out = out;
    }

    private record Job(String work, Supplier<Row> row) {}

    /** Prints the table, without OpenGL's lines where there is no OpenGL. */
    public void run() {
        int cores = Runtime.getRuntime().availableProcessors();
        try (var pipeline = new TrianglePipeline()) {
            String missing = "";
            try (var gl = OffscreenContext.open(OffscreenContext.Profile.CORE)) {
                out.println(machine(cores) + "; OpenGL: " + gl.renderer());
                print(openGlJobs(pipeline, cores));
            } catch (NoOpenGl e) {
                missing = "no OpenGL here: " + e.getMessage();
                out.println(machine(cores) + "; " + missing);
                out.println(Row.HEAD);
                for (Job job : openGlJobs(pipeline, cores))
                    out.println(Row.without(job.work, missing));
            }
            printRows(ownJobs(pipeline));
        }
    }

    private static String machine(int cores) {
        return "%s %s, %d cores, Java %s"
                .formatted(
                        System.getProperty("os.name"),
                        System.getProperty("os.arch"),
                        cores,
                        Runtime.version());
    }

    private List<Job> openGlJobs(TrianglePipeline pipeline, int cores) {
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
                                    () -> torus.run(scene, look, goal, pipeline)));
                }
        double[][] fills = {{10, 2}, {50, 1.5}, {200, 1.5}};
        for (double[] each : fills)
            jobs.add(
                    new Job(
                            "triangles of " + (int) each[0] + " px with depth",
                            () -> fill.run((int) each[0], each[1], pipeline)));
        return wanted(jobs);
    }

    private List<Job> ownJobs(TrianglePipeline pipeline) {
        var own = new OwnBench(quick);
        return wanted(
                List.of(
                        new Job("threads", () -> own.threads(pipeline)),
                        new Job("clear", () -> own.clear(pipeline)),
                        new Job("present a frame", () -> own.present()),
                        new Job("memory limit", () -> own.memory(pipeline)),
                        new Job("heap", HeapBench::run),
                        new Job("Java2D", () -> own.java2d(pipeline))));
    }

    private List<Job> wanted(List<Job> jobs) {
        return jobs.stream().filter(job -> job.work.contains(only)).toList();
    }

    private void print(List<Job> jobs) {
        out.println(Row.HEAD);
        printRows(jobs);
    }

    private void printRows(List<Job> jobs) {
        for (Job job : jobs) out.println(job.row.get());
    }
}
