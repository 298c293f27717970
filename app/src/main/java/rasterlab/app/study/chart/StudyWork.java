package rasterlab.app.study;

/**
 * The measurement that is going on.
 *
 * @param kind which of the lab's two measurements, or what there is instead
 * @param done finished pieces of work
 * @param of pieces in all
 * @param method that was finished last; "" before the first
 * @param on the workload, or the hazard
 */
public record StudyWork(Kind kind, int done, int of, String method, String on) {
    public enum Kind {
        NONE,
        GIVEN_UP,
        STUDY,
        HAZARDS
    }

    static final StudyWork NONE = begun(Kind.NONE, 0);
    static final StudyWork GIVEN_UP = begun(Kind.GIVEN_UP, 0);

    static StudyWork begun(Kind kind, int of) {
        return new StudyWork(kind, 0, of, "", "");
    }

    public boolean running() {
        return kind == Kind.STUDY || kind == Kind.HAZARDS;
    }
}
