package rasterlab.engine.visibility.order;

/**
 * One side of a plane, as a bound of a piece of a polygon on the picture.
 *
 * <p>With n·p = c the plane and m·p = k that of the polygon, relative to the eye, the line of sight
 * along r meets the polygon on the near side where (n − m·c/k)·r ≥ 0. Both sides have the same
 * three numbers, so that together they hold every line of sight once.
 *
 * @param near whether it is the near side
 */
public record Cut(double x, double y, double z, boolean near) {
    static Cut of(EyePlane polygon, EyePlane by, boolean near) {
        double share = by.c() == 0 ? 0 : by.c() / polygon.c();
        return new Cut(
                by.nx() - share * polygon.nx(),
                by.ny() - share * polygon.ny(),
                by.nz() - share * polygon.nz(),
                near);
    }
}
