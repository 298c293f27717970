package rasterlab.engine.light.face;

import rasterlab.contract.FaceShader;
import rasterlab.contract.LitFace;

/** A method that tells where it evaluates the formula; between these places it mixes. */
public interface SteppedFace extends FaceShader {
    /** Receives each evaluation. */
    @FunctionalInterface
    interface Evaluations {
        /**
         * Is told one evaluation.
         *
         * @param place x, y, z of the point
         * @param normal there, as the formula gets it
         * @param intensity three shares from 0 to 1
         */
        void at(double[] place, double[] normal, double[] intensity);
    }

    /**
     * Shades as {@link #shade(LitFace, double[])} does and tells each evaluation.
     *
     * @param told of the evaluations in their order
     */
    double[] shade(LitFace face, double[] weights, Evaluations told);

    @Override
    default double[] shade(LitFace face, double[] weights) {
        return shade(face, weights, (place, normal, intensity) -> {});
    }
}
