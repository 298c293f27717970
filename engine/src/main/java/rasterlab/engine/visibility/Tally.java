package rasterlab.engine.visibility;

/** {@link VisibilityWork} while it is being done, by one thread. */
public final class Tally {
    public long comparisons;
    public long depthTests;
    public long pixelsWritten;
    public long splits;

    public VisibilityWork work() {
        return new VisibilityWork(comparisons, depthTests, pixelsWritten, splits);
    }
}
