package rasterlab.engine.plan;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import rasterlab.engine.pipeline.RenderRequest;
import rasterlab.engine.pipeline.RequestView;
import rasterlab.engine.pipeline.paint.FaceLights;
import rasterlab.engine.pipeline.paint.MixedLight;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.shape.SceneShape;
import rasterlab.engine.scene.shape.ShapeSurfaces;
import rasterlab.engine.sight.SightFacts;

/**
 * A scene and all that plans have found out about it whatever the camera: found when it is first
 * needed, kept with the scene.
 *
 * <p>One thread at a time.
 */
final class KnownScene {
    /** Scenes with fewer faces that are kept, the last ones. */
    private static final int COARSER = 6;

    private final Scene scene;
    private final SightFacts facts;
    private Optional<SceneSample> sample = Optional.empty();
    private Optional<LeastLight> light = Optional.empty();
    private Optional<List<ShapePart>> parts = Optional.empty();
    private final Map<String, MixedLight.Apart> apart = new HashMap<>();
    private final Map<List<Integer>, Scene> coarser =
            new LinkedHashMap<>(16, 0.75f, true) {
                @Override
                protected boolean removeEldestEntry(Map.Entry<List<Integer>, Scene> eldest) {
                    return size() > COARSER;
                }
            };
    private double contrastLimit = Double.NaN;
    private int contrast;

    KnownScene(Scene scene, SightFacts facts) {
        this.scene = scene;
        this.facts = facts;
    }

    /** Whether this is known of a scene. */
    boolean of(Scene other) {
        return alike(scene, other);
    }

    /** Whether a plan of one scene is a plan of another: they differ in their names at most. */
    private static boolean alike(Scene scene, Scene other) {
        return scene == other
                || scene.mesh() == other.mesh()
                        && scene.light().equals(other.light())
                        && scene.finishes().equals(other.finishes())
                        && scene.surfaces().equals(other.surfaces())
                        && scene.backgroundRgb() == other.backgroundRgb()
                        && scene.pictureScale() == other.pictureScale()
                        && Arrays.equals(scene.finishOf(), other.finishOf());
    }

    /** Whether two pictures differ in nothing but the camera and the depths that go with it. */
    static boolean alike(RenderRequest picture, RenderRequest other) {
        return alike(picture.scene(), other.scene())
                && picture.width() == other.width()
                && picture.height() == other.height()
                && picture.projection() == other.projection()
                && picture.look().equals(other.look());
    }

    Scene scene() {
        return scene;
    }

    SightFacts facts() {
        return facts;
    }

    SceneSample sample() {
        if (sample.isEmpty()) sample = Optional.of(SceneSample.of(scene));
        return sample.get();
    }

    /** The scene without the lamps and the terms that do not count. */
    LeastLight light(double levels) {
        if (light.isEmpty() || light.get().allowed() != levels)
            light = Optional.of(LeastLight.of(scene, levels));
        return light.get();
    }

    /** The parts made in steps from shapes; empty where the scene is not all of such parts. */
    List<ShapePart> parts() {
        if (parts.isEmpty()) parts = Optional.of(found());
        return parts.get();
    }

    private List<ShapePart> found() {
        List<ShapePart> found = new ArrayList<>();
        if (scene.surfaces().isEmpty()
                || !(scene.surfaces().get() instanceof ShapeSurfaces made)
                || scene.mesh().hasColors()
                || made.shapes().size() != scene.finishes().size()) return found;
        List<SceneShape> shapes = made.shapes();
        for (int i = 0; i < shapes.size(); i++) found.add(new ShapePart(scene, shapes.get(i), i));
        return found;
    }

    /** The scene with other faces, made once for the same steps. */
    Scene coarser(List<Integer> steps, Supplier<Scene> made) {
        return coarser.computeIfAbsent(steps, key -> made.get());
    }

    /** The largest difference between two texels of a texture, as far as it matters. */
    int contrast(double limit) {
        if (contrastLimit == limit) return contrast;
        contrastLimit = limit;
        contrast = 0;
        for (var finish : scene.finishes())
            finish.texture()
                    .ifPresent(
                            laid ->
                                    contrast =
                                            Math.max(
                                                    contrast,
                                                    TextureContrast.of(laid.texture(), limit)));
        return contrast;
    }

    /**
     * How far light mixed from corners, or one colour a face, is from the formula at each pixel,
     * where no eye and no side that is seen can change it.
     *
     * @param fronts whether only fronts are drawn
     */
    Optional<MixedLight.Apart> apart(RenderRequest request, boolean fronts) {
        Sides sides = request.look().sides();
        boolean one =
                sides == Sides.ONE
                        || fronts
                        || sides == Sides.SCENE && !scene.light().model().twoSided();
        if (!one || !LeastLight.eyeFree(scene)) return Optional.empty();
        String key = request.look().terms().toString();
        return Optional.of(
                apart.computeIfAbsent(
                        key,
                        terms -> {
                            RequestView seen = RequestView.of(request, request.width());
                            var lights =
                                    new FaceLights(
                                            scene,
                                            seen.viewed(),
                                            request.look().terms(),
                                            Sides.ONE);
                            return new MixedLight(lights, 255).apart();
                        }));
    }
}
