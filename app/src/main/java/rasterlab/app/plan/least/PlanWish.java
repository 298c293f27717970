package rasterlab.app.plan.least;

import java.util.Optional;
import rasterlab.engine.plan.Tolerance;
import rasterlab.engine.range.Bounds;

/**
 * The user's wishes for the least picture.
 *
 * @param on whether it is drawn
 * @param pixels how far things may be out of place, {@value #LEAST_PIXELS} to {@value #MOST_PIXELS}
 * @param levels how far a channel of 0 to 255 may be off, 0 to {@value #MOST_LEVELS}
 * @param magnified whether the difference from the full picture is shown in place of the picture
 */
public record PlanWish(boolean on, double pixels, double levels, boolean magnified) {
    public static final double LEAST_PIXELS = 0.1;
    public static final double MOST_PIXELS = 5;
    public static final double MOST_LEVELS = 16;

    /** The wishes at first: the full picture, and what {@code ./lab plan} allows. */
    public static final PlanWish FIRST = new PlanWish(false, 0.5, 2, false);

    public PlanWish {
        Bounds.require("pixels", pixels, LEAST_PIXELS, MOST_PIXELS);
        Bounds.require("levels", levels, 0, MOST_LEVELS);
    }

    public PlanWish with(boolean drawn) {
        return new PlanWish(drawn, pixels, levels, magnified);
    }

    public PlanWish withPixels(double other) {
        return new PlanWish(on, other, levels, magnified);
    }

    public PlanWish withLevels(double other) {
        return new PlanWish(on, pixels, other, magnified);
    }

    public PlanWish withMagnified(boolean shown) {
        return new PlanWish(on, pixels, levels, shown);
    }

    /** The tolerance of the picture; empty for the full one. */
    public Optional<Tolerance> tolerance() {
        return on ? Optional.of(new Tolerance(pixels, levels, 0)) : Optional.empty();
    }
}
