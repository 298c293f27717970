package rasterlab.engine.transform;

import java.util.Map;

/** The operations of doubles, counted: what a method's counting twin computes with. */
public final class CountingArithmetic {
    private long additions;
    private long multiplications;
    private long divisions;

    public double plus(double a, double b) {
        additions++;
        return a + b;
    }

    public double minus(double a, double b) {
        additions++;
        return a - b;
    }

    public double times(double a, double b) {
        multiplications++;
        return a * b;
    }

    public double over(double a, double b) {
        divisions++;
        return a / b;
    }

    /** Each kind by its name; divisions only where there are any. */
    public Map<String, Long> counts() {
        return divisions == 0
                ? Map.of("additions", additions, "multiplications", multiplications)
                : Map.of(
                        "additions",
                        additions,
                        "multiplications",
                        multiplications,
                        "divisions",
                        divisions);
    }
}
