package rasterlab.engine.light;

import rasterlab.contract.Reflection;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.color.Levels;

/**
 * The light of a whole scene on points, for loops over vertices and pixels: nothing is allocated
 * after construction.
 *
 * <pre>
 * I = emission + kₐ·(globalAmbient + Σ f·Lₐ) + k_d·Σ f·L_d·max(0, n·l) + k_s·Σ f·L_s·max(0, c)ˢ
 * </pre>
 *
 * over all lights, f being attenuation times cone; cut to [0, 1] at the end, as {@link Levels}
 * says. Points, normals, lights and the eye share one space without a perspective division: the
 * world's or the eye's.
 *
 * <p>An object serves one thread at a time; {@link #forThread} gives another one, so that {@code
 * ThreadLocal.withInitial(lighting::forThread)} serves a team.
 *
 * <p>Source: M. Segal, K. Akeley, The OpenGL Graphics System: A Specification, version 2.1, 2006,
 * section 2.14.1; Phong's and Lambert's terms alone are ours to choose.
 */
public final class PointLighting {
    private final LightModel model;
    private final Material front;
    private final Material back;
    private final PlacedLight[] lights;
    private final double[] fallen = new double[9];
    private double eyeX;
    private double eyeY;
    private double eyeZ = 1;
    private double eyeNear;

    /**
     * @param back the material of backs; it counts only in a two-sided model
     */
    public PointLighting(LightModel model, Material front, Material back) {
        this.model = model;
        this.front = front;
        this.back = back;
        lights = model.lights().stream().map(PlacedLight::new).toArray(PlacedLight[]::new);
    }

    /** This lighting for another thread, the eye where it is now. */
    public PointLighting forThread() {
        var other = new PointLighting(model, front, back);
        other.eyeX = eyeX;
        other.eyeY = eyeY;
        other.eyeZ = eyeZ;
        other.eyeNear = eyeNear;
        return other;
    }

    /** This light on many fronts at once, for one thread, the eye where it is now. */
    public BlockLighting forBlocks() {
        return new BlockLighting(model, front, lights, eyeX, eyeY, eyeZ, eyeNear);
    }

    /** Whether a back is lit by itself; otherwise it is lit as the front is. */
    public boolean twoSided() {
        return model.twoSided();
    }

    /**
     * Places the eye; until then it is infinitely far in the direction of z.
     *
     * @param x of the eye, for a local viewer
     * @param toEyeX x of the direction to the eye, of length 1, for one that is far
     */
    public void eye(double x, double y, double z, double toEyeX, double toEyeY, double toEyeZ) {
        boolean local = model.localViewer();
        eyeX = local ? x : toEyeX;
        eyeY = local ? y : toEyeY;
        eyeZ = local ? z : toEyeZ;
        eyeNear = local ? 1 : 0;
    }

    /**
     * Computes the colour of a point by its material.
     *
     * @param nx x of the normal out of the front, of any length; without a normal, (0, 0, 0), the
     *     point has ambient light and emission only
     * @param seenFromBehind whether the back of the surface is what is seen
     * @param rgba receives four shares from 0 to 1
     * @param at where in {@code rgba}
     */
    public void shade(
            double x,
            double y,
            double z,
            double nx,
            double ny,
            double nz,
            boolean seenFromBehind,
            float[] rgba,
            int at) {
        Material material = gather(x, y, z, nx, ny, nz, seenFromBehind);
        for (int c = 0; c < 3; c++)
            rgba[at + c] = (float) Levels.cut(channel(material.surface(), c));
        rgba[at + 3] = (float) material.alpha();
    }

    /**
     * Computes the colour of a point by its material, as {@link #shade} finds it, as 0xAARRGGBB.
     */
    public int argb(
            double x, double y, double z, double nx, double ny, double nz, boolean seenFromBehind) {
        Material material = gather(x, y, z, nx, ny, nz, seenFromBehind);
        SurfaceMaterial surface = material.surface();
        return Levels.argb(
                channel(surface, 0), channel(surface, 1), channel(surface, 2), material.alpha());
    }

    private double channel(SurfaceMaterial surface, int c) {
        return surface.emission()[c]
                + surface.ambient()[c] * fallen[c]
                + surface.diffuse()[c] * fallen[3 + c]
                + surface.specular()[c] * fallen[6 + c];
    }

    /**
     * Computes the colour of a point whose material's emission, ambient and diffuse shares are
     * multiplied by a tint; highlights and alpha are not.
     *
     * @param rgba holds the tint's three shares, receives the colour
     */
    public void shadeTinted(
            double x,
            double y,
            double z,
            double nx,
            double ny,
            double nz,
            boolean seenFromBehind,
            float[] rgba,
            int at) {
        Material material = gather(x, y, z, nx, ny, nz, seenFromBehind);
        SurfaceMaterial surface = material.surface();
        for (int c = 0; c < 3; c++) {
            double highlight = surface.specular()[c] * fallen[6 + c];
            double rest = channel(surface, c) - highlight;
            rgba[at + c] = (float) Levels.cut(rgba[at + c] * rest + highlight);
        }
        rgba[at + 3] = (float) material.alpha();
    }

    /**
     * Computes the colour of a point whose ambient and diffuse shares and alpha are its own, such
     * as a vertex's colour; emission, specular shares and shininess are the material's.
     *
     * @param rgba holds the four shares of its own, receives the colour
     */
    public void shadeColored(
            double x,
            double y,
            double z,
            double nx,
            double ny,
            double nz,
            boolean seenFromBehind,
            float[] rgba,
            int at) {
        SurfaceMaterial surface = gather(x, y, z, nx, ny, nz, seenFromBehind).surface();
        for (int c = 0; c < 3; c++)
            rgba[at + c] =
                    (float)
                            Levels.cut(
                                    surface.emission()[c]
                                            + rgba[at + c] * (fallen[c] + fallen[3 + c])
                                            + surface.specular()[c] * fallen[6 + c]);
    }

    /** Sums up what falls on a point, and says which material lies there. */
    private Material gather(
            double x, double y, double z, double nx, double ny, double nz, boolean behind) {
        boolean own = behind && model.twoSided();
        Material material = own ? back : front;
        double normal = (own ? -1 : 1) * inverse(nx * nx + ny * ny + nz * nz);
        double vx = eyeX - eyeNear * x;
        double vy = eyeY - eyeNear * y;
        double vz = eyeZ - eyeNear * z;
        double view =
                model.reflection() == Reflection.LAMBERT ? 0 : inverse(vx * vx + vy * vy + vz * vz);
        System.arraycopy(model.globalAmbient(), 0, fallen, 0, 3);
        for (int i = 3; i < fallen.length; i++) fallen[i] = 0;
        for (PlacedLight light : lights)
            light.fallOn(
                    x,
                    y,
                    z,
                    nx * normal,
                    ny * normal,
                    nz * normal,
                    vx * view,
                    vy * view,
                    vz * view,
                    model.reflection(),
                    material.surface().shininess(),
                    fallen);
        return material;
    }

    static double inverse(double square) {
        return square > 0 ? 1 / Math.sqrt(square) : 0;
    }
}
