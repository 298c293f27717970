package rasterlab.engine.scene.shape;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import rasterlab.contract.SplineEnds;
import rasterlab.engine.scene.Vase;

/**
 * A surface of revolution about the z axis: {@code x = r(z)·cos u, y = r(z)·sin u}, r the cubic
 * spline through given radii at given heights.
 *
 * <p>The normal is {@code (cos u, sin u, −r′(z)) / √(1 + r′(z)²)}, exact from the spline's
 * derivative. s runs from 0 to 1 with u once round, t with z from the bottom to the top. Where the
 * radius is 0 at an end, the surface has a point there.
 *
 * <p>On one piece of the spline a ray meets the surface where {@code x² + y² = r(z)²}, of degree 6
 * in t; the ray is cut to the piece and to a ball around everything, and {@link Polynomial} keeps
 * each root between two places of different sign. Coefficients are rounded relative to |p|² of the
 * cut: a place lies within about 10⁻¹⁴·|p|²/r of the surface, plus the rounding of o + t·d; a ray
 * that grazes may count as touching within the same distance. Pieces reach a share of 10⁻¹² beyond
 * their ends, so that no ray slips between.
 */
public final class Revolution implements SceneShape, Patch {
    private static final double BEYOND = 1 + 1e-12;

    final Profile profile;
    private final double reach;
    private final List<Disc> discs = new ArrayList<>();

    /**
     * @param z heights, rising, at least two
     * @param radii as many, at least 0 at both ends and above 0 between them
     * @param ends what the spline keeps to at the ends
     * @param bottom whether a disc closes the lower end
     * @param top whether a disc closes the upper end
     * @throws IllegalArgumentException as the spline does, or if it is not above 0 somewhere
     */
    public Revolution(double[] z, double[] radii, SplineEnds ends, boolean bottom, boolean top) {
        profile = new Profile(z, radii, ends);
        reach = BEYOND * profile.reach();
        if (bottom) discs.add(disc(profile.bottom(), false));
        if (top) discs.add(disc(profile.top(), true));
    }

    private Disc disc(double height, boolean up) {
        double radius = profile.radius(height);
        Size.require("radius of the closed end at z = " + height, radius);
        return new Disc(height, radius, up);
    }

    /** The vase of {@link Vase}, closed below, with a natural spline through its radii. */
    public static Revolution vase() {
        double[] radii = Arrays.stream(Vase.radii()).asDoubleStream().toArray();
        return new Revolution(Vase.heights(), radii, SplineEnds.natural(), true, false);
    }

    @Override
    public List<Patch> patches() {
        var patches = new ArrayList<Patch>();
        patches.add(this);
        patches.addAll(discs);
        return patches;
    }

    @Override
    public Span u() {
        return Span.turn();
    }

    @Override
    public Span v() {
        return new Span(profile.bottom(), profile.top(), false);
    }

    @Override
    public boolean isPole(double v) {
        return (v == profile.bottom() || v == profile.top()) && profile.radius(v) == 0;
    }

    @Override
    public void at(double u, double v, SurfacePoint out) {
        double round = Span.direction(u);
        double x = Math.cos(round);
        double y = Math.sin(round);
        double radius = profile.radius(v);
        out.place(radius * x, radius * y, v);
        normal(x, y, v, out);
        out.texture(u().share(u), v().share(v));
    }

    private void normal(double x, double y, double z, SurfacePoint out) {
        double slope = profile.slope(z);
        double length = Math.hypot(1, slope);
        out.normal(x / length, y / length, -slope / length);
    }

    @Override
    public void meet(Ray ray) {
        meetSide(ray);
        for (int i = 0; i < discs.size(); i++) discs.get(i).meet(ray);
    }

    /** The pieces in the ray's own order, so the first place is the nearest. */
    private void meetSide(Ray ray) {
        if (!ray.stretch.cutToBall(reach)) return;
        int pieces = profile.pieces();
        for (int k = 0; k < pieces; k++) {
            int piece = ray.dz < 0 ? pieces - 1 - k : k;
            if (!ray.stretch.cutToLayer(profile.knot(piece), profile.knot(piece + 1))) continue;
            equation(ray, piece);
            int roots = ray.equation.roots(-BEYOND, BEYOND);
            for (int i = 0; i < roots; i++) {
                double t = ray.stretch.at(ray.equation.root(i));
                if (ray.takes(t)) {
                    take(ray.take(t));
                    return;
                }
            }
        }
    }

    /**
     * x² + y² − r² with r = r₀ + r₁·τ + r₂·τ² + r₃·τ³, the spline's piece from the middle of the
     * stretch.
     */
    private void equation(Ray ray, int piece) {
        double px = ray.x(ray.stretch.middle());
        double py = ray.y(ray.stretch.middle());
        double h = ray.z(ray.stretch.middle()) - profile.knot(piece);
        double ex = ray.stretch.half() * ray.dx;
        double ey = ray.stretch.half() * ray.dy;
        double ez = ray.stretch.half() * ray.dz;
        double c1 = profile.c(piece, 1);
        double c2 = profile.c(piece, 2);
        double c3 = profile.c(piece, 3);
        double r0 = profile.c(piece, 0) + h * (c1 + h * (c2 + h * c3));
        double r1 = ez * (c1 + h * (2 * c2 + h * 3 * c3));
        double r2 = ez * ez * (c2 + h * 3 * c3);
        double r3 = ez * ez * ez * c3;
        double rho = Math.hypot(px, py);
        double[] f = ray.equation.start(6);
        f[0] = (rho - r0) * (rho + r0);
        f[1] = 2 * (px * ex + py * ey - r0 * r1);
        f[2] = ex * ex + ey * ey - r1 * r1 - 2 * r0 * r2;
        f[3] = -2 * (r0 * r3 + r1 * r2);
        f[4] = -r2 * r2 - 2 * r1 * r3;
        f[5] = -2 * r2 * r3;
        f[6] = -r3 * r3;
    }

    private void take(SurfacePoint out) {
        double rho = Math.hypot(out.x, out.y);
        if (rho == 0) out.normal(0, 0, out.z - profile.bottom() < profile.top() - out.z ? -1 : 1);
        else normal(out.x / rho, out.y / rho, out.z, out);
        out.texture(Span.share(out.x, out.y), v().share(out.z));
    }
}
