package rasterlab.app;

import java.awt.GraphicsEnvironment;
import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import java.util.Optional;
import rasterlab.app.cli.Lab;
import rasterlab.app.language.Language;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.shell.WindowStart;

/** The desktop lab when no command is given, the command line when one is. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        Optional<Language> asked = Lab.windowIn(arguments);
        if (arguments.length > 0 && asked.isEmpty()) {
            int code = run(arguments);
            // A window that was opened ends its process itself, as its last thread ends.
            if (code != ExitCode.DONE || !Lab.mayHaveOpened(arguments)) System.exit(code);
        } else if (GraphicsEnvironment.isHeadless()) {
            System.exit(run(Lab.instead(arguments)));
        } else {
            WindowStart.open(asked, Lab.notices());
        }
    }

    private static int run(String... arguments) {
        var results = new WatchedOutput(new FileOutputStream(FileDescriptor.out));
        var out = new PrintStream(new BufferedOutputStream(results, 1 << 13));
        int code = Lab.run(arguments, System.in, out, System.err);
        if (results.loss().isEmpty()) return code;
        System.err.println("./lab: the output could not be written: " + results.loss().get());
        return code == ExitCode.DONE ? ExitCode.NOT_WRITTEN : code;
    }
}
