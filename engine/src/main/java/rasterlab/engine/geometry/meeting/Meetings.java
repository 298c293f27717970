package rasterlab.engine.geometry.meeting;

import java.util.Arrays;
import rasterlab.engine.study.Deviation;

/** The μ of several lines: the output of a method of topic {@code line-plane}. */
public final class Meetings {
    private final double[] mu;

    Meetings(double[] mu) {
        this.mu = mu;
    }

    public int size() {
        return mu.length;
    }

    public double mu(int line) {
        return mu[line];
    }

    Meetings first(int count) {
        return new Meetings(Arrays.copyOf(mu, Math.min(count, mu.length)));
    }

    /**
     * How far answers are from these exact ones, over μ where that is above 1; and 1 where only one
     * of the two is a number.
     */
    Deviation deviation(Meetings actual) {
        double worst = 0;
        long missing = 0;
        long extra = 0;
        String first = "";
        for (int i = 0; i < mu.length; i++) {
            boolean meets = Double.isFinite(mu[i]);
            boolean told = i < actual.size() && Double.isFinite(actual.mu[i]);
            double error = meets && told ? error(mu[i], actual.mu[i]) : 1;
            if (error == 0) continue;
            if (!meets) extra++;
            if (meets && !told) missing++;
            worst = Math.max(worst, error);
            if (first.isEmpty())
                first = "line " + i + " has μ " + mu[i] + ", got " + actual.told(i);
        }
        return new Deviation(worst, missing, extra, mu.length, first);
    }

    private static double error(double exact, double actual) {
        return Math.abs(actual - exact) / Math.max(1, Math.abs(exact));
    }

    private String told(int line) {
        return line < mu.length ? "" + mu[line] : "none";
    }

    @Override
    public String toString() {
        return Arrays.toString(mu);
    }
}
