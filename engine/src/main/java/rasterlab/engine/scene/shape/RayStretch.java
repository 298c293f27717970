package rasterlab.engine.scene.shape;

/**
 * The part of a ray inside something simple, beyond its least t and before the nearest place met:
 * {@code t = middle + half·τ} with τ from −1 to 1.
 */
final class RayStretch {
    private final Ray ray;
    private double begin;
    private double end;
    private double middle;
    private double half;

    RayStretch(Ray ray) {
        this.ray = ray;
    }

    double middle() {
        return middle;
    }

    double half() {
        return half;
    }

    double at(double tau) {
        return middle + half * tau;
    }

    /**
     * Cuts to |p| ≤ radius.
     *
     * @return whether anything is left
     */
    boolean cutToBall(double radius) {
        double square = ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz;
        double nearest = -(ray.ox * ray.dx + ray.oy * ray.dy + ray.oz * ray.dz) / square;
        double x = ray.x(nearest);
        double y = ray.y(nearest);
        double z = ray.z(nearest);
        double room = radius * radius - (x * x + y * y + z * z);
        if (!(room > 0)) return false;
        double reach = Math.sqrt(room / square);
        begin = Math.max(nearest - reach, ray.least());
        end = Math.min(nearest + reach, ray.t());
        return center(begin, end);
    }

    /**
     * Cuts what {@link #cutToBall} left to low ≤ z ≤ high.
     *
     * @return whether anything is left
     */
    boolean cutToLayer(double low, double high) {
        if (ray.dz == 0) return low <= ray.oz && ray.oz <= high && center(begin, end);
        double one = (low - ray.oz) / ray.dz;
        double other = (high - ray.oz) / ray.dz;
        return center(Math.max(begin, Math.min(one, other)), Math.min(end, Math.max(one, other)));
    }

    private boolean center(double from, double to) {
        middle = from + (to - from) / 2;
        half = (to - from) / 2;
        return half > 0;
    }
}
