package rasterlab.exercises;

import java.util.function.Consumer;
import rasterlab.exercises.score.CaseReport;
import rasterlab.exercises.score.Report;

/**
 * Tries a student's source on an exercise. The command line and the server both grade through this.
 */
@FunctionalInterface
public interface Grading {
    /** The longest source, in bytes of UTF-8: a longer one is refused wherever it is handed in. */
    int MOST_SOURCE_BYTES = 256 * 1024;

    /**
     * Compiles, runs in isolation, compares and scores. Never throws for anything that the student
     * wrote: that is a verdict of the report. Grading is a function of its arguments, but for the
     * measured speed.
     *
     * @param source the student's Java source text
     * @param cases which cases to try
     * @param progress called with each case as soon as it is judged, from the calling thread
     * @throws InterruptedException when the calling thread is interrupted; the children are killed
     *     first
     */
    Report grade(
            Exercise exercise, String source, CaseSelection cases, Consumer<CaseReport> progress)
            throws InterruptedException;

    /**
     * Which cases to try.
     *
     * @param hidden whether the hidden cases are tried too
     * @param seed draws the hidden cases; the same seed draws the same ones
     */
    record CaseSelection(boolean hidden, long seed) {
        /** The open cases only, as on a student's own machine. */
        public static CaseSelection open() {
            return new CaseSelection(false, 0);
        }

        /** Open cases and the hidden ones that this seed draws. */
        public static CaseSelection all(long seed) {
            return new CaseSelection(true, seed);
        }
    }
}
