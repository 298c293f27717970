package rasterlab.engine.pipeline.paint;

import java.util.List;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Mesh;

/**
 * How far light mixed from a face's corners may be from the formula at each pixel, in levels.
 *
 * <p>Mixing is linear interpolation on triangles. With x = Σλᵢ·vᵢ its error is {@code ½·Σ λᵢ·f″(vᵢ
 * − x)²}, and as {@code Σ λᵢ·|vᵢ − x|² ≤ h²/3} for a longest side h, at most {@code M/6} with M the
 * largest second derivative along a side. That is found for each light from how far normal, light
 * and eye turn over the face ({@link TurningDirection}):
 *
 * <pre>
 * (a·b)″ ≤ |a″| + 2·|a′|·|b′| + |b″|
 * (cosˢ φ)″ ≤ s·cosˢ⁻¹ φ·(cos φ)″ + s·(s − 1)·cosˢ⁻² φ·sin² φ·(|a′| + |b′|)²
 * </pre>
 *
 * with φ over all the angles that the face can have. Where n·l changes its sign, max(0, n·l) has a
 * crease: mixing is off by at most p·q/(p + q), p and q being the most on either side, and the
 * highlight, which ends there, counts whole. A lamp's strength f, which falls off with the distance
 * and in its cone ({@link LightFalloff}), is a factor: {@code (f·c)″ ≤ |f″|·c + 2·|f′|·|c′| +
 * f·|c″|}.
 *
 * <p>Source of the interpolation bound: S. Waldron, The error in linear interpolation at the
 * vertices of a simplex, SIAM Journal on Numerical Analysis 35(3), 1998.
 */
final class CornerLightBound {
    private static final double NONE = Double.POSITIVE_INFINITY;

    private final FaceLights lights;
    private final Mesh mesh;
    private final LightModel model;
    private final boolean far;
    private final double[] eye;
    private final double turn;

    /**
     * @param turn how far, in radians, the direction to the eye may still turn
     */
    CornerLightBound(FaceLights lights, double turn) {
        this.lights = lights;
        this.turn = turn;
        mesh = lights.mesh();
        model = lights.model();
        far = !model.localViewer();
        var transform = lights.view().transform();
        eye = new double[3];
        for (int axis = 0; axis < 3; axis++)
            eye[axis] = far ? -transform.sight(axis) : transform.toWorld(axis, 0, 0, 0);
    }

    /** Infinity where there is no bound. */
    double levels(int face) {
        if (mesh.hasColors()) return NONE;
        boolean back = lights.seenFromBehind(face);
        boolean own = back && model.twoSided();
        Appearance finish = lights.scene().finish(face);
        SurfaceMaterial surface = (own ? finish.back() : finish.front()).surface();
        var normal = TurningDirection.ofNormals(mesh, face, own ? -1 : 1);
        var toEye = TurningDirection.towards(mesh, face, eye, far);
        if (normal.wild() || toEye.wild()) return NONE;
        double sum = 0;
        List<Light> all = model.lights();
        for (int i = 0; i < all.size() && sum < NONE; i++)
            sum += levels(all.get(i), surface, face, normal, toEye);
        return sum;
    }

    private double levels(
            Light light,
            SurfaceMaterial surface,
            int face,
            TurningDirection normal,
            TurningDirection toEye) {
        LightSource source = light.source();
        double everywhere = most(surface.ambient(), source.ambient());
        double dull = most(surface.diffuse(), source.diffuse());
        boolean shines = model.reflection() != Reflection.LAMBERT;
        double shiny = shines ? most(surface.specular(), source.specular()) : 0;
        if (everywhere == 0 && dull == 0 && shiny == 0) return 0;
        double[] place = {light.x(), light.y(), light.z()};
        var toLight = TurningDirection.towards(mesh, face, place, light.directional());
        if (toLight.wild()) return NONE;
        var falloff = LightFalloff.of(light, mesh, face, toLight);
        if (Double.isInfinite(falloff.bend())) return NONE;
        double bend = TurningDirection.product(normal, toLight) / 6;
        double ambient = everywhere == 0 ? 0 : everywhere * falloff.bend() / 6;
        double least = 1;
        double most = -1;
        for (int k = 0; k < normal.size(); k++) {
            double cosine = normal.dot(k, toLight, k);
            least = Math.min(least, cosine);
            most = Math.max(most, cosine);
        }
        if (most <= -bend) return 255 * ambient;
        boolean crease = least < bend;
        double over = Math.max(0, most + bend);
        double under = Math.max(0, bend - least);
        double dullError =
                falloff.times(1, normal.speed() + toLight.speed(), 6 * bend) / 6
                        + (crease ? falloff.most() * over * under / (over + under) : 0);
        double shinyError = 0;
        if (shiny > 0)
            shinyError = highlight(surface.shininess(), crease, normal, toLight, toEye, falloff);
        return 255 * (ambient + dull * dullError + shiny * shinyError);
    }

    /** The error of f·cosˢ φ, f being a lamp's strength. */
    private double highlight(
            double s,
            boolean crease,
            TurningDirection normal,
            TurningDirection toLight,
            TurningDirection toEye,
            LightFalloff falloff) {
        boolean half = model.reflection() == Reflection.BLINN_PHONG;
        TurningDirection one = half ? normal : TurningDirection.mirrored(normal, toLight);
        TurningDirection other = half ? TurningDirection.between(toLight, toEye) : toEye;
        if (one.wild() || other.wild()) return falloff.most();
        double speed = one.speed() + other.speed();
        double slack = speed + (half ? turn / 2 : turn);
        double from = 0;
        double to = Math.PI;
        for (int k = 0; k < one.size(); k++) {
            double phi = Math.acos(Math.max(-1, Math.min(1, one.dot(k, other, k))));
            from = Math.max(from, phi - slack);
            to = Math.min(to, phi + slack);
        }
        if (from >= Math.PI / 2) return 0;
        double brightest = Math.pow(Math.cos(from), s);
        if (crease || s < 2) return falloff.most() * brightest;
        double bend = TurningDirection.product(one, other);
        double slope = s * Math.pow(Math.cos(from), s - 1);
        double second = slope * bend + s * (s - 1) * steepest(s, from, to) * speed * speed;
        return Math.min(
                falloff.most() * brightest, falloff.times(brightest, slope * speed, second) / 6);
    }

    /** The most of cosˢ⁻² φ·sin² φ over an interval; its peak is where tan² φ = 2/(s − 2). */
    static double steepest(double s, double from, double to) {
        double peak = s > 2 ? Math.atan(Math.sqrt(2 / (s - 2))) : Math.PI / 2;
        double phi = Math.max(from, Math.min(Math.min(to, Math.PI / 2), peak));
        double sine = Math.sin(phi);
        return Math.pow(Math.max(0, Math.cos(phi)), s - 2) * sine * sine;
    }

    private static double most(double[] surface, double[] light) {
        double most = 0;
        for (int c = 0; c < 3; c++) most = Math.max(most, surface[c] * light[c]);
        return most;
    }
}
