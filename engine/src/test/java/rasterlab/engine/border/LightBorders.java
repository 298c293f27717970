package rasterlab.engine.border;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import rasterlab.contract.Attenuation;
import rasterlab.contract.ColorModel;
import rasterlab.contract.LightSource;
import rasterlab.contract.LitFace;
import rasterlab.contract.LitPoint;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.color.ColorTopic;
import rasterlab.engine.color.Colors;
import rasterlab.engine.light.UnitVector;
import rasterlab.engine.light.face.FacePoints;
import rasterlab.engine.light.face.FaceTopic;
import rasterlab.engine.light.shade.LitPoints;
import rasterlab.engine.light.shade.ShadeTopic;

/** Points and faces in light, and colours. */
final class LightBorders {
    private static final ShadeTopic SHADE = new ShadeTopic();
    private static final FaceTopic FACE = new FaceTopic();

    /** Checks what the methods' texts say of attenuations above 1. */
    private static final double BRIGHTENING = 10;

    private static final double RIM = 1e-9;
    private static final double LEAST_SHARE = 1e-300;

    /** Checks what the text of shade-face phong says of distances and normals. */
    private static final double NEAR = 0.1;

    /** A cosine nearer to 0 has too few right digits for a power below 1. */
    private static final double STEEP = 1e-4;

    private LightBorders() {}

    static List<Border<?, ?, ?>> all() {
        return List.of(
                Border.of(SHADE, LightBorders::point, LightBorders::noShade).slow(0.4),
                Border.of(FACE, LightBorders::face, LightBorders::noFace).slow(0.5),
                Border.of(new ColorTopic(), LightBorders::color, LightBorders::noColor));
    }

    private static LitPoints point(Draws draws) {
        var point =
                new LitPoint(
                        draws.numbers(3),
                        draws.numbers(3),
                        draws.numbers(3),
                        draws.number(0, Double.MAX_VALUE),
                        material(draws),
                        light(draws),
                        shares(draws, LightSource.BRIGHTEST));
        requireSteady(point.light(), point.toLight(), point.distance());
        return new LitPoints(List.of(point));
    }

    /** Passes where rounding does not grow by the attenuation, nor decides at the cone's rim. */
    private static void requireSteady(LightSource light, double[] toLight, double distance) {
        double factor = light.attenuation().factor(distance);
        double cosine = -cosine(light.cone().direction(), toLight);
        double rim = Math.cos(Math.toRadians(light.cone().cutoff()));
        if (!(factor <= BRIGHTENING) || Math.abs(cosine - rim) < RIM)
            throw new IllegalArgumentException("light is not steady there");
    }

    /** The cosine of the angle between two vectors of any length but 0. */
    private static double cosine(double[] a, double[] b) {
        double[] one = a.clone();
        double[] other = b.clone();
        UnitVector.normalize(one);
        UnitVector.normalize(other);
        return one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
    }

    private static SurfaceMaterial material(Draws draws) {
        return new SurfaceMaterial(
                shares(draws, 1),
                shares(draws, 1),
                shares(draws, 1),
                shares(draws, 1),
                draws.number(0, SurfaceMaterial.HIGHEST_SHININESS));
    }

    /** All around in two of three cases. */
    private static LightSource light(Draws draws) {
        SpotCone cone =
                draws.pick(3) == 2
                        ? new SpotCone(
                                draws.numbers(3),
                                draws.number(0, 90),
                                draws.number(0, SpotCone.HIGHEST_EXPONENT))
                        : SpotCone.none();
        Attenuation attenuation =
                draws.coin()
                        ? new Attenuation(
                                draws.number(0, Double.MAX_VALUE),
                                draws.number(0, Double.MAX_VALUE),
                                draws.number(0, Double.MAX_VALUE))
                        : Attenuation.none();
        return new LightSource(
                shares(draws, LightSource.BRIGHTEST),
                shares(draws, LightSource.BRIGHTEST),
                shares(draws, LightSource.BRIGHTEST),
                attenuation,
                cone);
    }

    private static double[] shares(Draws draws, double most) {
        return new double[] {draws.number(0, most), draws.number(0, most), draws.number(0, most)};
    }

    private static boolean noShade(String method, LitPoints points, String message) {
        var reflection = SHADE.method(method).implementation().reflection();
        return DoubleStream.of(SHADE.exact(points, 1).rgb().get(reflection))
                .anyMatch(Double::isNaN);
    }

    private static FacePoints face(Draws draws) {
        double a = draws.number(0, 1);
        double b = (1 - a) * draws.number(0, 1);
        var face =
                new LitFace(
                        coordinates(draws, 9),
                        coordinates(draws, 9),
                        coordinates(draws, 3),
                        coordinates(draws, 3),
                        material(draws),
                        light(draws),
                        shares(draws, LightSource.BRIGHTEST));
        double[] weights = {a, b, Math.max(0, 1 - a - b)};
        double[] place = mixed(face.corners(), weights);
        double[] toLamp = difference(face.lamp(), place);
        double size = largest(face.corners(), face.lamp(), face.eye());
        if (UnitVector.length(toLamp) < NEAR * size
                || UnitVector.length(difference(face.eye(), place)) < NEAR * size
                || UnitVector.length(mixed(units(face.normals()), weights)) < NEAR)
            throw new IllegalArgumentException("too near, or cancelled out");
        requireSteady(face.light(), toLamp, UnitVector.length(toLamp));
        double[] normal = mixed(units(face.normals()), weights);
        requireSure(face, normal, toLamp, difference(face.eye(), place));
        return new FacePoints(face, weights);
    }

    /** Passes where no highlight is a power below 1 of an r·v next to 0. */
    private static void requireSure(
            LitFace face, double[] normal, double[] toLamp, double[] toEye) {
        double shininess = face.material().shininess();
        double nl = cosine(normal, toLamp);
        double across = 2 * nl * cosine(normal, toEye) - cosine(toLamp, toEye);
        if (shininess > 0 && shininess < 1 && Math.abs(across) < STEEP)
            throw new IllegalArgumentException("too few digits for a power below 1");
    }

    private static double[] mixed(double[] three, double[] weights) {
        var mixed = new double[3];
        for (int i = 0; i < 9; i++) mixed[i % 3] += weights[i / 3] * three[i];
        return mixed;
    }

    private static double[] difference(double[] to, double[] from) {
        return new double[] {to[0] - from[0], to[1] - from[1], to[2] - from[2]};
    }

    private static double[] units(double[] three) {
        var units = new double[9];
        for (int i = 0; i < 9; i += 3) {
            double[] one = {three[i], three[i + 1], three[i + 2]};
            UnitVector.normalize(one);
            System.arraycopy(one, 0, units, i, 3);
        }
        return units;
    }

    private static double largest(double[]... vectors) {
        return Stream.of(vectors).flatMapToDouble(DoubleStream::of).map(Math::abs).max().orElse(0);
    }

    private static double[] coordinates(Draws draws, int count) {
        var numbers = new double[count];
        for (int i = 0; i < count; i++)
            numbers[i] = draws.number(-LitFace.LARGEST, LitFace.LARGEST);
        return numbers;
    }

    private static boolean noFace(String method, FacePoints points, String message) {
        return DoubleStream.of(FACE.exact(points, 1)).anyMatch(Double::isNaN);
    }

    private static Colors color(Draws draws) {
        ColorModel model = ColorModel.values()[draws.pick(ColorModel.values().length)];
        var components = new double[model.size()];
        for (int i = 0; i < components.length; i++)
            components[i] = draws.number(0, model.highest(i));
        return new Colors(model, components);
    }

    /** HVS colours alone can lie outside the cube with each number in its range. */
    private static boolean noColor(String method, Colors colors, String message) {
        boolean small =
                DoubleStream.of(colors.components())
                        .anyMatch(each -> each != 0 && each < LEAST_SHARE);
        return message.contains("must be 0 or at least")
                ? small
                : colors.model() == ColorModel.HVS && message.contains("colour cube");
    }
}
