package rasterlab.app.coordinates.view;

import java.util.EnumMap;
import java.util.Map;
import rasterlab.app.coordinates.figure.Viewpoint;
import rasterlab.engine.range.Bounds;

/**
 * The user's choice, which undo brings back.
 *
 * @param numbers of all kinds; each kind uses its own
 * @param stable whether the picture plane stands at d = ρ, so that the picture keeps its size
 * @param vertex whose numbers are worked out, from 1
 * @param vanishing whether vanishing points are drawn
 * @param method that sends the points through the matrices
 * @param viewpoint from where spaces with depth are drawn
 */
public record ViewChoice(
        ViewKind kind,
        Map<ViewNumber, Double> numbers,
        boolean stable,
        Stereoscopy stereo,
        int vertex,
        boolean vanishing,
        String method,
        Viewpoint viewpoint) {
    public ViewChoice {
        Bounds.requireAtLeast("vertex", vertex, 1);
        numbers = Map.copyOf(numbers);
    }

    static ViewChoice first() {
        var numbers = new EnumMap<ViewNumber, Double>(ViewNumber.class);
        for (ViewNumber each : ViewNumber.values()) numbers.put(each, each.first());
        return new ViewChoice(
                ViewKind.HOUSE,
                numbers,
                true,
                Stereoscopy.NONE,
                9,
                false,
                "double",
                Viewpoint.FIRST);
    }

    /** d is ρ where the size is kept. */
    double number(ViewNumber which) {
        boolean kept = which == ViewNumber.D && stable;
        return numbers.get(kept ? ViewNumber.RHO : which);
    }

    ViewChoice with(ViewKind other) {
        return new ViewChoice(other, numbers, stable, stereo, vertex, vanishing, method, viewpoint);
    }

    ViewChoice with(ViewNumber which, double value) {
        var changed = new EnumMap<>(numbers);
        changed.put(which, value);
        return new ViewChoice(kind, changed, stable, stereo, vertex, vanishing, method, viewpoint);
    }

    ViewChoice withStable(boolean kept) {
        return new ViewChoice(kind, numbers, kept, stereo, vertex, vanishing, method, viewpoint);
    }

    ViewChoice with(Stereoscopy other) {
        return new ViewChoice(kind, numbers, stable, other, vertex, vanishing, method, viewpoint);
    }

    ViewChoice withVertex(int other) {
        return new ViewChoice(kind, numbers, stable, stereo, other, vanishing, method, viewpoint);
    }

    ViewChoice withVanishing(boolean shown) {
        return new ViewChoice(kind, numbers, stable, stereo, vertex, shown, method, viewpoint);
    }

    ViewChoice withMethod(String other) {
        return new ViewChoice(kind, numbers, stable, stereo, vertex, vanishing, other, viewpoint);
    }

    ViewChoice with(Viewpoint other) {
        return new ViewChoice(kind, numbers, stable, stereo, vertex, vanishing, method, other);
    }

    /** Whether two eyes see two pictures: their plane is the object's, d = ρ. */
    boolean twoEyes() {
        return kind == ViewKind.SPHERICAL_LEFT && stable && stereo != Stereoscopy.NONE;
    }
}
