package rasterlab.app.exercise;

import rasterlab.app.exercise.outcome.Notice;

/**
 * The answer to a request to join a course.
 *
 * @param joined whether a course is joined by it
 * @param problem why not; {@link Notice#NONE} where it is, or where nothing was asked yet
 * @param field what of the form the problem is about
 */
public record JoinAnswer(boolean joined, Notice problem, Field field) {
    /** The data that the form asks for. */
    public enum Field {
        ADDRESS,
        CODE,
        NAME,
        TOKEN
    }

    public static final JoinAnswer NONE = refused(Field.ADDRESS, Notice.NONE);
    static final JoinAnswer JOINED = new JoinAnswer(true, Notice.NONE, Field.ADDRESS);

    static JoinAnswer refused(Field field, Notice problem) {
        return new JoinAnswer(false, problem, field);
    }
}
