package rasterlab.engine.scene.catalogue;

import java.util.List;
import java.util.Optional;
import rasterlab.engine.naming.Named;
import rasterlab.engine.scene.Scene;

/** The scenes that can be named. */
public final class Scenes {
    /** The fewest faces once round a surface. */
    public static final int COARSEST = Recipe.COARSEST;

    /** The most. */
    public static final int FINEST = Recipe.FINEST;

    private static final List<Recipe> RECIPES =
            List.of(
                    WorkedScenes.vase(),
                    WorkedScenes.house(),
                    SolidScenes.cube(),
                    SolidScenes.sphere(),
                    SolidScenes.torus(),
                    SolidScenes.revolution(),
                    OrderScenes.cyclicOverlap(),
                    OrderScenes.interpenetrating(),
                    OrderScenes.coplanar(),
                    OrderScenes.nearPlane(),
                    TextureScenes.quad(),
                    TextureScenes.globe(),
                    GlassScenes.sphereAndCylinder(),
                    GlassScenes.transparency());

    private static final List<Usual> USUAL = RECIPES.stream().map(Usual::new).toList();

    private Scenes() {}

    /** A scene in its usual detail, made when it is first asked for. */
    private static final class Usual {
        private final Recipe recipe;
        private Optional<Scene> made = Optional.empty();

        Usual(Recipe recipe) {
            this.recipe = recipe;
        }

        String name() {
            return recipe.name();
        }

        synchronized Scene scene() {
            if (made.isEmpty()) made = Optional.of(recipe.usual());
            return made.get();
        }
    }

    /** All names, in teaching order. */
    public static List<String> names() {
        return RECIPES.stream().map(Recipe::name).toList();
    }

    /** All scenes in their usual detail, in teaching order. */
    public static List<Scene> all() {
        return USUAL.stream().map(Usual::scene).toList();
    }

    /**
     * A scene in its usual detail.
     *
     * @throws IllegalArgumentException for an unknown name; the message lists the known ones
     */
    public static Scene named(String name) {
        return Named.find("scene", name, USUAL, Usual::name).scene();
    }

    /**
     * A scene whose surfaces are made of so many steps.
     *
     * @param detail faces once round a surface, {@value Recipe#COARSEST} to {@value Recipe#FINEST}
     * @throws IllegalArgumentException for an unknown name, another detail, or a scene that is not
     *     made in steps
     */
    public static Scene named(String name, int detail) {
        return Named.find("scene", name, RECIPES, Recipe::name).inDetail(detail);
    }

    /** The names of the scenes that are made in steps. */
    public static List<String> namesWithDetail() {
        return RECIPES.stream().filter(Recipe::hasDetail).map(Recipe::name).toList();
    }
}
