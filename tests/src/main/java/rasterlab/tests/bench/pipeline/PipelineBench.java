package rasterlab.tests.bench.pipeline;

import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import java.util.Optional;
import org.lwjgl.opengl.GL11C;
import rasterlab.app.language.Complaints;
import rasterlab.app.opengl.context.NoOpenGl;
import rasterlab.app.opengl.context.OffscreenContext;
import rasterlab.tests.bench.language.BenchWords;
import rasterlab.tests.bench.pipeline.PipelineJobs.Job;

/**
 * The pipeline's goals: each measured in a process of its own and printed as soon as it is.
 *
 * <p>On one core (LP_NUM_THREADS=0 taskset -c 1 ./lab bench pipeline) the goals are those of one
 * core, and the figures the steadiest.
 */
public final class PipelineBench {
    private final boolean quick;
    private final String only;
    private final BenchWords words;
    private final PrintStream out;
    private final PrintStream err;

    /**
     * @param only what a line's work must contain
     * @param err for what goes wrong with a line
     */
    public PipelineBench(
            boolean quick, String only, BenchWords words, PrintStream out, PrintStream err) {
        this.quick = quick;
        this.only = only;
        this.words = words;
        this.out = out;
        this.err = err;
    }

    /**
     * Prints the table, without OpenGL's lines where there is no OpenGL.
     *
     * @return whether all was measured that can be here
     */
    public boolean run() throws IOException, InterruptedException {
        String missing = tellMachine();
        out.println(words.head("head.pipeline"));
        boolean measured = true;
        List<Job> jobs = PipelineJobs.all(quick);
        for (int k = 0; k < jobs.size(); k++)
            if (jobs.get(k).work().contains(only)) measured &= measure(k, jobs.get(k), missing);
        return measured;
    }

    /** Prints the machine; returns what is missing for OpenGL, empty where it is there. */
    @SuppressWarnings("try") // the context is current while it is open
    private String tellMachine() {
        String missing = "";
        String gl;
        try (var context = OffscreenContext.open(OffscreenContext.ContextProfile.CORE)) {
            gl = "OpenGL: " + drawing();
        } catch (NoOpenGl e) {
            missing =
                    words.text(
                            "no-opengl", Complaints.saidToTypist(words.language(), e.getMessage()));
            gl = missing;
        }
        out.println(words.machine() + "; " + gl);
        return missing;
    }

    /** The name of the program that draws, such as llvmpipe. */
    private static String drawing() {
        return Optional.ofNullable(GL11C.glGetString(GL11C.GL_RENDERER)).orElse("unnamed")
                + ", "
                + GL11C.glGetString(GL11C.GL_VERSION);
    }

    private boolean measure(int number, Job job, String missing)
            throws IOException, InterruptedException {
        if (job.openGl() && !missing.isEmpty()) {
            out.println(Row.without(job.work(), missing).line(words));
            return true;
        }
        out.flush();
        int code = JobProcess.run(number, quick, words.language(), out, err);
        if (code != 0) out.println(Row.without(job.work(), failed(code)).line(words));
        return code == 0;
    }

    private String failed(int code) {
        return code == OwnProcess.TOO_LONG
                ? words.text("note.late", String.valueOf(OwnProcess.LIMIT_MINUTES))
                : words.text("note.failed", String.valueOf(code));
    }

    /** The measurements, in the table's order. */
    public static List<String> works() {
        return PipelineJobs.all(true).stream().map(Job::work).toList();
    }
}
