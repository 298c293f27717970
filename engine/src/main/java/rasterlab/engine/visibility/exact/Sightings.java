package rasterlab.engine.visibility.exact;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Supplier;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.ViewedMesh;

/** The formulas of one view in both kinds of numbers, and what follows from them for each face. */
final class Sightings {
    private final ViewedMesh view;
    private final SightForms<Bounded> near;
    private final SightForms<Dyadic> exact;
    private final int turn;

    Sightings(ViewedMesh view) {
        this.view = view;
        near = new SightForms<>(view, Bounded::of);
        exact = new SightForms<>(view, Dyadic::of);
        turn = exact.determinant().signum();
    }

    ViewedMesh view() {
        return view;
    }

    /** On which side of the edge from vertex a to vertex b pixels are: see {@link SightForms}. */
    PixelSign edge(int a, int b) {
        return sign(
                near.edge(near.seen(a), near.seen(b)),
                () -> exact.edge(exact.seen(a), exact.seen(b)));
    }

    /** Whether rows are below a vertex. */
    PixelSign level(int vertex) {
        return sign(near.level(near.seen(vertex)), () -> exact.level(exact.seen(vertex)));
    }

    private PixelSign sign(Form<Bounded> form, Supplier<Form<Dyadic>> withoutError) {
        return new PixelSign(form, view.fit().width(), view.fit().height(), withoutError);
    }

    /**
     * The row in which a vertex is seen; without a bound where it may be beside or behind the eye.
     */
    Bounded row(int vertex) {
        Triple<Bounded> seen = near.seen(vertex);
        if (seen.z().certainSign() <= 0) return new Bounded(0, Double.POSITIVE_INFINITY);
        return Bounded.of(0).minus(near.level(seen).base()).over(seen.z());
    }

    /** A face's plane in doubles, V above 0 or without a sign. */
    SeenPlane<Bounded> plane(int face, int side) {
        SeenPlane<Bounded> plane = near.plane(face);
        Bounded turned = Bounded.of(side);
        return new SeenPlane<>(plane.u().times(turned), plane.v().times(turned));
    }

    /** A face's plane, V above 0. */
    SeenPlane<Dyadic> exactPlane(int face) {
        SeenPlane<Dyadic> plane = exact.plane(face);
        Dyadic turned = Dyadic.of(plane.v().signum());
        return new SeenPlane<>(plane.u().times(turned), plane.v().times(turned));
    }

    /** The sign of V of a face's plane: 0 for a face that is seen edge-on. */
    int side(int face) {
        int certain = near.plane(face).v().certainSign();
        return certain != 0 ? certain : exact.plane(face).v().signum();
    }

    /** What must be at least 0 where a face's plane is drawn: near, far and clip planes. */
    List<PixelSign> limits(int face, int side) {
        SeenPlane<Bounded> plane = plane(face, side);
        var limits = new ArrayList<PixelSign>();
        if (view.transform().central())
            add(limits, face, plane, SightForms::ahead, SightForms::ahead);
        if (Double.isFinite(view.near()))
            add(limits, face, plane, SightForms::near, SightForms::near);
        if (Double.isFinite(view.far())) add(limits, face, plane, SightForms::far, SightForms::far);
        for (ClipPlane by : view.clipPlanes())
            add(
                    limits,
                    face,
                    plane,
                    (forms, of) -> forms.clip(by, of, turn),
                    (forms, of) -> forms.clip(by, of, turn));
        return limits;
    }

    private void add(
            List<PixelSign> limits,
            int face,
            SeenPlane<Bounded> plane,
            BiFunction<SightForms<Bounded>, SeenPlane<Bounded>, Form<Bounded>> inDoubles,
            BiFunction<SightForms<Dyadic>, SeenPlane<Dyadic>, Form<Dyadic>> exactly) {
        limits.add(
                sign(inDoubles.apply(near, plane), () -> exactly.apply(exact, exactPlane(face))));
    }
}
