package rasterlab.engine.light;

import java.util.Arrays;
import rasterlab.contract.Reflection;
import rasterlab.engine.color.Levels;

/**
 * The light of a whole scene on the fronts of many points at once: what {@link PointLighting#shade}
 * computes, bit for bit, by loops over arrays that the compiler turns into vector instructions.
 * Nothing is allocated after construction; one per thread.
 */
public final class BlockLighting {
    /** The most points at once: their numbers stay in the first-level cache. */
    public static final int SIZE = IncidentLight.SIZE;

    private final LightModel model;
    private final Material front;
    private final PlacedLight[] lights;
    private final double[] eye;
    private final IncidentLight points = new IncidentLight();

    /** Light that falls on each point, channel by channel. */
    private final double[][] ambient = new double[3][SIZE];

    private final double[][] diffuse = new double[3][SIZE];
    private final double[][] specular = new double[3][SIZE];

    /** The points, which are written before {@link #light}. */
    public final double[] x = points.x;

    public final double[] y = points.y;
    public final double[] z = points.z;

    /** Normals out of the front, of any length, which are written too; 0 where there is none. */
    public final double[] nx = points.nx;

    public final double[] ny = points.ny;
    public final double[] nz = points.nz;

    /** The colours that come out, shares from 0 to 1. */
    public final float[] red = new float[SIZE];

    public final float[] green = new float[SIZE];
    public final float[] blue = new float[SIZE];

    /**
     * @param eye x, y and z of the eye or of the direction to it, then 1 for a point and 0 for a
     *     direction
     */
    BlockLighting(LightModel model, Material front, PlacedLight[] lights, double... eye) {
        this.model = model;
        this.front = front;
        this.lights = lights;
        this.eye = eye;
    }

    /** The share, 0 to 1, that all points have. */
    public float alpha() {
        return (float) front.alpha();
    }

    /**
     * Computes the colours of points; their normals are lost.
     *
     * @param count 0 to {@link #SIZE}
     */
    public void light(int count) {
        points.count = count;
        makeUnit();
        for (int c = 0; c < 3; c++) {
            Arrays.fill(ambient[c], 0, count, model.globalAmbient()[c]);
            Arrays.fill(diffuse[c], 0, count, 0);
            Arrays.fill(specular[c], 0, count, 0);
        }
        for (PlacedLight light : lights) {
            light.fallOn(points, model.reflection(), front.surface().shininess());
            for (int c = 0; c < 3; c++) {
                add(light.source().ambient()[c], points.ambient, ambient[c]);
                add(light.source().diffuse()[c], points.diffuse, diffuse[c]);
                add(light.source().specular()[c], points.specular, specular[c]);
            }
        }
        reflect(0, red);
        reflect(1, green);
        reflect(2, blue);
    }

    /** Brings normals, and directions to the eye where they count, to length 1. */
    private void makeUnit() {
        boolean viewed = model.reflection() != Reflection.LAMBERT;
        for (int i = 0; i < points.count; i++) {
            double normal = PointLighting.inverse(nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i]);
            nx[i] *= normal;
            ny[i] *= normal;
            nz[i] *= normal;
        }
        for (int i = 0; viewed && i < points.count; i++) {
            double toEyeX = eye[0] - eye[3] * x[i];
            double toEyeY = eye[1] - eye[3] * y[i];
            double toEyeZ = eye[2] - eye[3] * z[i];
            double view =
                    PointLighting.inverse(toEyeX * toEyeX + toEyeY * toEyeY + toEyeZ * toEyeZ);
            points.vx[i] = toEyeX * view;
            points.vy[i] = toEyeY * view;
            points.vz[i] = toEyeZ * view;
        }
    }

    private void add(double share, double[] factor, double[] sum) {
        int count = points.count;
        for (int i = 0; i < count; i++) sum[i] += share * factor[i];
    }

    private void reflect(int c, float[] out) {
        double emission = front.surface().emission()[c];
        double byAmbient = front.surface().ambient()[c];
        double byDiffuse = front.surface().diffuse()[c];
        double bySpecular = front.surface().specular()[c];
        double[] a = ambient[c];
        double[] d = diffuse[c];
        double[] s = specular[c];
        int count = points.count;
        for (int i = 0; i < count; i++)
            a[i] = emission + byAmbient * a[i] + byDiffuse * d[i] + bySpecular * s[i];
        for (int i = 0; i < count; i++) out[i] = (float) Levels.cut(a[i]);
    }
}
