package rasterlab.tests.bench.pipeline;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import rasterlab.app.language.Language;
import rasterlab.app.opengl.context.OffscreenContext;
import rasterlab.tests.bench.language.BenchWords;
import rasterlab.tests.bench.pipeline.PipelineJobs.Job;

/**
 * Measures one job in a process of its own.
 *
 * <p>What the compiler has learnt from other jobs, and how much memory OpenGL has kept of theirs,
 * would change the times by a fifth and more.
 */
final class JobProcess {
    private JobProcess() {}

    /**
     * Hands on the lines of a job of the list, and what its process complained of.
     *
     * @return the exit code, as {@link OwnProcess#run} has it
     */
    static int run(int number, boolean quick, Language language, PrintStream out, PrintStream err)
            throws IOException, InterruptedException {
        var arguments =
                List.of(String.valueOf(number), String.valueOf(quick), String.valueOf(language));
        Job job = PipelineJobs.all(quick).get(number);
        return new OwnProcess(job.options(), JobProcess.class, arguments).run(out, err);
    }

    /** Prints the job's lines; the context ends with the process. */
    public static void main(String[] arguments) {
        boolean quick = Boolean.parseBoolean(arguments[1]);
        var words = new BenchWords(Language.valueOf(arguments[2]));
        var out = new PrintStream(System.out, false, StandardCharsets.UTF_8);
        Job job = PipelineJobs.all(quick).get(Integer.parseInt(arguments[0]));
        if (job.openGl()) OffscreenContext.open(OffscreenContext.ContextProfile.CORE);
        out.println(job.row().get().line(words));
        out.flush();
    }
}
