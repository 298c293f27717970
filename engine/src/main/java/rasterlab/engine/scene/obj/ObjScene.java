package rasterlab.engine.scene.obj;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Material;
import rasterlab.engine.scene.Finish;
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
 * cut to 1, the highlight's exponent to 200, and illum 0 and 1 have no highlight.
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
     * @throws IllegalArgumentException if the model cannot be fitted, or once fitted a face is no
     *     longer flat
     */
    public static Scene of(String name, ObjModel model, UpAxis up, TextureFiles textures) {
        Map<String, Texture> opened = new HashMap<>();
        List<Finish> finishes = new ArrayList<>();
        for (ObjMaterial material : model.materials())
            finishes.add(
                    finish(
                            material,
                            material.diffuseMap()
                                    .map(
                                            map ->
                                                    opened.computeIfAbsent(
                                                            map.file(),
                                                            file ->
                                                                    textures.open(
                                                                            file, map.place())))));
        int[] finishOf = new int[model.faceCount()];
        for (int f = 0; f < finishOf.length; f++) finishOf[f] = model.material(f);
        return new Scene(
                name,
                Fit.into(model, up),
                finishes,
                finishOf,
                SceneLight.lampAtEye(),
                BACKGROUND_RGB,
                CAMERA,
                PICTURE_SCALE);
    }

    private static Finish finish(ObjMaterial from, Optional<Texture> texture) {
        boolean shines = from.illumination() >= 2;
        var surface =
                new SurfaceMaterial(
                        shares(from.ambient()),
                        shares(from.diffuse()),
                        shines ? shares(from.specular()) : new double[3],
                        shares(from.emitted()),
                        Math.min(SurfaceMaterial.HIGHEST_SHININESS, from.shininess()));
        Finish bare = Finish.of(new Material(surface, from.opacity()));
        return texture.map(picture -> bare.with(laid(picture))).orElse(bare);
    }

    private static double[] shares(List<Double> colour) {
        return colour.stream().mapToDouble(share -> Math.min(1, share)).toArray();
    }

    private static LaidTexture laid(Texture picture) {
        return new LaidTexture(
                picture, Wrap.REPEAT, Wrap.REPEAT, TextureEnvironment.of(Mode.MODULATE, picture));
    }
}
