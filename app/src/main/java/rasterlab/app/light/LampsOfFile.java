package rasterlab.app.light;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.SpotCone;
import rasterlab.engine.light.Light;
import rasterlab.engine.scene.SceneLight;

/** The lights of a scene file as lamps of the lab, where they shine the same. */
final class LampsOfFile {
    /** Share by which numbers may differ and still be one: they were divided and rounded. */
    private static final double SAME = 1e-9;

    private LampsOfFile() {}

    /** The choice with the light of a file; empty where no lamps of the lab shine so. */
    static Optional<LightChoice> lit(LightChoice choice, SceneLight light) {
        double[] everywhere = light.model().globalAmbient();
        boolean gray = everywhere[0] == everywhere[1] && everywhere[1] == everywhere[2];
        List<Light> lights = light.model().lights();
        if (!gray || light.atEye().isPresent() || lights.size() > LightChoice.MOST_LAMPS)
            return Optional.empty();
        var lamps = new ArrayList<Lamp>();
        for (Light each : lights) {
            Optional<Lamp> lamp = lamp(each);
            if (lamp.isEmpty()) return Optional.empty();
            lamps.add(lamp.get());
        }
        if (lamps.isEmpty()) lamps.add(LightChoice.first().lamp().switched(false));
        return Optional.of(
                choice.withLamps(lamps)
                        .withAmbient(everywhere[0])
                        .with(light.model().reflection())
                        .withLocalViewer(light.model().localViewer())
                        .withTwoSides(light.model().twoSided()));
    }

    private static Optional<Lamp> lamp(Light light) {
        LightSource source = light.source();
        Lamp white = Lamp.at(light.x(), light.y(), light.z());
        SpotCone cone = source.cone();
        if (light.directional()) white = white.withKind(Lamp.LampKind.SUN);
        else if (!cone.shinesAllAround())
            white =
                    white.withKind(Lamp.LampKind.SPOT)
                            .withCutoff(cone.cutoff())
                            .withExponent(cone.exponent());
        Attenuation a = source.attenuation();
        double unit = Lamp.UNIT;
        Lamp lamp = white.attenuated(a.constant(), a.linear() * unit, a.quadratic() * unit * unit);
        return colored(lamp, source.diffuse()).filter(found -> same(found.light(), light));
    }

    /** The brightest channel counts most in a colour of 8 bits and its strength. */
    private static Optional<Lamp> colored(Lamp lamp, double[] rgb) {
        double most = Math.max(rgb[0], Math.max(rgb[1], rgb[2]));
        if (most == 0) return Optional.of(lamp.colored(0));
        for (int level = 255; level > 0; level--) {
            double strength = most * 255 / level;
            int color = 0;
            boolean whole = strength >= Lamp.FAINTEST && strength <= Lamp.STRONGEST;
            for (double channel : rgb) {
                double exact = 255 * channel / strength;
                whole &= Math.abs(exact - Math.rint(exact)) < SAME * 255;
                color = color << 8 | (int) Math.rint(exact);
            }
            if (whole) return Optional.of(lamp.colored(color).withStrength(strength));
        }
        return Optional.empty();
    }

    private static boolean same(Light one, Light other) {
        return one.directional() == other.directional()
                && same(numbers(one.source()), numbers(other.source()))
                && same(direction(one), direction(other));
    }

    private static double[] direction(Light light) {
        SpotCone cone = light.source().cone();
        if (cone.shinesAllAround()) return new double[] {light.x(), light.y(), light.z()};
        double[] to = cone.direction();
        double length = Math.sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]);
        return new double[] {
            light.x(), light.y(), light.z(), to[0] / length, to[1] / length, to[2] / length
        };
    }

    private static double[] numbers(LightSource source) {
        Attenuation a = source.attenuation();
        double[] rest = {
            a.constant(),
            a.linear(),
            a.quadratic(),
            source.cone().cutoff(),
            source.cone().exponent()
        };
        double[] all = Arrays.copyOf(rest, 14);
        System.arraycopy(source.ambient(), 0, all, 5, 3);
        System.arraycopy(source.diffuse(), 0, all, 8, 3);
        System.arraycopy(source.specular(), 0, all, 11, 3);
        return all;
    }

    private static boolean same(double[] one, double[] other) {
        if (one.length != other.length) return false;
        for (int i = 0; i < one.length; i++) if (!same(one[i], other[i])) return false;
        return true;
    }

    static boolean same(double one, double other) {
        return Math.abs(one - other) <= SAME * Math.max(Math.abs(one), Math.abs(other));
    }
}
