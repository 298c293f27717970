package rasterlab.engine.visibility.hidden;

import java.util.List;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.study.Mutant;
import rasterlab.engine.visibility.FacePaint;
import rasterlab.engine.visibility.PixelPoint;
import rasterlab.engine.visibility.ViewedMesh;
import rasterlab.engine.visibility.Visibility;
import rasterlab.engine.visibility.VisibilityWork;

/** Surfaces hidden with one mistake. */
final class HiddenSurfacesMutants {
    private static final VisibilityWork UNCOUNTED = new VisibilityWork(0, 0, 0, 0);

    private HiddenSurfacesMutants() {}

    static List<Mutant<Visibility>> all() {
        return List.of(
                method("rounded-and-a-corner-less", "vase-mean-z", "painter-textbook"),
                method("mean-depth-decides", "mean-mis-sorts", "painter"),
                method("painted-as-given", "cyclic-overlap", "none"),
                new Mutant<>(
                        "first-painted-stays",
                        "interpenetration",
                        (view, paint, out, cancelled) ->
                                named("none").draw(view, once(paint), out, cancelled)),
                new Mutant<>("later-of-equals", "coplanar", HiddenSurfacesMutants::laterFirst),
                new Mutant<>(
                        "plane-rounding-decides", "coplanar-turned", rays(z -> z, true, false)),
                new Mutant<>("near-does-not-cut", "through-a-face", rays(z -> z, false, false)),
                new Mutant<>("behind-is-before", "behind-the-eye", rays(Math::abs, true, false)),
                new Mutant<>(
                        "parallel-met-first",
                        "edge-on-by-a-hair",
                        rays(z -> Double.isInfinite(z) ? -Double.MAX_VALUE : z, true, true)),
                method("summed-in-24-bits", "long-span-drift", "z24"));
    }

    private static Mutant<Visibility> method(String mistake, String hazard, String name) {
        return new Mutant<>(mistake, hazard, named(name));
    }

    private static Visibility named(String name) {
        return new Visibilities().named(name).implementation();
    }

    private static FacePaint once(FacePaint paint) {
        return (face, y, from, to, out) -> {
            for (int x = from; x < to; x++)
                if (out.argb(x, y) == 0) paint.span(face, y, x, x + 1, out);
        };
    }

    /** A right method on the faces in the opposite order. */
    private static VisibilityWork laterFirst(
            ViewedMesh view, FacePaint paint, Raster out, BooleanSupplier cancelled) {
        Mesh mesh = view.mesh();
        int last = mesh.faceCount() - 1;
        var xyz = new double[3 * mesh.vertexCount()];
        for (int v = 0; v < mesh.vertexCount(); v++) {
            xyz[3 * v] = mesh.x(v);
            xyz[3 * v + 1] = mesh.y(v);
            xyz[3 * v + 2] = mesh.z(v);
        }
        int[][] turned =
                IntStream.rangeClosed(0, last)
                        .mapToObj(
                                f ->
                                        IntStream.range(0, mesh.cornerCount(last - f))
                                                .map(k -> mesh.corner(last - f, k))
                                                .toArray())
                        .toArray(int[][]::new);
        var other =
                new ViewedMesh(
                        new Mesh(xyz, turned),
                        view.transform(),
                        view.fit(),
                        view.near(),
                        view.far());
        return named("scanline")
                .draw(
                        other,
                        (face, y, from, to, picture) ->
                                paint.span(last - face, y, from, to, picture),
                        out,
                        cancelled);
    }

    /**
     * A ray for each pixel, in doubles: of all faces that it meets the one with the least depth.
     *
     * @param depth what is compared
     * @param near whether the near plane cuts
     * @param careless whether a point that is no number counts as inside
     */
    private static Visibility rays(DoubleUnaryOperator depth, boolean near, boolean careless) {
        return (view, paint, out, cancelled) -> {
            for (int y = 0; y < out.height(); y++)
                for (int x = 0; x < out.width(); x++) {
                    int seen = -1;
                    double least = Double.POSITIVE_INFINITY;
                    for (int face = 0; face < view.mesh().faceCount(); face++) {
                        double z = depth.applyAsDouble(meets(view, face, x, y, careless));
                        boolean drawn = z > (near ? view.near() : 0) && z <= view.far();
                        if (!drawn || z >= least) continue;
                        seen = face;
                        least = z;
                    }
                    if (seen >= 0) paint.span(seen, y, x, x + 1, out);
                }
            return UNCOUNTED;
        };
    }

    /** z of the point in which the line of sight through a pixel meets a face, else NaN. */
    private static double meets(ViewedMesh view, int face, int x, int y, boolean careless) {
        boolean central = view.transform().central();
        double across = view.fit().toPlaneX(x + PixelPoint.RIGHT_OF_CENTER);
        double up = view.fit().toPlaneY(y + PixelPoint.BELOW_CENTER);
        double rho = view.transform().distance();
        double nx = view.eyeNormal(face, 0);
        double ny = view.eyeNormal(face, 1);
        double nz = view.eyeNormal(face, 2);
        double z =
                central
                        ? view.planeOffset(face) * rho / (nx * across + ny * up + nz * rho)
                        : (view.planeOffset(face) - nx * across - ny * up) / nz;
        double px = central ? across * z / rho : across;
        double py = central ? up * z / rho : up;
        int corners = view.mesh().cornerCount(face);
        for (int k = 0; k < corners; k++) {
            int a = view.mesh().corner(face, k);
            int b = view.mesh().corner(face, (k + 1) % corners);
            double ex = view.eyeX(b) - view.eyeX(a);
            double ey = view.eyeY(b) - view.eyeY(a);
            double ez = view.eyeZ(b) - view.eyeZ(a);
            double ux = px - view.eyeX(a);
            double uy = py - view.eyeY(a);
            double uz = z - view.eyeZ(a);
            double left =
                    nx * (ey * uz - ez * uy) + ny * (ez * ux - ex * uz) + nz * (ex * uy - ey * ux);
            // Eye space is left-handed: what goes round to the left in the world goes to the right.
            if (left > 0 || Double.isNaN(left) && !careless) return Double.NaN;
        }
        return z;
    }
}
