package rasterlab.engine.signmap;

import rasterlab.engine.predicate.Spacing;

/**
 * The answers of a method for a square of neighbouring points, beside the right ones.
 *
 * <p>A sign is −1, 0 or 1; of a question that is answered by yes or no, 1 is yes and 0 is no.
 */
public final class SignMap {
    /** The answer of a method that refuses the point or comes to no end. */
    public static final int NONE = 2;

    private final String subject;
    private final String method;
    private final boolean yesOrNo;
    private final SignField field;
    private final byte[] answers;
    private final byte[] exact;
    private int extra;
    private int missing;
    private int unanswered;

    /**
     * @param answers row after row from the lowest
     * @param exact the same, what is right
     */
    SignMap(
            String subject,
            String method,
            boolean yesOrNo,
            SignField field,
            byte[] answers,
            byte[] exact) {
        this.subject = subject;
        this.method = method;
        this.yesOrNo = yesOrNo;
        this.field = field;
        this.answers = answers;
        this.exact = exact;
        for (int i = 0; i < answers.length; i++) {
            if (answers[i] == NONE) unanswered++;
            else if (answers[i] > exact[i]) extra++;
            else if (answers[i] < exact[i]) missing++;
        }
    }

    /** The topic or predicate asked. */
    public String subject() {
        return subject;
    }

    public String method() {
        return method;
    }

    /** Points in each row and column. */
    public int size() {
        return field.size();
    }

    /** Whether the answers are yes and no, not signs. */
    public boolean yesOrNo() {
        return yesOrNo;
    }

    public Spacing spacing() {
        return field.spacing();
    }

    /** x of the points of a column. */
    public double x(int column) {
        return field.spacing().above(field.left(), column);
    }

    /** y of the points of a row, which are counted from the lowest. */
    public double y(int row) {
        return field.spacing().above(field.low(), row);
    }

    /** −1, 0, 1 or {@link #NONE}. */
    public int answer(int column, int row) {
        return answers[row * size() + column];
    }

    /** −1, 0 or 1. */
    public int exact(int column, int row) {
        return exact[row * size() + column];
    }

    /** Whether there is an answer and it is not the right one. */
    public boolean wrong(int column, int row) {
        int answer = answer(column, row);
        return answer != NONE && answer != exact(column, row);
    }

    /** How many answers are greater than right: yes for no, or a greater sign. */
    public int extra() {
        return extra;
    }

    /** How many answers are less than right: no for yes, or a smaller sign. */
    public int missing() {
        return missing;
    }

    /** How many points have no answer. */
    public int unanswered() {
        return unanswered;
    }

    /** How many points there are. */
    public int points() {
        return answers.length;
    }

    /** The wrong answers' share of all points. */
    public double share() {
        return (extra + missing) / (double) points();
    }
}
