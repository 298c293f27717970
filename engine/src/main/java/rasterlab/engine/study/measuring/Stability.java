package rasterlab.engine.study.measuring;

/**
 * Tells when a load is warmed up: when it has become no faster for a while.
 *
 * <p>Source: A. Georges, D. Buytaert and L. Eeckhout, Statistically Rigorous Java Performance
 * Evaluation, OOPSLA 2007, section 4: a steady state is found, not assumed.
 */
public final class Stability {
    /** The number of runs on end that bring nothing, which make it stable. */
    private static final int RUNS = 3;

    /** The least gain: a run that is faster than the best before by less brings nothing. */
    private static final double GAIN = 1.03;

    private double best = Double.POSITIVE_INFINITY;
    private int alike;

    /** Takes the time per item of one more run. */
    public void add(double nanos) {
        alike = nanos * GAIN < best ? 0 : alike + 1;
        best = Math.min(best, nanos);
    }

    public boolean isReached() {
        return alike >= RUNS;
    }
}
