package rasterlab.app.light;

import java.util.Locale;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.SpotCone;
import rasterlab.engine.light.Light;

/**
 * A light that can be moved. The sliders give a strength from {@value #FAINTEST} to {@value
 * #STRONGEST}, an attenuation of 0 or more, a cone of 1 to 90 degrees and an exponent up to 128;
 * what an opened input says may lie beyond.
 *
 * @param kind what it is
 * @param on whether it shines
 * @param x world coordinate; of a sun, of the direction to it
 * @param y world coordinate
 * @param z world coordinate
 * @param rgb its colour 0xRRGGBB
 * @param strength of its diffuse and specular light
 * @param constant of the attenuation
 * @param linear of the attenuation, per {@value #UNIT} world units
 * @param quadratic of the attenuation, per square of that
 * @param cutoff half the opening of a spot's cone in degrees
 * @param exponent of the spot's cone
 */
public record Lamp(
        LampKind kind,
        boolean on,
        double x,
        double y,
        double z,
        int rgb,
        double strength,
        double constant,
        double linear,
        double quadratic,
        double cutoff,
        double exponent) {
    public static final double FAINTEST = 0.05;

    public static final double STRONGEST = 20;

    /** World units that a distance of 1 in the attenuation stands for. */
    static final double UNIT = 100;

    /** The kind of a light. */
    public enum LampKind {
        /** Shines from its place all around. */
        POINT,
        /** A sun, infinitely far in its direction. */
        SUN,
        /** Shines from its place in a cone towards the scene's middle. */
        SPOT;

        public String code() {
            return name().toLowerCase(Locale.ROOT);
        }
    }

    /** White, all around, without attenuation. */
    static Lamp at(double x, double y, double z) {
        return new Lamp(LampKind.POINT, true, x, y, z, 0xFFFFFF, 1, 1, 0, 0, 25, 8);
    }

    public Lamp withKind(LampKind other) {
        return new Lamp(
                other, on, x, y, z, rgb, strength, constant, linear, quadratic, cutoff, exponent);
    }

    public Lamp switched(boolean shining) {
        return new Lamp(
                kind, shining, x, y, z, rgb, strength, constant, linear, quadratic, cutoff,
                exponent);
    }

    public Lamp moved(double toX, double toY, double toZ) {
        return new Lamp(
                kind, on, toX, toY, toZ, rgb, strength, constant, linear, quadratic, cutoff,
                exponent);
    }

    public Lamp colored(int other) {
        return new Lamp(
                kind, on, x, y, z, other, strength, constant, linear, quadratic, cutoff, exponent);
    }

    public Lamp withStrength(double other) {
        return new Lamp(
                kind, on, x, y, z, rgb, other, constant, linear, quadratic, cutoff, exponent);
    }

    /** Something stays of the divisor: it is never 0. */
    public Lamp attenuated(double c, double l, double q) {
        boolean none = c == 0 && l == 0 && q == 0;
        return new Lamp(kind, on, x, y, z, rgb, strength, none ? 1 : c, l, q, cutoff, exponent);
    }

    public Lamp withCutoff(double degrees) {
        return new Lamp(
                kind, on, x, y, z, rgb, strength, constant, linear, quadratic, degrees, exponent);
    }

    public Lamp withExponent(double other) {
        return new Lamp(
                kind, on, x, y, z, rgb, strength, constant, linear, quadratic, cutoff, other);
    }

    /** The light that it sends out. */
    public LightSource source() {
        double[] light = {
            strength * (rgb >> 16 & 255) / 255,
            strength * (rgb >> 8 & 255) / 255,
            strength * (rgb & 255) / 255
        };
        Attenuation attenuation =
                kind == LampKind.SUN
                        ? Attenuation.none()
                        : new Attenuation(constant, linear / UNIT, quadratic / (UNIT * UNIT));
        return new LightSource(new double[3], light, light, attenuation, cone());
    }

    private SpotCone cone() {
        boolean aims = kind == LampKind.SPOT && (x != 0 || y != 0 || z != 0);
        return aims ? new SpotCone(new double[] {-x, -y, -z}, cutoff, exponent) : SpotCone.none();
    }

    /** The light from the lamp's place; a sun in the middle shines from above. */
    Light light() {
        boolean middle = x == 0 && y == 0 && z == 0;
        if (kind == LampKind.SUN) return Light.from(source(), x, y, middle ? 1 : z);
        return Light.at(source(), x, y, z);
    }
}
