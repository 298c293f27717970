package rasterlab.engine.visibility.exact;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.ViewedMesh;

/** The formulas of one view in both kinds of numbers, and what follows from them for each face. */
final class Sightings {
    private final ViewedMesh view;
    private final SightForms<Bounded> near;
    private final SightForms<Dyadic> exact;
    private final int turn;

    /** All vertices, within bounds, as each is asked for by several edges of several faces. */
    private final List<Triple<Bounded>> seen;

    Sightings(ViewedMesh view) {
        this.view = view;
        near = new SightForms<>(view, Bounded::of);
        exact = new SightForms<>(view, Dyadic::of);
        turn = exact.determinant().signum();
        seen =
                IntStream.range(0, view.mesh().vertexCount())
                        .parallel()
                        .mapToObj(near::seen)
                        .toList();
    }

    ViewedMesh view() {
        return view;
    }

    /**
     * The side of the edge from vertex a to vertex b that pixels are on: see {@link SightForms}.
     */
    PixelSign edge(int a, int b) {
        return sign(
                near.edge(seen.get(a), seen.get(b)),
                () -> exact.edge(exact.seen(a), exact.seen(b)));
    }

    /** Whether rows are below a vertex. */
    PixelSign level(int vertex) {
        return sign(near.level(seen.get(vertex)), () -> exact.level(exact.seen(vertex)));
    }

    private PixelSign sign(Form<Bounded> form, Supplier<Form<Dyadic>> withoutError) {
        return new PixelSign(form, view.fit().width(), view.fit().height(), withoutError);
    }

    /**
     * The row in which a vertex is seen; without a bound where it may be beside or behind the eye.
     */
    Bounded row(int vertex) {
        Triple<Bounded> at = seen.get(vertex);
        if (at.z().certainSign() <= 0) return new Bounded(0, Double.POSITIVE_INFINITY);
        return Bounded.of(0).minus(near.level(at).base()).over(at.z());
    }

    /** How a face's plane is seen; empty where edge-on, for then it covers nothing. */
    Optional<PlaneSight> plane(int face) {
        SeenPlane<Bounded> plane = near.plane(face);
        int certain = plane.v().certainSign();
        int side = certain != 0 ? certain : exact.plane(face).v().signum();
        if (side == 0) return Optional.empty();
        var turned = plane.times(Bounded.of(side));
        var nearness =
                new Nearness(
                        turned,
                        view.fit().width(),
                        view.fit().height(),
                        () -> exactPlane(face, side));
        return Optional.of(new PlaneSight(nearness, limits(face, side, turned)));
    }

    private SeenPlane<Dyadic> exactPlane(int face, int side) {
        return exact.plane(face).times(Dyadic.of(side));
    }

    private List<PixelSign> limits(int face, int side, SeenPlane<Bounded> plane) {
        Supplier<SeenPlane<Dyadic>> exactly = () -> exactPlane(face, side);
        var limits = new ArrayList<PixelSign>();
        if (view.transform().central())
            add(limits, plane, exactly, SightForms::ahead, SightForms::ahead);
        if (Double.isFinite(view.near()))
            add(limits, plane, exactly, SightForms::near, SightForms::near);
        if (Double.isFinite(view.far()))
            add(limits, plane, exactly, SightForms::far, SightForms::far);
        for (ClipPlane by : view.clipPlanes())
            add(
                    limits,
                    plane,
                    exactly,
                    (forms, of) -> forms.clip(by, of, turn),
                    (forms, of) -> forms.clip(by, of, turn));
        return limits;
    }

    private void add(
            List<PixelSign> limits,
            SeenPlane<Bounded> plane,
            Supplier<SeenPlane<Dyadic>> exactPlane,
            BiFunction<SightForms<Bounded>, SeenPlane<Bounded>, Form<Bounded>> inDoubles,
            BiFunction<SightForms<Dyadic>, SeenPlane<Dyadic>, Form<Dyadic>> exactly) {
        limits.add(
                sign(inDoubles.apply(near, plane), () -> exactly.apply(exact, exactPlane.get())));
    }
}
