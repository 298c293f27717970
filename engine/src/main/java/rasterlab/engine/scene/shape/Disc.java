package rasterlab.engine.scene.shape;

/**
 * A disc across the z axis, closing a surface about it.
 *
 * <p>u is the angle, v runs from 0 in the middle to 1 at the rim where the disc looks down, and the
 * other way where it looks up. Texture: the picture's inscribed circle, s along x; t along y, or
 * against it where the disc looks down, so that nothing is mirrored.
 */
record Disc(double height, double radius, boolean up) implements Patch {
    /** Rims are met a little beyond, times this. */
    static final double BEYOND = 1 + 0x1p-45;

    @Override
    public boolean isFlat() {
        return true;
    }

    @Override
    public Span u() {
        return Span.turn();
    }

    @Override
    public Span v() {
        return up ? new Span(1, 0, false) : new Span(0, 1, false);
    }

    @Override
    public boolean isPole(double v) {
        return v == 0;
    }

    @Override
    public int vSteps(int asked) {
        return 1;
    }

    @Override
    public void at(double u, double v, SurfacePoint out) {
        double round = Span.direction(u);
        double reach = radius * v;
        out.place(reach * Math.cos(round), reach * Math.sin(round), height);
        finish(out, radius, up);
    }

    private static void finish(SurfacePoint out, double radius, boolean up) {
        out.normal(0, 0, up ? 1 : -1);
        double half = 2 * radius;
        out.texture(0.5 + out.x / half, 0.5 + (up ? out.y : -out.y) / half);
    }

    void meet(Ray ray) {
        meet(ray, height, radius, up);
    }

    static void meet(Ray ray, double height, double radius, boolean up) {
        if (ray.dz == 0) return;
        double t = (height - ray.oz) / ray.dz;
        if (!ray.takes(t)) return;
        double x = ray.x(t);
        double y = ray.y(t);
        if (x * x + y * y > BEYOND * radius * radius) return;
        SurfacePoint out = ray.take(t);
        out.z = height;
        finish(out, radius, up);
    }
}
