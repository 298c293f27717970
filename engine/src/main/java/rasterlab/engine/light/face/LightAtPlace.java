package rasterlab.engine.light.face;

import rasterlab.contract.LitFace;

/** Light at one place of a face. */
@FunctionalInterface
interface LightAtPlace {
    /**
     * Red, green and blue.
     *
     * @param place x, y, z of the point
     * @param normal there, of any length
     */
    double[] at(LitFace face, double[] place, double[] normal);
}
