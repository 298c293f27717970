package rasterlab.engine.scene.shape;

import java.util.List;
import rasterlab.engine.geometry.Vector;

/**
 * A parallelogram {@code p = center + u·right + v·up}, u and v from −1 to 1, with a place of the
 * texture at each corner and between them in u and v: along any line of constant u or v evenly.
 *
 * <p>It is seen from the side {@code right × up} points to, and met from both. A place lies within
 * a few units of the last place of |o| + |centre| of the plane.
 */
public final class Quad implements SceneShape, Patch {
    /** A parallelogram whose sine is below this is refused. */
    private static final double NARROWEST = 1e-9;

    private final Vector center;
    private final Vector right;
    private final Vector up;
    private final Vector normal;
    private final double area;
    private final TexturePlace[] corners;

    /**
     * @param right from the centre to the middle of the right side
     * @param up from the centre to the middle of the upper side
     * @param corners of the texture: lower left, lower right, upper right, upper left
     */
    public Quad(Vector center, Vector right, Vector up, TexturePlace... corners) {
        if (corners.length != 4)
            throw new IllegalArgumentException(
                    "a quad has 4 corners, got " + corners.length + " places of a texture");
        Size.requireCoordinate("quad's x", center.x());
        Size.requireCoordinate("quad's y", center.y());
        Size.requireCoordinate("quad's z", center.z());
        Size.require("quad's right", right.length());
        Size.require("quad's up", up.length());
        Vector cross = right.cross(up);
        if (!(cross.length() > NARROWEST * right.length() * up.length()))
            throw new IllegalArgumentException(
                    "quad's right and up must span an area, got %s and %s".formatted(right, up));
        this.center = center;
        this.right = right;
        this.up = up;
        this.corners = corners.clone();
        normal = cross.unit();
        area = cross.length();
    }

    /** A parallelogram that shows the texture once. */
    public static Quad whole(Vector center, Vector right, Vector up) {
        return new Quad(
                center,
                right,
                up,
                new TexturePlace(0, 0),
                new TexturePlace(1, 0),
                new TexturePlace(1, 1),
                new TexturePlace(0, 1));
    }

    @Override
    public List<Patch> patches() {
        return List.of(this);
    }

    @Override
    public boolean isFlat() {
        return true;
    }

    @Override
    public Span u() {
        return new Span(-1, 1, false);
    }

    @Override
    public Span v() {
        return new Span(-1, 1, false);
    }

    @Override
    public void at(double u, double v, SurfacePoint out) {
        out.place(
                center.x() + u * right.x() + v * up.x(),
                center.y() + u * right.y() + v * up.y(),
                center.z() + u * right.z() + v * up.z());
        finish(u, v, out);
    }

    private void finish(double u, double v, SurfacePoint out) {
        out.normal(normal.x(), normal.y(), normal.z());
        double lower = (1 - v) / 2;
        double upper = (1 + v) / 2;
        double left = (1 - u) / 2;
        double onRight = (1 + u) / 2;
        out.texture(
                lower * (left * corners[0].s() + onRight * corners[1].s())
                        + upper * (onRight * corners[2].s() + left * corners[3].s()),
                lower * (left * corners[0].t() + onRight * corners[1].t())
                        + upper * (onRight * corners[2].t() + left * corners[3].t()));
    }

    /**
     * u = n·(q × up) / |right × up| and v = n·(right × q) / |right × up| with q from the centre.
     */
    @Override
    public void meet(Ray ray) {
        double slope = normal.x() * ray.dx + normal.y() * ray.dy + normal.z() * ray.dz;
        if (slope == 0) return;
        double height =
                normal.x() * (center.x() - ray.ox)
                        + normal.y() * (center.y() - ray.oy)
                        + normal.z() * (center.z() - ray.oz);
        double t = height / slope;
        if (!ray.takes(t)) return;
        double x = ray.x(t) - center.x();
        double y = ray.y(t) - center.y();
        double z = ray.z(t) - center.z();
        double u = alongNormal(x, y, z, up) / area;
        double v = -alongNormal(x, y, z, right) / area;
        if (Math.abs(u) <= 1 && Math.abs(v) <= 1) finish(u, v, ray.take(t));
    }

    /** n·(q × edge). */
    private double alongNormal(double x, double y, double z, Vector edge) {
        return normal.x() * (y * edge.z() - z * edge.y())
                + normal.y() * (z * edge.x() - x * edge.z())
                + normal.z() * (x * edge.y() - y * edge.x());
    }
}
