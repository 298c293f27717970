package rasterlab.engine.scene.catalogue;

import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.shape.Cube;
import rasterlab.engine.scene.shape.Revolution;
import rasterlab.engine.scene.shape.SceneShape;
import rasterlab.engine.scene.shape.Sphere;
import rasterlab.engine.scene.shape.Torus;
import rasterlab.engine.transform.SphericalView;

/** One body each. */
final class SolidScenes {
    private SolidScenes() {}

    static Recipe cube() {
        return Recipe.plain(
                "cube",
                () -> {
                    var camera = new SphericalView(Math.PI / 5, Math.PI / 3, 500);
                    return new Parts()
                            .add(Appearances.pictured(Pictures.letters()), new Cube(150))
                            .scene("cube", Lamps.leftOf(camera), camera, 1.9);
                });
    }

    static Recipe sphere() {
        return inSteps("sphere", 32, Appearances.glossy(0xD9534F), new Sphere(100), 1.2);
    }

    static Recipe torus() {
        return inSteps("torus", 48, Appearances.glossy(0x4F9BD9), new Torus(85, 35), 0.85);
    }

    static Recipe revolution() {
        return inSteps("revolution", 40, Appearances.glossy(0xE3C08A), Revolution.vase(), 1.15);
    }

    /**
     * @param phi the eye's angle from the z axis
     */
    private static Recipe inSteps(
            String name, int usual, Appearance finish, SceneShape shape, double phi) {
        return new Recipe(name, usual, detail -> scene(name, finish, shape, phi, detail));
    }

    private static Scene scene(
            String name, Appearance finish, SceneShape shape, double phi, int detail) {
        var camera = new SphericalView(Math.PI / 9, phi, 500);
        return new Parts()
                .add(finish, shape, detail, Math.max(3, detail / 2))
                .scene(name, Lamps.leftOf(camera), camera, 1.9);
    }
}
