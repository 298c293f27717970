package rasterlab.tests.bench.grader;

import java.io.PrintStream;
import java.util.function.BooleanSupplier;

/**
 * Prints lines until this process is told to end: what is counted while the servers are ended with
 * it is no measurement.
 */
final class MeasuredLines {
    private static final Thread NEVER_ADDED = new Thread();

    private final PrintStream out;
    private final BooleanSupplier over;

    MeasuredLines(PrintStream out) {
        this(out, MeasuredLines::isProcessEnding);
    }

    /**
     * @param over whether nothing is printed any more
     */
    MeasuredLines(PrintStream out, BooleanSupplier over) {
        this.out = out;
        this.over = over;
    }

    /** Says whether this process was told to end, before the first shutdown hook begins. */
    static boolean isProcessEnding() {
        try {
            Runtime.getRuntime().removeShutdownHook(NEVER_ADDED);
            return false;
        } catch (IllegalStateException ending) {
            return true;
        }
    }

    boolean isOver() {
        return over.getAsBoolean();
    }

    void println(String line) {
        if (!isOver()) out.println(line);
    }
}
