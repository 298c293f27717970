package rasterlab.app.light;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.LitPoint;
import rasterlab.contract.Reflection;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.light.Material;
import rasterlab.engine.light.SpecularCosine;
import rasterlab.engine.light.shade.FormulaShader;
import rasterlab.engine.light.shade.Terms;
import rasterlab.engine.range.Bounds;
import rasterlab.engine.transform.ViewTransform;
import rasterlab.engine.visibility.SeenPoint;
import rasterlab.engine.visibility.ViewedMesh;

/**
 * The formula at a point of the surface, with its mixed normal, in numbers.
 *
 * @param face number of the face
 * @param position world coordinates
 * @param normal of length 1, to the side that is lit
 * @param own emission and ambient light: red, green, blue
 * @param lamps what each lamp that shines adds
 * @param sum of all, cut to 1
 * @param toEye from there to the eye
 */
public record PointReading(
        int face,
        double[] position,
        double[] normal,
        double[] own,
        List<OfLamp> lamps,
        double[] sum,
        double[] toEye) {
    /**
     * @param number the lamp's, from 1
     * @param diffuse cosine n·l, 0 where the lamp is behind
     * @param mirrored the cosine of the specular term
     * @param factor attenuation times cone
     * @param added red, green, blue
     */
    public record OfLamp(
            int number, double diffuse, double mirrored, double factor, double[] added) {
        public OfLamp {
            Bounds.requireAtLeast("number", number, 1);
        }
    }

    static PointReading of(LightChoice choice, ViewedMesh view, SeenPoint seen) {
        Material material = LightTerm.only(choice.terms(), choice.material().material());
        double[] position = seen.position();
        double[] normal = normal(choice, seen);
        double[] toEye = toEye(choice, view.transform(), position);
        var lamps = new ArrayList<OfLamp>();
        double[] everywhere = choice.model().globalAmbient();
        double[] own = new double[3];
        for (int c = 0; c < 3; c++)
            own[c] =
                    material.surface().emission()[c]
                            + everywhere[c] * material.surface().ambient()[c];
        double[] sum = own.clone();
        for (int i = 0; i < choice.lamps().size(); i++) {
            Lamp lamp = choice.lamps().get(i);
            if (!lamp.on()) continue;
            OfLamp added = of(i + 1, lamp, material, choice.reflection(), position, normal, toEye);
            lamps.add(added);
            for (int c = 0; c < 3; c++) sum[c] += added.added()[c];
        }
        for (int c = 0; c < 3; c++) sum[c] = Math.min(1, sum[c]);
        return new PointReading(seen.face(), position, normal, own, List.copyOf(lamps), sum, toEye);
    }

    /** The point in the light of the selected lamp; empty where the lamp is in the point. */
    public Optional<LitPoint> lit(LightChoice choice) {
        Material material = LightTerm.only(choice.terms(), choice.material().material());
        double[] everywhere = choice.model().globalAmbient();
        return lit(choice.lamp(), material, position, normal, toEye, everywhere);
    }

    private static Optional<LitPoint> lit(
            Lamp lamp,
            Material material,
            double[] point,
            double[] normal,
            double[] toEye,
            double[] everywhere) {
        Light light = lamp.light();
        double[] toLight = {light.x(), light.y(), light.z()};
        if (!light.directional()) for (int c = 0; c < 3; c++) toLight[c] -= point[c];
        double distance = length(toLight);
        return distance == 0
                ? Optional.empty()
                : Optional.of(
                        new LitPoint(
                                normal,
                                toLight,
                                toEye,
                                distance,
                                material.surface(),
                                light.source(),
                                everywhere));
    }

    /** The normal to the side that is lit. */
    static double[] normal(LightChoice choice, SeenPoint seen) {
        double[] normal = seen.normal();
        if (choice.twoSided() && seen.behind()) for (int c = 0; c < 3; c++) normal[c] = -normal[c];
        return normal;
    }

    static double[] toEye(LightChoice choice, ViewTransform transform, double[] point) {
        var toEye = new double[3];
        for (int axis = 0; axis < 3; axis++)
            toEye[axis] =
                    choice.localViewer()
                            ? transform.toWorld(axis, 0, 0, 0) - point[axis]
                            : -transform.sight(axis);
        return toEye;
    }

    private static OfLamp of(
            int number,
            Lamp lamp,
            Material material,
            Reflection reflection,
            double[] point,
            double[] normal,
            double[] toEye) {
        double[] none = new double[3];
        Optional<LitPoint> lit = lit(lamp, material, point, normal, toEye, none);
        if (lit.isEmpty()) return new OfLamp(number, 0, 0, 1, none);
        Terms terms = new FormulaShader(reflection).terms(lit.get());
        var added = new double[3];
        for (int c = 0; c < 3; c++)
            added[c] = terms.ambient()[c] + terms.diffuse()[c] + terms.specular()[c];
        double[] l = unit(lit.get().toLight());
        double[] v = unit(toEye);
        double diffuse = normal[0] * l[0] + normal[1] * l[1] + normal[2] * l[2];
        double mirrored =
                diffuse <= 0
                        ? 0
                        : SpecularCosine.cosine(
                                reflection,
                                normal[0],
                                normal[1],
                                normal[2],
                                l[0],
                                l[1],
                                l[2],
                                v[0],
                                v[1],
                                v[2]);
        return new OfLamp(
                number, Math.max(0, diffuse), mirrored, terms.attenuation() * terms.cone(), added);
    }

    private static double length(double[] v) {
        return Math.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    }

    private static double[] unit(double[] v) {
        double length = length(v);
        return new double[] {v[0] / length, v[1] / length, v[2] / length};
    }
}
