package rasterlab.app.study.chart;

/**
 * The measurement that is going on.
 *
 * @param kind which of the lab's two measurements, or what there is instead
 * @param done finished pieces of work
 * @param of pieces in all
 * @param method that was finished last; "" before the first
 * @param on the workload, or the hazard; where something could not be written or read, why
 */
public record StudyWork(Kind kind, int done, int of, String method, String on) {
    public enum Kind {
        NONE,
        GIVEN_UP,
        /** The last result was measured, but could not be written. */
        NOT_KEPT,
        /** The result of an earlier run could not be read. */
        NOT_READ,
        STUDY,
        HAZARDS
    }

    public static final StudyWork NONE = begun(Kind.NONE, 0);
    public static final StudyWork GIVEN_UP = begun(Kind.GIVEN_UP, 0);

    public static StudyWork begun(Kind kind, int of) {
        return new StudyWork(kind, 0, of, "", "");
    }

    /** The end of a measurement whose result could not be written, or of a reading that failed. */
    public static StudyWork failed(Kind kind, String reason) {
        return new StudyWork(kind, 0, 0, "", reason);
    }

    public boolean running() {
        return kind == Kind.STUDY || kind == Kind.HAZARDS;
    }
}
