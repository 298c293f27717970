package rasterlab.engine.pipeline.paint;

import rasterlab.engine.color.Levels;
import rasterlab.engine.light.PointLighting;
import rasterlab.engine.scene.Mesh;

/**
 * Phong's shading: point and normal are mixed between the corners with perspective, the normal is
 * brought back to length 1, and the whole formula is worked out at each pixel.
 *
 * <p>Each channel is cut to [0, 1] once, at the pixel.
 *
 * <p>Source: B. T. Phong, Illumination for computer generated pictures, Communications of the ACM
 * 18(6), 1975, pp. 311–317.
 */
final class PointColors implements SurfaceColor {
    private final FaceLights faces;
    private final Mesh mesh;
    private final ThreadLocal<PointLighting[]> lights;

    PointColors(FaceLights faces) {
        this.faces = faces;
        mesh = faces.mesh();
        lights = ThreadLocal.withInitial(faces::forThread);
    }

    @Override
    public void light(int face, PixelRow row) {
        PointLighting lighting = lights.get()[faces.finishOf(face)];
        boolean behind = faces.seenFromBehind(face);
        boolean tinted = mesh.hasColors();
        float[] rgba = new float[4];
        int a = mesh.corner(face, 0);
        for (int i = 0; i < row.size; i++) {
            int fan = row.fan[i];
            int b = mesh.corner(face, fan);
            int c = mesh.corner(face, fan + 1);
            double w0 = row.weight0[i];
            double w1 = row.weight1[i];
            double w2 = row.weight2[i];
            double x = w0 * mesh.x(a) + w1 * mesh.x(b) + w2 * mesh.x(c);
            double y = w0 * mesh.y(a) + w1 * mesh.y(b) + w2 * mesh.y(c);
            double z = w0 * mesh.z(a) + w1 * mesh.z(b) + w2 * mesh.z(c);
            double nx = normal(face, fan, 0, w0, w1, w2);
            double ny = normal(face, fan, 1, w0, w1, w2);
            double nz = normal(face, fan, 2, w0, w1, w2);
            if (!tinted) {
                row.argb[i] = lighting.argb(x, y, z, nx, ny, nz, behind);
                continue;
            }
            for (int k = 0; k < 3; k++)
                rgba[k] =
                        (float)
                                (w0 * mesh.color(face, 0, k)
                                        + w1 * mesh.color(face, fan, k)
                                        + w2 * mesh.color(face, fan + 1, k));
            lighting.shadeTinted(x, y, z, nx, ny, nz, behind, rgba, 0);
            row.argb[i] = Levels.argb(rgba[0], rgba[1], rgba[2], rgba[3]);
        }
    }

    private double normal(int face, int fan, int axis, double w0, double w1, double w2) {
        return w0 * mesh.cornerNormal(face, 0, axis)
                + w1 * mesh.cornerNormal(face, fan, axis)
                + w2 * mesh.cornerNormal(face, fan + 1, axis);
    }
}
