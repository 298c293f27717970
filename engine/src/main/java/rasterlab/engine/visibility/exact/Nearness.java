package rasterlab.engine.visibility.exact;

import java.util.function.Supplier;

/**
 * The nearness of a plane at each pixel, U/V of {@link SeenPlane}, to be compared with others.
 *
 * <p>In doubles each is off by its bound at most; where two differ by more than both bounds, that
 * decides. Otherwise the sign of U₁·V₂ − U₂·V₁ does.
 */
final class Nearness {
    private final double base;
    private final double perColumn;
    private final double perRow;
    private final double bound;
    private final Supplier<SeenPlane<Dyadic>> exact;
    private volatile SeenPlane<Dyadic> known;

    Nearness(SeenPlane<Bounded> plane, int width, int height, Supplier<SeenPlane<Dyadic>> exact) {
        var quotient =
                new Form<>(
                        plane.u().base().over(plane.v()),
                        plane.u().perColumn().over(plane.v()),
                        plane.u().perRow().over(plane.v()));
        base = quotient.base().value();
        perColumn = quotient.perColumn().value();
        perRow = quotient.perRow().value();
        bound = PixelSign.bound(quotient, width, height);
        this.exact = exact;
    }

    /** 1 where this plane is nearer than another, 0 where equally near, −1 where farther. */
    int compare(Nearness other, int x, int y) {
        double here = base + x * perColumn + y * perRow;
        double there = other.base + x * other.perColumn + y * other.perRow;
        double doubt = (bound + other.bound) * Bounded.ROUNDED_UP;
        if (here - there > doubt) return 1;
        if (there - here > doubt) return -1;
        return PixelSign.at(plane().before(other.plane()), x, y);
    }

    private SeenPlane<Dyadic> plane() {
        if (known == null) known = exact.get();
        return known;
    }
}
