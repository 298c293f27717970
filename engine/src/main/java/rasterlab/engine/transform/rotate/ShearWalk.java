package rasterlab.engine.transform.rotate;

/** {@link TurnLoops#shear} in three steps per turn, and the half turns left over at the end. */
final class ShearWalk extends TurnWalk {
    private final double t;
    private final double sin;
    private boolean signs;
    private int step;
    private double sheared;

    /**
     * @param t tan θ/2
     * @param sin sin θ
     * @param signs whether both signs change at the end
     */
    ShearWalk(double t, double sin, boolean signs, int times, double x, double y) {
        super(times, x, y);
        this.t = t;
        this.sin = sin;
        this.signs = signs;
    }

    @Override
    public boolean advance() {
        if (step == 0 && !nextTurn()) return changeSigns();
        switch (step) {
            case 0 -> {
                sheared = y + x * t;
                found("T = y + x·t", sheared);
            }
            case 1 -> {
                x = x - sheared * sin;
                found("x' = x − T·sin θ", x);
            }
            default -> {
                y = x * t + sheared;
                found("y' = x'·t + T", y);
            }
        }
        step = (step + 1) % 3;
        return true;
    }

    private boolean changeSigns() {
        if (!signs) return false;
        signs = false;
        x = -x;
        y = -y;
        found("x' = −x, y' = −y: the half turns", x);
        return true;
    }
}
