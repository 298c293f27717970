package rasterlab.app.spline.curve;

import java.util.ArrayList;
import java.util.List;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.curve.CurvePlace;

/**
 * Teeth along curves, as long as the curvature is large, on the outer side of each bend.
 *
 * <p>Nine tenths of the teeth are at most {@value #LENGTH} of the points' extent long; a cusp's
 * tooth, which has no end, is cut at {@value #LONGEST} times that.
 *
 * @param teeth of all curves in order
 */
public record CurvatureComb(List<Tooth> teeth) {
    private static final double LENGTH = 0.09;
    private static final double LONGEST = 1.5;
    private static final int TEETH = 160;

    /**
     * A tooth from a point of the curve outward.
     *
     * @param first whether a new curve or span begins, so that no line joins it to the one before
     */
    public record Tooth(double x, double y, double outX, double outY, boolean first) {}

    /**
     * @param extent pixels
     */
    public static CurvatureComb of(List<Curve> curves, double extent) {
        int spans = curves.stream().mapToInt(Curve::spans).sum();
        int each = Math.max(4, TEETH / spans);
        var places = new ArrayList<CurvePlace>();
        for (Curve curve : curves)
            for (int span = 0; span < curve.spans(); span++)
                for (int i = 0; i <= each; i++)
                    places.add(CurvePlace.of(curve, span, (double) i / each));
        double usual = usual(places);
        if (!(usual > 0) || !(extent > 0)) return new CurvatureComb(List.of());
        var teeth = new ArrayList<Tooth>();
        for (CurvePlace place : places) {
            double share = clamped(place.curvature() / usual);
            double length = Double.isNaN(share) ? 0 : share * LENGTH * extent;
            double speed = Math.max(place.speed(), Double.MIN_NORMAL);
            teeth.add(
                    new Tooth(
                            place.x(),
                            place.y(),
                            place.x() + place.dy() / speed * length,
                            place.y() - place.dx() / speed * length,
                            place.u() == 0));
        }
        return new CurvatureComb(List.copyOf(teeth));
    }

    private static double usual(List<CurvePlace> places) {
        double[] sizes =
                places.stream()
                        .mapToDouble(place -> Math.abs(place.curvature()))
                        .filter(Double::isFinite)
                        .sorted()
                        .toArray();
        return sizes.length == 0 ? 0 : sizes[sizes.length * 9 / 10];
    }

    private static double clamped(double share) {
        return Math.max(-LONGEST, Math.min(LONGEST, share));
    }
}
