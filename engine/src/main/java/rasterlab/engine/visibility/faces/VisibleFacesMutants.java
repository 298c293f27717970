package rasterlab.engine.visibility.faces;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.VisibleFaces;
import rasterlab.engine.study.Mutant;

/** Sides of faces, asked with one mistake. */
final class VisibleFacesMutants {
    /** The answer of a mistaken method for one face. */
    private interface Judge {
        boolean visible(AskedFace asked);
    }

    /** One face, and who looks at it. */
    private record AskedFace(double[] xyz, int[] face, double[] eye, double[] inside) {
        /** The side of the face's plane that a point is on. */
        int side(double[] point) {
            return side(face, point);
        }

        int side(int[] corners, double[] point) {
            return new FaceSide(xyz).of(corners, point[0], point[1], point[2]);
        }

        /** n·(point − c₀) in doubles, each coordinate times {@code scale}. */
        double value(double[] point, double scale) {
            double[] scaled = Arrays.stream(xyz).map(v -> v * scale).toArray();
            double sum = 0;
            for (int k = 1; k + 1 < face.length; k++) {
                double[] b = way(scaled, face[k]);
                double[] c = way(scaled, face[k + 1]);
                for (int i = 0; i < 3; i++) {
                    double cross =
                            b[(i + 1) % 3] * c[(i + 2) % 3] - b[(i + 2) % 3] * c[(i + 1) % 3];
                    sum += (point[i] * scale - scaled[3 * face[0] + i]) * cross;
                }
            }
            return sum;
        }

        private double[] way(double[] scaled, int to) {
            var way = new double[3];
            for (int i = 0; i < 3; i++) way[i] = scaled[3 * to + i] - scaled[3 * face[0] + i];
            return way;
        }

        double[] mean() {
            var mean = new double[3];
            for (int i = 0; i < xyz.length; i++) mean[i % 3] += xyz[i] / (xyz.length / 3);
            return mean;
        }

        double toUnit() {
            return 1 / Arrays.stream(xyz).map(Math::abs).max().orElse(1);
        }

        /** Whether products are beyond a double, so that another mistake shows. */
        boolean leavesTheRange() {
            return toUnit() < 1e-100;
        }

        boolean areaIsNothing() {
            for (int i = 0; i < 3; i++) {
                double[] aside = {xyz[3 * face[0]], xyz[3 * face[0] + 1], xyz[3 * face[0] + 2]};
                aside[i]++;
                if (side(aside) != 0) return false;
            }
            return true;
        }
    }

    private VisibleFacesMutants() {}

    static List<Mutant<VisibleFaces>> all() {
        return List.of(
                mutant("edge-on-visible", "edge-on", asked -> edgeOn(asked)),
                mutant(
                        "rounding-decides",
                        "edge-on-by-rounding",
                        asked -> asked.value(asked.eye, asked.toUnit()) > 0),
                mutant(
                        "absolute-epsilon",
                        "tiny",
                        asked -> asked.side(asked.eye) > 0 && asked.value(asked.eye, 1) > 1e-9),
                mutant(
                        "products-overflow",
                        "huge",
                        asked ->
                                asked.side(asked.eye) > 0
                                        && Double.isFinite(asked.value(asked.eye, 1))),
                mutant(
                        "first-three-corners",
                        "corner-on-an-edge",
                        asked -> asked.side(Arrays.copyOf(asked.face, 3), asked.eye) > 0),
                mutant(
                        "mean-is-inside",
                        "not-convex",
                        asked -> asked.side(asked.eye) * asked.side(asked.mean()) < 0),
                mutant(
                        "inner-point-unchecked",
                        "inner-point-before-a-face",
                        asked ->
                                asked.inside.length == 0
                                        ? asked.side(asked.eye) > 0
                                        : asked.side(asked.eye) * asked.side(asked.inside) < 0),
                mutant("direction-from-the-middle", "eye-inside", VisibleFacesMutants::byDirection),
                mutant(
                        "no-area-visible",
                        "no-area",
                        asked -> asked.side(asked.eye) > 0 || asked.areaIsNothing()),
                mutant(
                        "turned-away",
                        "cube",
                        asked -> asked.side(asked.eye) * (asked.leavesTheRange() ? 1 : -1) > 0));
    }

    /** Whether a face with area is visible, edge-on ones too. */
    private static boolean edgeOn(AskedFace asked) {
        return asked.side(asked.eye) >= 0 && !asked.areaIsNothing();
    }

    private static boolean byDirection(AskedFace asked) {
        double[] mean = asked.mean();
        var point = new double[3];
        for (int i = 0; i < 3; i++)
            point[i] = asked.xyz[3 * asked.face[0] + i] + asked.eye[i] - mean[i];
        return asked.side(point) > 0;
    }

    private static Mutant<VisibleFaces> mutant(String mistake, String hazard, Judge judge) {
        return new Mutant<>(
                mistake,
                hazard,
                (xyz, faces, eye, inside) -> {
                    var visible = new boolean[faces.length];
                    for (int f = 0; f < visible.length; f++)
                        visible[f] = judge.visible(new AskedFace(xyz, faces[f], eye, inside));
                    return visible;
                });
    }
}
