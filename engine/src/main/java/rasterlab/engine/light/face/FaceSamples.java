package rasterlab.engine.light.face;

import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.contract.SurfaceMaterial;

/** Faces to try methods on. */
final class FaceSamples {
    private FaceSamples() {}

    /**
     * A piece of a sphere of radius 1 about the origin, with its radii as normals.
     *
     * @param reach how far its corners are from (0, 0, 1), in radians
     */
    static LitFace dome(double reach, double[] lamp, double[] eye, SurfaceMaterial material) {
        var corners = new double[9];
        for (int k = 0; k < 3; k++) {
            double turn = 2 * Math.PI * k / 3;
            corners[3 * k] = Math.sin(reach) * Math.cos(turn);
            corners[3 * k + 1] = Math.sin(reach) * Math.sin(turn);
            corners[3 * k + 2] = Math.cos(reach);
        }
        return face(corners, corners, lamp, eye, material);
    }

    static LitFace face(
            double[] corners,
            double[] normals,
            double[] lamp,
            double[] eye,
            SurfaceMaterial material) {
        return new LitFace(
                corners,
                normals,
                lamp,
                eye,
                material,
                LightSource.white(),
                new double[] {0.2, 0.2, 0.2});
    }

    /** A material that reflects one share of every colour. */
    static SurfaceMaterial gray(double diffuse, double specular, double shininess) {
        double[] d = {diffuse, diffuse, diffuse};
        double[] s = {specular, specular, specular};
        return new SurfaceMaterial(d, d, s, new double[3], shininess);
    }
}
