package rasterlab.engine.light.shade;

import java.util.ArrayList;
import java.util.List;
import rasterlab.engine.color.Levels;

/**
 * The amounts that the terms of the formula add to red, green and blue, all factors multiplied in.
 *
 * @param emission light of its own
 * @param globalAmbient light from everywhere
 * @param ambient what the source adds to it
 * @param diffuse scattered light
 * @param specular mirrored light
 * @param attenuation the factor of the distance, already in the source's terms
 * @param cone the factor of the spot's cone, already in the source's terms
 */
public record Terms(
        double[] emission,
        double[] globalAmbient,
        double[] ambient,
        double[] diffuse,
        double[] specular,
        double attenuation,
        double cone) {
    /**
     * A term added.
     *
     * @param term as on the command line
     * @param value what it adds
     * @param sum of it and those before it
     */
    public record Addition(String term, double[] value, double[] sum) {}

    /** The terms in their order, from the first to the whole {@link #sum}. */
    public List<Addition> additions() {
        var additions = new ArrayList<Addition>();
        var sum = new double[3];
        add("emission", emission, sum, additions);
        add("global-ambient", globalAmbient, sum, additions);
        add("ambient", ambient, sum, additions);
        add("diffuse", diffuse, sum, additions);
        add("specular", specular, sum, additions);
        return additions;
    }

    private static void add(String term, double[] value, double[] sum, List<Addition> additions) {
        for (int c = 0; c < 3; c++) sum[c] += value[c];
        additions.add(new Addition(term, value, sum.clone()));
    }

    /** Red, green and blue of all terms together, not cut. */
    public double[] sum() {
        var sum = new double[3];
        for (int c = 0; c < 3; c++)
            sum[c] = emission[c] + globalAmbient[c] + ambient[c] + diffuse[c] + specular[c];
        return sum;
    }

    /** The sum cut to [0, 1]. */
    public double[] intensity() {
        double[] intensity = sum();
        for (int c = 0; c < 3; c++) intensity[c] = Levels.cut(intensity[c]);
        return intensity;
    }
}
