package rasterlab.engine.pipeline.surface;

import rasterlab.engine.light.PointLighting;

/** A point with its normal and its light; one per thread. */
final class PointShade {
    private final PointLighting lighting;
    private double x;
    private double y;
    private double z;
    private double nx;
    private double ny;
    private double nz;

    /** The colour, four shares. */
    final float[] rgba = new float[4];

    PointShade(PointLighting lighting) {
        this.lighting = lighting.forThread();
    }

    void place(double x, double y, double z, double nx, double ny, double nz) {
        this.x = x;
        this.y = y;
        this.z = z;
        this.nx = nx;
        this.ny = ny;
        this.nz = nz;
    }

    void byMaterial(boolean fromBehind) {
        lighting.shade(x, y, z, nx, ny, nz, fromBehind, rgba, 0);
    }

    void tinted(boolean fromBehind, float red, float green, float blue) {
        rgba[0] = red;
        rgba[1] = green;
        rgba[2] = blue;
        lighting.shadeTinted(x, y, z, nx, ny, nz, fromBehind, rgba, 0);
    }
}
