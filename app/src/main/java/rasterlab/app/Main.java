package rasterlab.app;

import java.awt.GraphicsEnvironment;
import rasterlab.app.cli.Lab;
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
        return Lab.run(arguments, System.in, System.out, System.err);
    }
}
