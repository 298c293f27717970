package rasterlab.engine.light.shade;

import rasterlab.contract.LitPoint;

/** A method that can say what each of its terms adds. */
public interface TermShader {
    /**
     * The terms of the method's intensity.
     *
     * @throws IllegalArgumentException as {@link rasterlab.contract.PointShader#intensity} does
     */
    Terms terms(LitPoint point);
}
