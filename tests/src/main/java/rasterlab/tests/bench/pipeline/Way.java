package rasterlab.tests.bench.pipeline;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.language.Complaints;
import rasterlab.engine.lanes.Lanes;
import rasterlab.engine.pipeline.fast.TrianglePipeline;
import rasterlab.tests.bench.BenchWords;

/** A pipeline that computes so many pixels at a time. */
record Way(Lanes lanes, TrianglePipeline pipeline) implements AutoCloseable {
    /** The fastest one first; only the plain one where there is no Vector API. */
    static List<Way> all() {
        int threads = Runtime.getRuntime().availableProcessors();
        var ways = new ArrayList<Way>();
        if (Lanes.best() == Lanes.EIGHT) ways.add(of(threads, Lanes.EIGHT));
        ways.add(of(threads, Lanes.ONE));
        return ways;
    }

    private static Way of(int threads, Lanes lanes) {
        return new Way(lanes, new TrianglePipeline(threads, lanes));
    }

    /** Which of them run, and why not both. */
    static String names(BenchWords words) {
        return Lanes.missing().isEmpty()
                ? words.text("runs.both")
                : words.text(
                        "runs.plain", Complaints.saidToTypist(words.language(), Lanes.missing()));
    }

    String name() {
        return lanes == Lanes.EIGHT ? "Vector API" : "plain Java";
    }

    @Override
    public void close() {
        pipeline.close();
    }
}
