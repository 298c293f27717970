package rasterlab.engine.scene.shape;

import java.util.List;

/**
 * A torus about the z axis.
 *
 * <p>{@code x = (R + r·cos v)·cos u, y = (R + r·cos v)·sin u, z = r·sin v}; the normal is {@code
 * (cos v·cos u, cos v·sin u, sin v)}; s and t run from 0 to 1 once round in u and v.
 *
 * <p>A ray meets it where {@code (|p|² + R² − r²)² = 4R²·(x² + y²)}, of degree 4 in t. The ray is
 * cut to the ball around the torus first and its middle taken as t = 0, so all coefficients are
 * rounded relative to R⁴: a place lies within about 10⁻¹⁴·R²/r of the torus, plus the rounding of o
 * + t·d; a ray that grazes may count as touching within the same distance.
 *
 * @param major R, world units from the axis to the middle of the tube, above {@code minor}
 * @param minor r, the tube's radius, above 0
 */
public record Torus(double major, double minor) implements SceneShape, Patch {
    /** Keeps the ball's own rounding clear of rays that touch the torus at its equator. */
    private static final double ROOM = 1 + 1e-6;

    public Torus {
        if (!(minor > 0 && minor < major && major < Double.POSITIVE_INFINITY))
            throw new IllegalArgumentException(
                    "torus needs 0 < minor < major < ∞, got minor %s, major %s"
                            .formatted(minor, major));
        Size.require("torus's major", major);
        Size.require("torus's minor", minor);
    }

    @Override
    public List<Patch> patches() {
        return List.of(this);
    }

    @Override
    public Span u() {
        return Span.turn();
    }

    @Override
    public Span v() {
        return Span.turn();
    }

    @Override
    public void at(double u, double v, SurfacePoint out) {
        double round = Span.direction(u);
        double across = Span.direction(v);
        double reach = major + minor * Math.cos(across);
        out.place(reach * Math.cos(round), reach * Math.sin(round), minor * Math.sin(across));
        out.normal(
                Math.cos(across) * Math.cos(round),
                Math.cos(across) * Math.sin(round),
                Math.sin(across));
        out.texture(u().share(u), v().share(v));
    }

    @Override
    public void meet(Ray ray) {
        RayStretch stretch = ray.stretch;
        if (!stretch.cutToBall(ROOM * (major + minor))) return;
        equation(ray, stretch);
        int roots = ray.equation.roots(-1, 1);
        for (int i = 0; i < roots; i++) {
            double t = stretch.at(ray.equation.root(i));
            if (ray.takes(t)) {
                take(ray.take(t));
                return;
            }
        }
    }

    /**
     * Sets up, with p the middle and e = half·d, {@code (a·τ² + 2b·τ + c)² − 4R²·(A·τ² + 2B·τ +
     * C)}. Its value at 0 is multiplied out of what it is the product of, which keeps the digits of
     * the small factor.
     */
    private void equation(Ray ray, RayStretch stretch) {
        double px = ray.x(stretch.middle());
        double py = ray.y(stretch.middle());
        double pz = ray.z(stretch.middle());
        double half = stretch.half();
        double ex = half * ray.dx;
        double ey = half * ray.dy;
        double ez = half * ray.dz;
        double flatA = ex * ex + ey * ey;
        double flatB = px * ex + py * ey;
        double a = flatA + ez * ez;
        double b = flatB + pz * ez;
        double c = px * px + py * py + pz * pz + (major - minor) * (major + minor);
        double rho = Math.hypot(px, py);
        double near = (rho - major) * (rho - major) + pz * pz - minor * minor;
        double far = (rho + major) * (rho + major) + pz * pz - minor * minor;
        double square = 4 * major * major;
        double[] f = ray.equation.start(4);
        f[4] = a * a;
        f[3] = 4 * a * b;
        f[2] = 4 * b * b + 2 * a * c - square * flatA;
        f[1] = 4 * b * c - 2 * square * flatB;
        f[0] = near * far;
    }

    private void take(SurfacePoint out) {
        double rho = Math.hypot(out.x, out.y);
        double offTube = rho - major;
        double length = Math.hypot(offTube, out.z);
        out.normal(offTube * out.x / rho / length, offTube * out.y / rho / length, out.z / length);
        out.texture(Span.share(out.x, out.y), Span.share(offTube, out.z));
    }
}
