package rasterlab.engine.transform.view;

import java.util.Arrays;
import java.util.List;
import rasterlab.contract.EyeView;
import rasterlab.engine.study.Slip;

/** Views from an eye at other angles or at another distance. */
final class ViewSlips {
    private ViewSlips() {}

    static List<Slip<EyeView>> of(EyeView right) {
        return List.of(
                Slip.of(
                        "theta-from-another-axis",
                        (theta, phi, rho, p) -> right.view(theta + 90, phi, rho, p),
                        (theta, phi, rho, p) -> right.view(theta - 90, phi, rho, p),
                        (theta, phi, rho, p) -> right.view(theta + 180, phi, rho, p),
                        (theta, phi, rho, p) -> right.view(90 - theta, phi, rho, p)),
                Slip.of("theta-ignored", (theta, phi, rho, p) -> right.view(0, phi, rho, p)),
                Slip.of(
                        "phi-ignored",
                        (theta, phi, rho, p) -> right.view(theta, 0, rho, p),
                        (theta, phi, rho, p) -> right.view(theta, 90, rho, p)),
                Slip.of(
                        "phi-the-wrong-way",
                        (theta, phi, rho, p) -> right.view(theta, -phi, rho, p)),
                Slip.of(
                        "distance-subtracted",
                        (theta, phi, rho, p) -> {
                            right.view(theta, phi, rho, p);
                            for (int i = 2; i < p.length; i += 3) p[i] -= 2 * rho;
                        }),
                Slip.of(
                        "moved-before-the-rotation",
                        moved(right, 0),
                        moved(right, 1),
                        moved(right, 2)),
                Slip.of(
                        "distance-not-used-for-eye",
                        (theta, phi, rho, p) -> right.view(theta, phi, 1, p)),
                Slip.of("first-point-only", some(right, 3)),
                Slip.of(
                        "last-point-left-out",
                        (theta, phi, rho, p) -> part(right, theta, phi, rho, p, p.length - 3)));
    }

    /** Moves along an axis of the world by ρ, then turns. */
    private static EyeView moved(EyeView right, int axis) {
        return (theta, phi, rho, p) -> {
            for (int i = axis; i < p.length; i += 3) p[i] += rho;
            right.view(theta, phi, rho, p);
            for (int i = 2; i < p.length; i += 3) p[i] -= rho;
        };
    }

    private static EyeView some(EyeView right, int numbers) {
        return (theta, phi, rho, p) -> part(right, theta, phi, rho, p, numbers);
    }

    private static void part(
            EyeView right, double theta, double phi, double rho, double[] p, int numbers) {
        double[] first = Arrays.copyOf(p, Math.max(0, Math.min(numbers, p.length)));
        right.view(theta, phi, rho, first);
        System.arraycopy(first, 0, p, 0, first.length);
    }
}
