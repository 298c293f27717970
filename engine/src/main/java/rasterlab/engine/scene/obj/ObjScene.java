package rasterlab.engine.scene.obj;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Material;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.SphericalView;

/**
 * A model as a scene: fitted into a ball about the origin by {@link Fit}, with a lamp at the eye.
 *
 * <p>Materials are taken as they are, but for what a scene has no room for: light of their own is
 * cut to 1, the highlight's exponent to 200, and illum 0 and 1 have no highlight. Lines and points
 * are thin bodies with light of their own.
 */
public final class ObjScene {
    private static final int BACKGROUND_RGB = 0x202B38;
    private static final SphericalView CAMERA =
            new SphericalView(Math.PI / 6, Math.PI * 7 / 18, 5 * Fit.RADIUS);
    private static final double PICTURE_SCALE = 2.2;

    private ObjScene() {}

    /**
     * @param name of the scene
     * @param up the model's
     * @param notes told of what was left out
     * @throws IllegalArgumentException if the model cannot be fitted
     */
    public static Scene of(
            String name, ObjModel model, UpAxis up, TextureFiles textures, Consumer<String> notes) {
        Map<ObjMaterial.Map, Optional<Texture>> opened = new HashMap<>();
        List<Appearance> finishes = new ArrayList<>();
        for (ObjMaterial material : model.materials())
            finishes.add(
                    material.diffuseMap()
                            .flatMap(
                                    map ->
                                            opened.computeIfAbsent(map, textures::open)
                                                    .map(picture -> laid(picture, map)))
                            .map(finish(material)::with)
                            .orElse(finish(material)));
        if (model.strokeCount() > 0)
            for (ObjMaterial material : model.materials()) finishes.add(stroke(material));
        var found = new Notes();
        ModelMesh.Made made = ModelMesh.of(name, model, up, found);
        found.all().forEach(notes);
        return new Scene(
                name,
                made.mesh(),
                finishes,
                made.finishOf(),
                SceneLight.lampAtEye(),
                BACKGROUND_RGB,
                CAMERA,
                PICTURE_SCALE);
    }

    private static Appearance finish(ObjMaterial from) {
        boolean shines = from.illumination() >= 2;
        var surface =
                new SurfaceMaterial(
                        shares(from.ambient()),
                        shares(from.diffuse()),
                        shines ? shares(from.specular()) : new double[3],
                        shares(from.emitted()),
                        Math.min(SurfaceMaterial.HIGHEST_SHININESS, from.shininess()));
        return Appearance.of(new Material(surface, from.opacity()));
    }

    /** A line or point shines in its material's colour, from wherever it is seen. */
    private static Appearance stroke(ObjMaterial from) {
        double[] color = shares(from.diffuse());
        return Appearance.of(
                new Material(new SurfaceMaterial(color, color, new double[3], color, 0), 1));
    }

    private static double[] shares(List<Double> color) {
        return color.stream().mapToDouble(share -> Math.min(1, share)).toArray();
    }

    private static LaidTexture laid(Texture picture, ObjMaterial.Map map) {
        Wrap wrap = map.clamped() ? Wrap.CLAMP_TO_EDGE : Wrap.REPEAT;
        return new LaidTexture(picture, wrap, wrap, TextureEnvironment.of(Mode.MODULATE, picture));
    }
}
