package rasterlab.tests.bench.pipeline;

import java.io.IOException;
import java.io.PrintStream;
import java.util.List;
import rasterlab.app.cli.Console;
import rasterlab.app.cli.ReportLanguage;
import rasterlab.app.language.Language;
import rasterlab.app.opengl.context.OffscreenContext;
import rasterlab.tests.bench.BenchWords;

/**
 * Measures one job in a process of its own.
 *
 * <p>What the compiler has learnt from other jobs, and how much memory OpenGL has kept of theirs,
 * would change the times by a fifth and more.
 */
final class JobProcess {
    private JobProcess() {}

    /** Whether that job of the list was measured; its lines go to {@code out}. */
    static boolean run(int number, boolean quick, Language language, PrintStream out)
            throws IOException, InterruptedException {
        var arguments =
                List.of(String.valueOf(number), String.valueOf(quick), String.valueOf(language));
        return new OwnProcess(List.of(), JobProcess.class, arguments).run(out, System.err);
    }

    /** Prints the job's lines; the context ends with the process. */
    public static void main(String[] arguments) {
        boolean quick = Boolean.parseBoolean(arguments[1]);
        var words = new BenchWords(Language.valueOf(arguments[2]));
        PrintStream out = Console.of(System.in, System.out, System.err, ReportLanguage.EN).out();
        List<Way> ways = Way.all();
        var job = PipelineJobs.all(quick, ways).get(Integer.parseInt(arguments[0]));
        if (job.openGl()) OffscreenContext.open(OffscreenContext.Profile.CORE);
        for (Row row : job.rows().get()) out.println(row.line(words));
        out.flush();
        ways.forEach(Way::close);
    }
}
