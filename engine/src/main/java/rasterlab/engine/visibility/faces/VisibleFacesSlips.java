package rasterlab.engine.visibility.faces;

import java.util.List;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.study.Slip;

/** Faces judged by a mistaken plane, inner point or direction. */
final class VisibleFacesSlips {
    private VisibleFacesSlips() {}

    static List<Slip<VisibleFaces>> of(VisibleFaces right) {
        return List.of(
                Slip.of(
                        "order-of-vertices-trusted",
                        (xyz, faces, eye, inside) -> each(faces, f -> at(xyz, f, eye, 0) > 0),
                        (xyz, faces, eye, inside) -> each(faces, f -> at(xyz, f, eye, 0) < 0)),
                Slip.of(
                        "plane-through-the-origin",
                        (xyz, faces, eye, inside) ->
                                each(
                                        faces,
                                        f ->
                                                dot(normal(xyz, f, 0), eye)
                                                                * dot(
                                                                        normal(xyz, f, 0),
                                                                        inner(xyz, inside))
                                                        < 0)),
                Slip.of("sign-in-the-cross-product", crossed(1), crossed(2), crossed(4)),
                Slip.of(
                        "sum-for-mean",
                        (xyz, faces, eye, inside) -> judged(xyz, faces, eye, sum(xyz), 0)),
                Slip.of(
                        "origin-for-inner-point",
                        (xyz, faces, eye, inside) -> judged(xyz, faces, eye, new double[3], 0)),
                Slip.of(
                        "first-vertex-for-inner-point",
                        (xyz, faces, eye, inside) ->
                                judged(xyz, faces, eye, new double[] {xyz[0], xyz[1], xyz[2]}, 0)),
                Slip.of(
                        "z-of-normal-decides",
                        (xyz, faces, eye, inside) -> each(faces, f -> normal(xyz, f, 0)[2] > 0),
                        (xyz, faces, eye, inside) -> each(faces, f -> normal(xyz, f, 0)[2] < 0)));
    }

    private interface Judge {
        boolean visible(int[] face);
    }

    private static boolean[] each(int[][] faces, Judge judge) {
        var visible = new boolean[faces.length];
        for (int i = 0; i < faces.length; i++) visible[i] = judge.visible(faces[i]);
        return visible;
    }

    /**
     * The cross product with other signs.
     *
     * @param signs a bit for each component that has the wrong one
     */
    private static VisibleFaces crossed(int signs) {
        return (xyz, faces, eye, inside) -> judged(xyz, faces, eye, inner(xyz, inside), signs);
    }

    private static boolean[] judged(
            double[] xyz, int[][] faces, double[] eye, double[] inner, int signs) {
        return each(faces, f -> at(xyz, f, eye, signs) * at(xyz, f, inner, signs) < 0);
    }

    private static double[] inner(double[] xyz, double[] inside) {
        if (inside.length > 0) return inside;
        double[] mean = sum(xyz);
        for (int k = 0; k < 3; k++) mean[k] *= 3.0 / xyz.length;
        return mean;
    }

    private static double[] sum(double[] xyz) {
        var sum = new double[3];
        for (int i = 0; i < xyz.length; i++) sum[i % 3] += xyz[i];
        return sum;
    }

    private static double at(double[] xyz, int[] face, double[] point, int signs) {
        double[] from = {
            point[0] - xyz[3 * face[0]],
            point[1] - xyz[3 * face[0] + 1],
            point[2] - xyz[3 * face[0] + 2]
        };
        return dot(normal(xyz, face, signs), from);
    }

    private static double[] normal(double[] xyz, int[] face, int signs) {
        var n = new double[3];
        for (int k = 0; k < face.length; k++) {
            int a = 3 * face[k];
            int b = 3 * face[(k + 1) % face.length];
            n[0] += xyz[a + 1] * xyz[b + 2] - xyz[a + 2] * xyz[b + 1];
            n[1] += xyz[a + 2] * xyz[b] - xyz[a] * xyz[b + 2];
            n[2] += xyz[a] * xyz[b + 1] - xyz[a + 1] * xyz[b];
        }
        for (int k = 0; k < 3; k++) if ((signs & 1 << k) != 0) n[k] = -n[k];
        return n;
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }
}
