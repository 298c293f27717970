package rasterlab.engine.visibility.exact;

import java.util.function.DoubleFunction;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.transform.PictureFit;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.ClipPlane;
import rasterlab.engine.visibility.PixelPoint;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The formulas of a view, in numbers of either kind: what a pixel's line of sight meets.
 *
 * <p>The given numbers are taken as they are: coordinates of the mesh, entries of the matrix A from
 * world to eye, ρ, and what takes the picture plane to pixels. The line of sight through pixel (x,
 * y) has the direction {@code d = (s·X, s·Y, s·ρ)}, X and Y on the picture plane; in parallel
 * projection, where the eye is at infinity, (s·X, s·Y, s) stands for it, and (x, y, 1) for a corner
 * (x, y, z). Then in both projections {@code n·d} is linear in the pixel and tells by its sign on
 * which side of a plane through the eye the line of sight passes; n is the cross product of two
 * corners of an edge.
 *
 * @param <S> the kind of the numbers
 */
final class SightForms<S extends Scalar<S>> {
    private final ViewedMesh view;
    private final DoubleFunction<S> number;
    private final boolean central;
    private final Triple<S> toX;
    private final Triple<S> toY;
    private final Triple<S> toZ;
    private final Triple<S> moved;
    private final S scale;
    private final S firstX;
    private final S firstY;

    /** The third coordinate of d, the same for all pixels. */
    private final S along;

    SightForms(ViewedMesh view, DoubleFunction<S> number) {
        this.view = view;
        this.number = number;
        ViewTransform transform = view.transform();
        central = transform.central();
        toX = row(0);
        toY = row(1);
        toZ = row(2);
        moved =
                new Triple<>(
                        number.apply(transform.entry(0, 3)),
                        number.apply(transform.entry(1, 3)),
                        number.apply(transform.entry(2, 3)));
        PictureFit fit = view.fit();
        scale = number.apply(fit.pixelsPerUnit());
        firstX =
                number.apply(PixelPoint.RIGHT_OF_CENTER - fit.centerX())
                        .minus(scale.times(number.apply(fit.eyeX())));
        firstY = number.apply(fit.centerY() - PixelPoint.BELOW_CENTER);
        along = central ? scale.times(number.apply(transform.distance())) : scale;
    }

    private Triple<S> row(int axis) {
        ViewTransform transform = view.transform();
        return new Triple<>(
                number.apply(transform.entry(axis, 0)),
                number.apply(transform.entry(axis, 1)),
                number.apply(transform.entry(axis, 2)));
    }

    private Triple<S> given(int vertex) {
        Mesh mesh = view.mesh();
        return new Triple<>(
                number.apply(mesh.x(vertex)),
                number.apply(mesh.y(vertex)),
                number.apply(mesh.z(vertex)));
    }

    private Triple<S> turned(Triple<S> way) {
        return new Triple<>(toX.dot(way), toY.dot(way), toZ.dot(way));
    }

    private Triple<S> eye(int vertex) {
        return turned(given(vertex)).plus(moved);
    }

    /** A vertex as {@link #edge} and {@link #level} take it. */
    Triple<S> seen(int vertex) {
        Triple<S> eye = eye(vertex);
        return central ? eye : new Triple<>(eye.x(), eye.y(), number.apply(1));
    }

    /** The form n·d. */
    private Form<S> side(S nx, S ny, S nz) {
        S base = nx.times(firstX).plus(ny.times(firstY)).plus(nz.times(along));
        return new Form<>(base, nx, zero().minus(ny));
    }

    private S zero() {
        return number.apply(0);
    }

    /**
     * The form that says on which side of an edge from a to b pixels are: above 0 on its left, y
     * upwards.
     */
    Form<S> edge(Triple<S> a, Triple<S> b) {
        Triple<S> n = a.cross(b);
        return side(n.x(), n.y(), n.z());
    }

    /**
     * The form above 0 in rows below a vertex before the eye, 0 in its own; the same in all
     * columns.
     */
    Form<S> level(Triple<S> vertex) {
        S base = along.times(vertex.y()).minus(firstY.times(vertex.z()));
        return new Form<>(base, zero(), vertex.z());
    }

    /**
     * The plane of a face. Its normal is the sum of the cross products of a fan, twice the vector
     * area; it passes through the first corner. V may have either sign yet, or be 0: edge-on.
     */
    SeenPlane<S> plane(int face) {
        Mesh mesh = view.mesh();
        Triple<S> first = given(mesh.corner(face, 0));
        Triple<S> n = new Triple<>(zero(), zero(), zero());
        Triple<S> last = turned(given(mesh.corner(face, 1)).minus(first));
        for (int k = 2; k < mesh.cornerCount(face); k++) {
            Triple<S> next = turned(given(mesh.corner(face, k)).minus(first));
            n = n.plus(last.cross(next));
            last = next;
        }
        S offset = n.dot(turned(first).plus(moved));
        return central
                ? new SeenPlane<>(side(n.x(), n.y(), n.z()), offset)
                : new SeenPlane<>(side(n.x(), n.y(), zero().minus(offset)), n.z());
    }

    /** The form at least 0 where a plane is before the eye in perspective. */
    Form<S> ahead(SeenPlane<S> plane) {
        return plane.u();
    }

    /** The form at least 0 where a plane is not before the near plane. */
    Form<S> near(SeenPlane<S> plane) {
        S near = number.apply(view.near());
        return central
                ? zeroForm().plus(along.times(plane.v())).minus(plane.u().times(near))
                : zeroForm()
                        .minus(plane.u())
                        .plus(zero().minus(scale.times(near).times(plane.v())));
    }

    /** The form at least 0 where a plane is not behind the far plane. */
    Form<S> far(SeenPlane<S> plane) {
        S far = number.apply(view.far());
        return central
                ? plane.u().times(far).plus(zero().minus(along.times(plane.v())))
                : plane.u().plus(scale.times(far).times(plane.v()));
    }

    /**
     * The form at least 0 where a plane is on the drawn side of a clip plane n·p + e ≥ 0 of eye
     * space, which the inverse of A takes it to: times det A, whose sign {@code turn} is, so that
     * nothing is divided.
     */
    Form<S> clip(ClipPlane plane, SeenPlane<S> of, int turn) {
        Triple<S> given =
                new Triple<>(
                        number.apply(turn * plane.a()),
                        number.apply(turn * plane.b()),
                        number.apply(turn * plane.c()));
        var n =
                new Triple<>(
                        toY.cross(toZ).dot(given),
                        toZ.cross(toX).dot(given),
                        toX.cross(toY).dot(given));
        S e = determinant().times(number.apply(turn * plane.d())).minus(n.dot(moved));
        Form<S> u = central ? side(n.x(), n.y(), n.z()) : side(n.x(), n.y(), e);
        S v = central ? e : zero().minus(n.z());
        return u.times(of.v()).plus(of.u().times(v));
    }

    /** det A. */
    S determinant() {
        return toX.dot(toY.cross(toZ));
    }

    private Form<S> zeroForm() {
        return new Form<>(zero(), zero(), zero());
    }
}
