package rasterlab.app.exercise;

import rasterlab.app.exercise.outcome.Notice;

/**
 * The answer to a request to join a course.
 *
 * @param joined whether a course is joined by it
 * @param problem why not; {@link Notice#NONE} where it is, or where nothing was asked yet
 * @param field what of the form the problem is about
 */
public record JoinAnswer(boolean joined, Notice problem, JoinField field) {
    /** The data that the form asks for. */
    public enum JoinField {
        ADDRESS,
        CODE,
        NAME,
        TOKEN
    }

    public static final JoinAnswer NONE = refused(JoinField.ADDRESS, Notice.NONE);
    static final JoinAnswer JOINED = new JoinAnswer(true, Notice.NONE, JoinField.ADDRESS);

    static JoinAnswer refused(JoinField field, Notice problem) {
        return new JoinAnswer(false, problem, field);
    }
}
