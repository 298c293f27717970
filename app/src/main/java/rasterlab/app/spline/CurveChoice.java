package rasterlab.app.spline;

import java.util.ArrayList;
import java.util.List;
import rasterlab.app.spline.curve.CurvePlanning;
import rasterlab.app.spline.curve.Sampling;
import rasterlab.contract.Curve;
import rasterlab.engine.spline.curve.CurvePlace;
import rasterlab.engine.spline.exact.CurveTask;

/**
 * The user's choice, which undo brings back.
 *
 * @param points control points; of Hermite's form start, end and the two derivatives
 * @param joining what stays at the joints of pieces
 * @param method name of the method that draws
 * @param comparison name of a second method, "" for none
 * @param planning whether the plan chooses the method, and for how many drawings
 */
public record CurveChoice(
        CurveForm form,
        List<Place> points,
        CurveJoining joining,
        Sampling sampling,
        String method,
        String comparison,
        CurveOverlays overlays,
        CurvePlanning planning) {
    private static final int SAMPLES = 48;

    public CurveChoice {
        points = List.copyOf(points);
    }

    /** The curves from start to end, at least one. */
    public List<Curve> curves() {
        return form.curves(points);
    }

    /** Where the points' handles are. */
    public List<Place> handles() {
        return form.handles(points);
    }

    /** The box around handles and curves. */
    Extent extent() {
        var places = new ArrayList<>(handles());
        for (Curve curve : curves())
            for (int i = 0; i <= SAMPLES; i++) {
                CurvePlace place = CurvePlace.at(curve, (double) i / SAMPLES);
                places.add(new Place(place.x(), place.y()));
            }
        return Extent.of(places);
    }

    CurveChoice withPoints(List<Place> others) {
        return new CurveChoice(
                form, others, joining, sampling, method, comparison, overlays, planning);
    }

    CurveChoice withForm(CurveForm other) {
        List<Place> next = CurveForm.converted(form, points, other);
        if (other == CurveForm.PIECES) next = joining.everywhere(next);
        return new CurveChoice(
                other, next, joining, sampling, method, comparison, overlays, planning);
    }

    CurveChoice withTask(CurveTask task) {
        var places = new ArrayList<Place>();
        Curve curve = task.curve();
        for (int i = 0; i < curve.x().length; i++)
            places.add(new Place(curve.x()[i], curve.y()[i]));
        return new CurveChoice(
                CurveForm.of(curve.kind()),
                places,
                joining,
                Sampling.of(task),
                method,
                comparison,
                overlays,
                planning);
    }

    CurveChoice withJoining(CurveJoining other) {
        List<Place> joined = form == CurveForm.PIECES ? other.everywhere(points) : points;
        return new CurveChoice(
                form, joined, other, sampling, method, comparison, overlays, planning);
    }

    CurveChoice withSampling(Sampling other) {
        return new CurveChoice(
                form, points, joining, other, method, comparison, overlays, planning);
    }

    CurveChoice withMethod(String other) {
        return new CurveChoice(
                form, points, joining, sampling, other, comparison, overlays, planning);
    }

    CurveChoice withComparison(String other) {
        return new CurveChoice(form, points, joining, sampling, method, other, overlays, planning);
    }

    /** A method that the user chooses is drawn, whatever a plan says. */
    CurveChoice byHand(String other) {
        return withMethod(other).withPlanning(planning.with(false));
    }

    CurveChoice withPlanning(CurvePlanning other) {
        return new CurveChoice(
                form, points, joining, sampling, method, comparison, overlays, other);
    }

    CurveChoice withOverlays(CurveOverlays others) {
        return new CurveChoice(
                form, points, joining, sampling, method, comparison, others, planning);
    }

    CurveChoice moved(int index, Place to) {
        return withPoints(form.moved(points, index, to, joining));
    }

    /** One point more at the end; of pieces one piece more, that goes on smoothly. */
    CurveChoice added(Place at) {
        if (form == CurveForm.HERMITE || !form.allows(points.size(), true)) return this;
        var more = new ArrayList<>(points);
        if (form == CurveForm.PIECES) {
            Place joint = points.get(points.size() - 1);
            Place handle = joint.towards(points.get(points.size() - 2), -1);
            more.add(handle);
            more.add(at.towards(handle, 0.5));
        }
        more.add(at);
        return withPoints(more);
    }

    /** The choice without a point; of pieces without the one that it belongs to. */
    CurveChoice removed(int index) {
        if (form == CurveForm.HERMITE || !form.allows(points.size(), false)) return this;
        var fewer = new ArrayList<>(points);
        if (form == CurveForm.PIECES) {
            int piece = Math.min(index / 3, points.size() / 3 - 1);
            fewer.subList(3 * piece + 1, 3 * piece + 4).clear();
        } else {
            fewer.remove(index);
        }
        return withPoints(fewer);
    }
}
