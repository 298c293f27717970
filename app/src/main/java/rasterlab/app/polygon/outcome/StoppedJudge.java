package rasterlab.app.polygon.outcome;

import rasterlab.engine.polygon.Membership;
import rasterlab.engine.study.NoAnswer;

/** Asks a program of the user's for one point after the other, until it has to be stopped. */
final class StoppedJudge implements Membership.PointClassifier {
    private final Membership.PointClassifier judge;
    private NoAnswer stopped;

    StoppedJudge(Membership.PointClassifier judge) {
        this.judge = judge;
    }

    /**
     * @throws NoAnswer at once where the program was stopped at an earlier point
     */
    @Override
    public boolean contains(double x, double y) {
        if (stopped != null) throw stopped;
        try {
            return judge.contains(x, y);
        } catch (NoAnswer none) {
            stopped = none;
            throw none;
        }
    }
}
