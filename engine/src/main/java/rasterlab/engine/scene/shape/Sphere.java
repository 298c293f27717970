package rasterlab.engine.scene.shape;

import java.util.List;

/**
 * A sphere about the origin: {@code x = r·cos v·cos u, y = r·cos v·sin u, z = r·sin v}.
 *
 * <p>s runs from 0 to 1 with u once round the z axis, t from the lower pole to the upper.
 *
 * <p>A ray comes nearest to the origin at t₀ = −o·d / d·d, at a distance q, and meets the sphere
 * {@code √((r² − q²) / d·d)} before and after. A place lies within a few units of the last place of
 * |o| + r of the sphere; where q comes that close to r, rounding decides whether the ray touches.
 *
 * @param radius r, world units
 */
public record Sphere(double radius) implements SceneShape, Patch {
    public Sphere {
        Size.require("sphere's radius", radius);
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
        return new Span(-Math.PI / 2, Math.PI / 2, false);
    }

    @Override
    public boolean isPole(double v) {
        return Math.abs(v) == Math.PI / 2;
    }

    @Override
    public void at(double u, double v, SurfacePoint out) {
        double round = Span.direction(u);
        double reach = isPole(v) ? 0 : Math.cos(v);
        double x = reach * Math.cos(round);
        double y = reach * Math.sin(round);
        double z = Math.sin(v);
        out.place(radius * x, radius * y, radius * z);
        out.normal(x, y, z);
        out.texture(u().share(u), v().share(v));
    }

    @Override
    public boolean isConvexBody() {
        return true;
    }

    @Override
    public void meet(Ray ray) {
        double square = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
        double nearest = -(ray.ox * ray.dx + ray.oy * ray.dy + ray.oz * ray.dz) / square;
        double x = ray.x(nearest);
        double y = ray.y(nearest);
        double z = ray.z(nearest);
        double room = radius * radius - (x * x + y * y + z * z);
        if (!(room >= 0)) return;
        double reach = Math.sqrt(room / square);
        double t = ray.takes(nearest - reach) ? nearest - reach : nearest + reach;
        if (ray.takes(t)) take(ray.take(t));
    }

    private void take(SurfacePoint out) {
        double flat = Math.hypot(out.x, out.y);
        double length = Math.hypot(flat, out.z);
        out.normal(out.x / length, out.y / length, out.z / length);
        out.texture(Span.share(out.x, out.y), v().share(Math.atan2(out.z, flat)));
    }
}
