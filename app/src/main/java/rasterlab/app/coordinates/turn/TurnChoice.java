package rasterlab.app.coordinates.turn;

import rasterlab.engine.transform.rotate.Turns;

/**
 * The user's choice, which undo brings back.
 *
 * @param degrees of one turn
 * @param times how many turns
 */
public record TurnChoice(String method, double degrees, int times, double x, double y) {
    static TurnChoice first() {
        return new TurnChoice("buneman", 30, 7, 8, 3);
    }

    Turns turns() {
        return turns(times);
    }

    /** This point after another number of turns. */
    Turns turns(int other) {
        return new Turns(degrees, other, new double[] {x, y});
    }

    TurnChoice withMethod(String other) {
        return new TurnChoice(other, degrees, times, x, y);
    }

    TurnChoice withDegrees(double other) {
        return new TurnChoice(method, other, times, x, y);
    }

    TurnChoice withTimes(int other) {
        return new TurnChoice(method, degrees, other, x, y);
    }

    TurnChoice withPoint(double otherX, double otherY) {
        return new TurnChoice(method, degrees, times, otherX, otherY);
    }

    TurnChoice with(Turns turns) {
        return new TurnChoice(
                method, turns.degrees(), turns.times(), turns.points()[0], turns.points()[1]);
    }
}
