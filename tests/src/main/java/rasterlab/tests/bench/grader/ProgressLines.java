package rasterlab.tests.bench.grader;

import java.time.Duration;

/** Says now and then how far a part is that takes long. */
final class ProgressLines {
    private static final Duration PAUSE = Duration.ofSeconds(15);

    private final MeasuredLines out;
    private long last = System.nanoTime();

    ProgressLines(MeasuredLines out) {
        this.out = out;
    }

    /** Prints the line, but where one was printed lately. */
    void tell(String line) {
        long now = System.nanoTime();
        if (now - last < PAUSE.toNanos()) return;
        last = now;
        out.println("  " + line);
    }
}
