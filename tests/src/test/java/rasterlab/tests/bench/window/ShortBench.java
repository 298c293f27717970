package rasterlab.tests.bench.window;

import java.io.IOException;
import rasterlab.tests.bench.language.BenchWords;

/** The window's benchmark with one start and short drags, in a process of its own. */
final class ShortBench {
    private ShortBench() {}

    public static void main(String[] none) throws IOException, InterruptedException {
        new WindowBench(1, 0.5, 0, BenchWords.ENGLISH, System.out).run();
    }
}
