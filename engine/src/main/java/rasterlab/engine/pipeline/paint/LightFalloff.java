package rasterlab.engine.pipeline.paint;

import rasterlab.contract.Attenuation;
import rasterlab.contract.SpotCone;
import rasterlab.engine.light.Light;
import rasterlab.engine.scene.Mesh;

/**
 * How a lamp's strength changes over a face: g(d)·cosᵉ α, d the distance and α the angle off the
 * cone's axis.
 *
 * <p>With P = constant + linear·d + quadratic·d², g = 1/P. Along a side of length h run through
 * from 0 to 1, |d′| ≤ a, the most of the side along the direction to the lamp, and 0 ≤ d″ ≤ h²/d,
 * so that
 *
 * <pre>
 * |g′| ≤ P′·g²·a
 * |g″| ≤ (2·P′²·g³ + P″·g²)·a² + P′·g²·h²/d
 * </pre>
 *
 * with g at the least distance and P′ = linear + 2·quadratic·d at the largest. A face on a cone's
 * rim has no bound; one beyond it has no light.
 *
 * @param most at least the strength
 * @param speed at least |f′|
 * @param bend at least |f″|; infinite where there is no bound
 */
record LightFalloff(double most, double speed, double bend) {
    private static final LightFalloff WILD =
            new LightFalloff(
                    Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);

    private static final LightFalloff DARK = new LightFalloff(0, 0, 0);

    /** Error of an angle at the rim by rounding, in radians. */
    private static final double ROUNDING = 1e-6;

    /**
     * @param toLight from the face to the lamp
     */
    static LightFalloff of(Light light, Mesh mesh, int face, TurningDirection toLight) {
        if (light.directional()) return new LightFalloff(1, 0, 0);
        LightFalloff far = withDistance(light, mesh, face, toLight);
        SpotCone cone = light.source().cone();
        if (cone.shinesAllAround()) return far;
        LightFalloff aside = inCone(cone, toLight);
        if (aside.equals(DARK)) return DARK;
        if (aside.equals(WILD) || far.equals(WILD)) return WILD;
        return new LightFalloff(
                far.most * aside.most,
                far.speed * aside.most + far.most * aside.speed,
                far.times(aside.most, aside.speed, aside.bend));
    }

    /**
     * The largest second derivative of the strength times something.
     *
     * @param value the most of it
     * @param slope the most of its derivative
     * @param second the most of its second derivative
     */
    double times(double value, double slope, double second) {
        if (equals(DARK)) return 0;
        return bend * value + 2 * speed * slope + most * second;
    }

    private static LightFalloff withDistance(
            Light light, Mesh mesh, int face, TurningDirection toLight) {
        Attenuation falls = light.source().attenuation();
        if (falls.linear() == 0 && falls.quadratic() == 0)
            return new LightFalloff(1 / falls.constant(), 0, 0);
        double nearest = Double.POSITIVE_INFINITY;
        double farthest = 0;
        double side = 0;
        for (int k = 0; k < mesh.cornerCount(face); k++) {
            int v = mesh.corner(face, k);
            double d = apart(mesh, v, light.x(), light.y(), light.z());
            nearest = Math.min(nearest, d);
            farthest = Math.max(farthest, d);
            for (int j = 0; j < k; j++) {
                int w = mesh.corner(face, j);
                side = Math.max(side, apart(mesh, v, mesh.x(w), mesh.y(w), mesh.z(w)));
            }
        }
        double least = nearest - side;
        if (!(least > 0)) return WILD;
        double g = falls.factor(least);
        double along = Math.min(side, along(mesh, face, toLight) + toLight.speed() * side);
        double rise = (falls.linear() + 2 * falls.quadratic() * farthest) * g;
        double slope = rise * along;
        double bend =
                2 * slope * slope
                        + 2 * falls.quadratic() * g * along * along
                        + rise * side * side / least;
        return new LightFalloff(g, slope * g, bend * g);
    }

    /** The most of a side along the direction to the lamp from a corner. */
    private static double along(Mesh mesh, int face, TurningDirection toLight) {
        double most = 0;
        double[] at = toLight.at();
        for (int k = 0; k < mesh.cornerCount(face); k++)
            for (int i = 0; i < mesh.cornerCount(face); i++)
                for (int j = 0; j < i; j++) {
                    int v = mesh.corner(face, i);
                    int w = mesh.corner(face, j);
                    double part =
                            at[3 * k] * (mesh.x(v) - mesh.x(w))
                                    + at[3 * k + 1] * (mesh.y(v) - mesh.y(w))
                                    + at[3 * k + 2] * (mesh.z(v) - mesh.z(w));
                    most = Math.max(most, Math.abs(part));
                }
        return most;
    }

    private static double apart(Mesh mesh, int v, double x, double y, double z) {
        double dx = mesh.x(v) - x;
        double dy = mesh.y(v) - y;
        double dz = mesh.z(v) - z;
        return Math.sqrt(dx * dx + dy * dy + dz * dz);
    }

    private static LightFalloff inCone(SpotCone cone, TurningDirection toLight) {
        double[] axis = cone.direction();
        double length = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        double from = 0;
        double to = Math.PI;
        double outermost = 0;
        for (int k = 0; k < toLight.size(); k++) {
            double cosine = 0;
            for (int i = 0; i < 3; i++) cosine -= toLight.at()[3 * k + i] * axis[i] / length;
            double alpha = Math.acos(Math.max(-1, Math.min(1, cosine)));
            from = Math.max(from, alpha - toLight.speed());
            to = Math.min(to, alpha + toLight.speed());
            outermost = Math.max(outermost, alpha);
        }
        double rim = Math.toRadians(cone.cutoff());
        if (from > rim + ROUNDING) return DARK;
        if (to > rim - ROUNDING || outermost > rim - ROUNDING) return WILD;
        double e = cone.exponent();
        if (e == 0) return new LightFalloff(1, 0, 0);
        // Powers of the cosine that are negative are largest at the other end.
        double slope = e * Math.pow(Math.cos(e < 1 ? to : from), e - 1);
        double curve = e * Math.abs(e - 1) * Math.pow(Math.cos(e < 2 ? to : from), e - 2);
        double speed = toLight.speed();
        return new LightFalloff(
                Math.pow(Math.cos(from), e),
                slope * speed,
                slope * toLight.bend() + curve * speed * speed);
    }
}
