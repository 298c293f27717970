package rasterlab.app;

import java.awt.GraphicsEnvironment;
import java.io.BufferedOutputStream;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.PrintStream;
import rasterlab.app.cli.Lab;
import rasterlab.app.outcome.ExitCode;
import rasterlab.app.shell.WindowStart;

/** The desktop lab when there are no arguments, the command line when there are. */
public final class Main {
    private Main() {}

    public static void main(String[] arguments) {
        if (arguments.length > 0) {
            System.exit(run(arguments));
        } else if (GraphicsEnvironment.isHeadless()) {
            System.err.println("rasterlab: there is no display, so the tour is made instead");
            System.exit(run("tour"));
        } else {
            WindowStart.open();
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
