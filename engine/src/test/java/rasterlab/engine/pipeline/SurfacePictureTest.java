package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.api.DisplayName;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;

/** Surfaces drawn without faces. */
class SurfacePictureTest {
    private final Renderer renderer = new Renderer();

    /** Flat faces are what they stand for, so the two ways agree. */
    @ParameterizedTest(name = "{0}: light, place or texture is not that of the faces")
    @MethodSource("flat")
    void flatSurfacesAreTheirFaces(String name, String projection) {
        Scene scene = Scenes.named(name);
        Raster faces = picture(scene, Renderer.REFERENCE, projection, TextureMode.NEAREST);
        Raster surfaces = picture(scene, Renderer.SURFACES, projection, TextureMode.NEAREST);
        double share = PictureDifference.of(faces, surfaces).share();
        assertTrue(share < 0.002, name + ", " + projection + ": " + share);
    }

    static Stream<Arguments> flat() {
        return Stream.of("cube", "cyclic-overlap")
                .flatMap(
                        name ->
                                Stream.of("perspective", "isometric", "cabinet")
                                        .map(p -> Arguments.of(name, p)));
    }

    @ParameterizedTest(name = "{0}: finer faces do not come nearer to the surface")
    @MethodSource("curved")
    @Tag("slow")
    void finerFacesComeNearer(String name) {
        Raster exact =
                picture(Scenes.named(name), Renderer.SURFACES, "perspective", TextureMode.LINEAR);
        double coarse = difference(exact, Scenes.named(name, 8));
        double middle = difference(exact, Scenes.named(name, 32));
        double fine = difference(exact, Scenes.named(name, 256));
        assertTrue(
                coarse > 2 * middle && middle > 2 * fine,
                name + ": " + coarse + ", " + middle + ", " + fine);
    }

    static Stream<String> curved() {
        return Stream.of("sphere", "torus", "revolution", "globe");
    }

    /** The mean difference of a channel, in levels. */
    private double difference(Raster exact, Scene scene) {
        Raster faces = picture(scene, Renderer.REFERENCE, "perspective", TextureMode.LINEAR);
        long sum = 0;
        for (int i = 0; i < exact.argb().length; i++)
            for (int shift = 0; shift <= 16; shift += 8)
                sum +=
                        Math.abs(
                                (exact.argb()[i] >> shift & 255)
                                        - (faces.argb()[i] >> shift & 255));
        return sum / 3.0 / exact.argb().length;
    }

    @Test
    @DisplayName("detail changes the surface")
    void surfaceHasNoDetail() {
        assertArrayEquals(
                picture(Scenes.named("torus", 5), Renderer.SURFACES, "front", TextureMode.NONE)
                        .argb(),
                picture(Scenes.named("torus"), Renderer.SURFACES, "front", TextureMode.NONE)
                        .argb());
    }

    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("refused")
    void refuses(String scene, Look look, String message) {
        Scene shown = Scenes.named(scene);
        var request = request(shown, Renderer.SURFACES, "perspective").with(look);
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () -> renderer.render(request, () -> false));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> refused() {
        Look phong = Look.of(Renderer.SURFACES, ShadingMethod.PHONG);
        return Stream.of(
                argumentSet(
                        "a scene of faces is drawn without them",
                        "house",
                        phong,
                        "scene 'house' is made of faces, not of surfaces"),
                argumentSet(
                        "flat shading is passed over",
                        "sphere",
                        phong.withShading(ShadingMethod.FLAT),
                        "shading flat needs faces; surfaces are drawn with phong or auto"),
                argumentSet(
                        "culling is passed over",
                        "sphere",
                        phong.withCull(Cull.BACK),
                        "culling needs faces; surfaces are drawn with none"),
                argumentSet(
                        "mipmaps are passed over",
                        "globe",
                        phong.withTexture(TextureMode.MIPMAP),
                        "texture mipmap needs faces; surfaces are drawn with nearest, linear, none"
                                + " or auto"));
    }

    private Raster picture(Scene scene, String visibility, String projection, TextureMode texture) {
        RenderRequest request = request(scene, visibility, projection);
        return renderer.render(request.with(request.look().withTexture(texture)), () -> false);
    }

    private static RenderRequest request(Scene scene, String visibility, String projection) {
        return new RenderRequest(
                scene, visibility, "phong", projection, scene.defaultCamera(), 200, 150);
    }
}
