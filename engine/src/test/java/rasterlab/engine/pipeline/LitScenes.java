package rasterlab.engine.pipeline;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import rasterlab.contract.Attenuation;
import rasterlab.contract.LightSource;
import rasterlab.contract.Reflection;
import rasterlab.contract.SpotCone;
import rasterlab.contract.SurfaceMaterial;
import rasterlab.engine.light.Light;
import rasterlab.engine.light.LightModel;
import rasterlab.engine.light.Material;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.LaidTexture;
import rasterlab.engine.scene.Mesh;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.SceneLight;
import rasterlab.engine.texture.Texture;
import rasterlab.engine.texture.TextureEnvironment;
import rasterlab.engine.texture.TextureEnvironment.Mode;
import rasterlab.engine.texture.Wrap;
import rasterlab.engine.transform.SphericalView;

/** Small scenes with light, finishes and textures. */
final class LitScenes {
    static final SphericalView ASIDE = new SphericalView(0.6, 1.1, 5);

    private LitScenes() {}

    static Scene scene(Mesh mesh, Appearance finish, SceneLight light) {
        return new Scene(
                "test",
                mesh,
                List.of(finish),
                new int[mesh.faceCount()],
                light,
                0x203040,
                ASIDE,
                180);
    }

    static Scene shinyBall(LightModel model) {
        return scene(
                ball(9, 6),
                new Appearance(RED, BLUE, Optional.empty()),
                new SceneLight(model, NONE));
    }

    static final Optional<LightSource> NONE = Optional.empty();

    static final Material RED =
            material(new double[] {0.9, 0.5, 0.3}, new double[] {0.6, 0.7, 0.5}, 12);

    static final Material BLUE =
            material(new double[] {0.2, 0.4, 0.9}, new double[] {0.3, 0.2, 0.1}, 5);

    private static Material material(double[] diffuse, double[] specular, double shininess) {
        double[] ambient = {0.3, 0.2, 0.4};
        double[] emission = {0.02, 0.05, 0.01};
        return new Material(
                new SurfaceMaterial(ambient, diffuse, specular, emission, shininess), 1);
    }

    /** Two lamps, one near with attenuation, and a sun. */
    static LightModel lamps(Reflection reflection, boolean local, boolean twoSided) {
        LightSource white = LightSource.white();
        double[] blue = {0.1, 0.2, 0.5};
        var dim = new LightSource(blue, blue, blue, Attenuation.none(), SpotCone.none());
        return new LightModel(
                new double[] {0.2, 0.1, 0.3},
                local,
                twoSided,
                reflection,
                List.of(
                        Light.at(white.attenuated(new Attenuation(0.5, 0.1, 0.2)), 2, 1, 1.5),
                        Light.from(dim, -1, 2, 0.5)));
    }

    static LightModel spot() {
        var cone = new SpotCone(new double[] {-1, -0.7, -0.6}, 14, 3);
        return LightModel.openGl(Light.at(LightSource.white().through(cone), 3, 2, 2))
                .withLocalViewer();
    }

    /** Triangles of a sphere of radius 1 that is open above, with its own normals. */
    static Mesh ball(int meridians, int parallels) {
        List<int[]> faces = new ArrayList<>();
        var xyz = new double[3 * meridians * parallels];
        for (int row = 0; row < parallels; row++)
            for (int column = 0; column < meridians; column++) {
                double up = Math.PI * (0.8 * row / (parallels - 1) + 0.01);
                double around = 2 * Math.PI * column / meridians;
                int v = row * meridians + column;
                xyz[3 * v] = Math.sin(up) * Math.cos(around);
                xyz[3 * v + 1] = Math.sin(up) * Math.sin(around);
                xyz[3 * v + 2] = -Math.cos(up);
                if (row == 0) continue;
                int next = row * meridians + (column + 1) % meridians;
                faces.add(new int[] {v, v - meridians, next - meridians});
                faces.add(new int[] {v, next - meridians, next});
            }
        int[][] outwards =
                faces.stream().map(f -> new int[] {f[0], f[1], f[2]}).toArray(int[][]::new);
        var mesh = new Mesh(xyz, outwards);
        var normals = new double[9 * outwards.length];
        int at = 0;
        for (int[] face : outwards)
            for (int v : face) {
                System.arraycopy(xyz, 3 * v, normals, at, 3);
                at += 3;
            }
        return mesh.withNormals(normals);
    }

    /** One face that leads away from the eye of {@link #ASIDE}, with texture coordinates. */
    static Mesh floor(double... st) {
        double[] xyz = {2, -1, -0.5, 2, 1, -0.5, -6, 1.5, -0.5, -6, -1.5, -0.5};
        return new Mesh(xyz, new int[][] {{0, 1, 2, 3}}).withTexture(st);
    }

    /** White light from everywhere, so that a texture keeps its colours. */
    static SceneLight everywhere() {
        double[] one = {1, 1, 1};
        return new SceneLight(
                new LightModel(one, false, false, Reflection.LAMBERT, List.of()), NONE);
    }

    static Appearance white() {
        double[] one = {1, 1, 1};
        double[] none = new double[3];
        return Appearance.of(new Material(new SurfaceMaterial(one, none, none, none, 0), 1));
    }

    static LaidTexture laid(Texture texture, Wrap wrap) {
        return new LaidTexture(texture, wrap, wrap, TextureEnvironment.of(Mode.REPLACE, texture));
    }

    /** Every texel another colour. */
    static Texture texels(int width, int height) {
        var argb = new int[width * height];
        Arrays.setAll(argb, LitScenes::texel);
        return Texture.of(width, height, 3, argb);
    }

    /** A colour of {@link #texels}, counted row by row from the texture's beginning. */
    static int texel(int number) {
        return 0xFF000000 | (number * 2654435 + 0x123456) & 0xFFFFFF;
    }
}
