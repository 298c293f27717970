package rasterlab.engine.scene.catalogue;

import rasterlab.engine.scene.House;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.Vase;

/** The scenes of the course, as it shows them. */
final class WorkedScenes {
    private static final int BACKGROUND_RGB = 0x2B3A4A;

    private WorkedScenes() {}

    static Recipe vase() {
        return Recipe.plain(
                "vase",
                () ->
                        Scene.dull(
                                "vase",
                                Vase.mesh(),
                                Vase.faceRgb(),
                                BACKGROUND_RGB,
                                Vase.CAMERA,
                                1));
    }

    static Recipe house() {
        return Recipe.plain(
                "house",
                () ->
                        Scene.dull(
                                "house",
                                House.mesh(),
                                House.faceRgb(),
                                BACKGROUND_RGB,
                                House.CAMERA,
                                2.5));
    }
}
