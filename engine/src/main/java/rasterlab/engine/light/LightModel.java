package rasterlab.engine.light;

import java.util.List;
import rasterlab.contract.Reflection;

/**
 * The light model of a whole scene.
 *
 * @param globalAmbient light from everywhere, shares of red, green and blue, 0 to 1
 * @param localViewer whether each point has its own direction to the eye, or all have one
 * @param twoSided whether a back is lit by its own material with the normal turned round; otherwise
 *     it is lit as the front is
 * @param reflection the specular term
 * @param lights any number of them
 */
public record LightModel(
        double[] globalAmbient,
        boolean localViewer,
        boolean twoSided,
        Reflection reflection,
        List<Light> lights) {
    /** The ambient light unless another is given, as in OpenGL. */
    public static final double AMBIENT = 0.2;

    public LightModel {
        if (globalAmbient.length != 3)
            throw new IllegalArgumentException(
                    "global-ambient must have 3 numbers, got " + globalAmbient.length);
        for (double share : globalAmbient)
            if (!(share >= 0 && share <= 1))
                throw new IllegalArgumentException(
                        "global-ambient must have shares from 0 to 1, got (%s, %s, %s)"
                                .formatted(globalAmbient[0], globalAmbient[1], globalAmbient[2]));
        globalAmbient = globalAmbient.clone();
        lights = List.copyOf(lights);
    }

    /** The model that OpenGL starts with: dim ambient light, a far viewer, fronts only, n·h. */
    public static LightModel openGl(Light... lights) {
        double[] ambient = {AMBIENT, AMBIENT, AMBIENT};
        return new LightModel(ambient, false, false, Reflection.BLINN_PHONG, List.of(lights));
    }

    /** This model with another specular term. */
    public LightModel with(Reflection other) {
        return new LightModel(globalAmbient, localViewer, twoSided, other, lights);
    }

    /** This model with a direction to the eye for each point. */
    public LightModel withLocalViewer() {
        return new LightModel(globalAmbient, true, twoSided, reflection, lights);
    }

    /** This model with backs lit by themselves. */
    public LightModel withTwoSides() {
        return new LightModel(globalAmbient, localViewer, true, reflection, lights);
    }
}
