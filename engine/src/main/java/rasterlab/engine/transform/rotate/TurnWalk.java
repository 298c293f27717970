package rasterlab.engine.transform.rotate;

/** A point on its way round, one formula per step; a new walk stands before the first. */
public abstract class TurnWalk {
    private final int times;
    private int turn;
    private String text = "";
    private double value = Double.NaN;

    /** Where the point is now. */
    double x;

    double y;

    TurnWalk(int times, double x, double y) {
        this.times = times;
        this.x = x;
        this.y = y;
    }

    /** Takes the next step; false when there is none, and then again each time. */
    public abstract boolean advance();

    /** Begins another turn; false when all are done. */
    boolean nextTurn() {
        if (turn == times) return false;
        turn++;
        return true;
    }

    /** Notes what the step found. */
    void found(String formula, double number) {
        text = formula;
        value = number;
    }

    /** The turn that the step belongs to, from 1. */
    public int turn() {
        return turn;
    }

    /** The formula that the step computed. */
    public String text() {
        return text;
    }

    /** The result. */
    public double value() {
        return value;
    }

    public double x() {
        return x;
    }

    public double y() {
        return y;
    }
}
