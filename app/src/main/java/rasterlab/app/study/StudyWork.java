package rasterlab.app.study;

/**
 * What is being measured.
 *
 * @param kind which of the lab's two measurements
 * @param done finished pieces of work
 * @param of pieces in all
 * @param at what was finished last, such as {@code bresenham, short}
 */
record StudyWork(Kind kind, int done, int of, String at) {
    enum Kind {
        NONE,
        STUDY,
        HAZARDS
    }

    static final StudyWork NONE = new StudyWork(Kind.NONE, 0, 0, "");

    boolean running() {
        return kind != Kind.NONE;
    }
}
