package rasterlab.engine.transform.rotate;

import rasterlab.engine.transform.Angle;

/** {@link TurnLoops#turn} in two steps per turn. */
final class DirectWalk extends TurnWalk {
    private final Angle by;
    private boolean within;
    private double turned;

    DirectWalk(Angle by, int times, double x, double y) {
        super(times, x, y);
        this.by = by;
    }

    @Override
    public boolean advance() {
        if (!within) {
            if (!nextTurn()) return false;
            turned = x * by.cos() - y * by.sin();
            found("x' = x·cos θ − y·sin θ", turned);
        } else {
            y = x * by.sin() + y * by.cos();
            x = turned;
            found("y' = x·sin θ + y·cos θ", y);
        }
        within = !within;
        return true;
    }
}
