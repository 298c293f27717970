package rasterlab.app.opengl.state;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/** The lights that the settings ask for. */
final class GlLights {
    private static final double[] FRONT = {1.25, 0.85, 1.9};

    /** A place above the tube's middle, so that the lamp is not in every point's way. */
    private static final double[] INSIDE = {0, 0.25, 0};

    private static final double[][] COLORS = {
        {1, 1, 1},
        {1, 0.8, 0.5},
        {0.5, 0.7, 1},
        {1, 0.5, 0.5},
        {0.5, 1, 0.6},
        {0.8, 0.5, 1},
        {1, 1, 0.5},
        {0.5, 1, 1},
        {1, 0.6, 0.9}
    };

    private GlLights() {}

    static List<GlLight> of(GlChoice choice) {
        int count = (int) choice.number(Setting.LIGHTS);
        var lights = new ArrayList<GlLight>();
        for (int i = 0; i < count; i++) lights.add(light(choice, i, count));
        return List.copyOf(lights);
    }

    private static GlLight light(GlChoice choice, int index, int count) {
        double[] color = COLORS[count == 1 ? 0 : index + 1];
        double share = count > 2 ? 0.4 : 1;
        String[] spot = choice.parts(Setting.SPOT);
        boolean far = choice.is(Setting.LIGHT_PLACE, "far");
        double[] position = position(choice, index, count);
        double[] toMiddle = {-position[0], -position[1], -position[2]};
        if (choice.is(Setting.LIGHT_PLACE, "inside")) toMiddle = new double[] {0, -1, 0.4};
        return new GlLight(
                term(choice, "ambient", color, 0.15 * share),
                term(choice, "diffuse", color, share),
                term(choice, "specular", color, share),
                position,
                toMiddle,
                far ? 180 : Double.parseDouble(spot[0]),
                spot.length > 1 && !far ? Double.parseDouble(spot[1]) : 0,
                far ? new double[] {1, 0, 0} : attenuation(choice));
    }

    private static double[] attenuation(GlChoice choice) {
        return Arrays.stream(choice.parts(Setting.ATTENUATION))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    private static double[] term(GlChoice choice, String name, double[] color, double share) {
        boolean seen =
                choice.is(Setting.LIGHT_TERMS, "all") || choice.is(Setting.LIGHT_TERMS, name);
        double[] term = new double[3];
        for (int c = 0; c < 3; c++) term[c] = seen ? share * color[c] : 0;
        return term;
    }

    /** The first one where the setting says, the others in a ring with it. */
    private static double[] position(GlChoice choice, int index, int count) {
        boolean inside = choice.is(Setting.LIGHT_PLACE, "inside");
        double[] first = inside ? INSIDE : FRONT;
        double around = 2 * Math.PI * index / count;
        double height = inside ? first[1] - 0.12 * index : first[1];
        return new double[] {
            first[0] * Math.cos(around) + first[2] * Math.sin(around),
            height,
            first[2] * Math.cos(around) - first[0] * Math.sin(around),
            choice.is(Setting.LIGHT_PLACE, "far") ? 0 : 1
        };
    }
}
