package rasterlab.engine.transform;

import java.util.Map;

/** Computes and counts. */
public final class CountingArithmetic implements Arithmetic {
    private long additions;
    private long multiplications;

    @Override
    public double plus(double a, double b) {
        additions++;
        return a + b;
    }

    @Override
    public double minus(double a, double b) {
        additions++;
        return a - b;
    }

    @Override
    public double times(double a, double b) {
        multiplications++;
        return a * b;
    }

    /** Additions and subtractions so far. */
    public long additions() {
        return additions;
    }

    public long multiplications() {
        return multiplications;
    }

    /** Both, by name. */
    public Map<String, Long> counts() {
        return Map.of("additions", additions, "multiplications", multiplications);
    }
}
