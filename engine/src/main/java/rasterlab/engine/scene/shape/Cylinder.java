package rasterlab.engine.scene.shape;

import java.util.ArrayList;
import java.util.List;

/**
 * A cylinder about the z axis, from z = −height/2 to height/2: a tube, closed at its ends or not.
 *
 * <p>The side is {@code x = r·cos u, y = r·sin u, z = v}; s runs from 0 to 1 with u once round, t
 * from the lower end to the upper. An open tube is met from inside as well as from outside.
 *
 * <p>Seen along the axis the side is a circle: a ray meets it as a {@link Sphere} is met, without
 * z, and within the same distance. A ray parallel to the axis never meets the side. Side and discs
 * reach a share of 2⁻⁴⁵ beyond their common rim, so that no ray slips between.
 *
 * @param radius r, world units
 * @param height world units
 * @param bottom whether the lower end is closed
 * @param top whether the upper end is closed
 */
public record Cylinder(double radius, double height, boolean bottom, boolean top)
        implements SceneShape, Patch {
    public Cylinder {
        Size.require("cylinder's radius", radius);
        Size.require("cylinder's height", height);
    }

    /** A tube that is open at both ends. */
    public static Cylinder open(double radius, double height) {
        return new Cylinder(radius, height, false, false);
    }

    /** A cylinder that is closed at both ends. */
    public static Cylinder closed(double radius, double height) {
        return new Cylinder(radius, height, true, true);
    }

    @Override
    public List<Patch> patches() {
        var patches = new ArrayList<Patch>();
        patches.add(this);
        if (bottom) patches.add(new Disc(-height / 2, radius, false));
        if (top) patches.add(new Disc(height / 2, radius, true));
        return patches;
    }

    @Override
    public Span u() {
        return Span.turn();
    }

    @Override
    public Span v() {
        return new Span(-height / 2, height / 2, false);
    }

    @Override
    public void at(double u, double v, SurfacePoint out) {
        double round = Span.direction(u);
        double x = Math.cos(round);
        double y = Math.sin(round);
        out.place(radius * x, radius * y, v);
        out.normal(x, y, 0);
        out.texture(u().share(u), v().share(v));
    }

    @Override
    public boolean isConvexBody() {
        return bottom && top;
    }

    @Override
    public void meet(Ray ray) {
        meetSide(ray);
        if (bottom) Disc.meet(ray, -height / 2, radius, false);
        if (top) Disc.meet(ray, height / 2, radius, true);
    }

    private void meetSide(Ray ray) {
        double square = ray.dx * ray.dx + ray.dy * ray.dy;
        if (square == 0) return;
        double nearest = -(ray.ox * ray.dx + ray.oy * ray.dy) / square;
        double x = ray.x(nearest);
        double y = ray.y(nearest);
        double room = radius * radius - (x * x + y * y);
        if (!(room >= 0)) return;
        double reach = Math.sqrt(room / square);
        double t = isMet(ray, nearest - reach) ? nearest - reach : nearest + reach;
        if (isMet(ray, t)) take(ray.take(t));
    }

    private boolean isMet(Ray ray, double t) {
        return ray.takes(t) && Math.abs(ray.z(t)) <= Disc.BEYOND * height / 2;
    }

    private void take(SurfacePoint out) {
        double length = Math.hypot(out.x, out.y);
        out.normal(out.x / length, out.y / length, 0);
        out.texture(Span.share(out.x, out.y), v().share(out.z));
    }
}
