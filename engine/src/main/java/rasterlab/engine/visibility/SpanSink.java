package rasterlab.engine.visibility;

/** Receives the runs of pixels that a filled polygon owns. */
@FunctionalInterface
public interface SpanSink {
    /** Pixels from ≤ x &lt; to of row y, all inside the picture. */
    void span(int y, int from, int to);
}
