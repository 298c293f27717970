package rasterlab.engine.visibility;

/** {@link VisibilityWork} while it is being done, by one thread. */
final class Tally {
    long comparisons;
    long depthTests;
    long pixelsWritten;
    long splits;

    VisibilityWork work() {
        return new VisibilityWork(comparisons, depthTests, pixelsWritten, splits);
    }
}
