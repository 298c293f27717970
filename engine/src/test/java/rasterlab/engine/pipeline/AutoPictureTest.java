package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.Set;
import java.util.TreeSet;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.light.LightTerm;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.pipeline.paint.Sides;
import rasterlab.engine.pipeline.paint.TextureMode;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;
import rasterlab.engine.transform.SphericalView;

/** Compares pictures by {@code auto} with those of a float depth buffer, to the bit. */
class AutoPictureTest {
    private static Renderer renderer;

    @BeforeAll
    static void open() {
        renderer = new Renderer();
    }

    @AfterAll
    static void close() {
        renderer.close();
    }

    @ParameterizedTest(name = "{argumentSetName} has another picture by auto")
    @MethodSource("looks")
    void autoChangesNoPixel(UnaryOperator<Look> look) {
        for (Scene scene : Scenes.all())
            if (!scene.name().equals("coplanar"))
                for (int turn = 0; turn < 3; turn++)
                    assertSame(seen(scene, look, turn, 80 - 11 * turn, 60));
    }

    static Stream<Arguments> looks() {
        return Stream.of(
                look("scene as it is", look -> look),
                look("wire", look -> look.withShading(ShadingMethod.WIRE)),
                look("tone", look -> look.withShading(ShadingMethod.TONE)),
                look("flat light", look -> look.withShading(ShadingMethod.FLAT)),
                look("light of corners", look -> look.withShading(ShadingMethod.GOURAUD)),
                look("light of pixels", look -> look.withShading(ShadingMethod.PHONG)),
                look("nearest texel", look -> look.withTexture(TextureMode.NEAREST)),
                look("bare face", look -> look.withTexture(TextureMode.NONE)),
                look("backs' own light", look -> look.withLight(LightTerm.all(), Sides.TWO)),
                look("one term", look -> look.withLight(Set.of(LightTerm.DIFFUSE), Sides.ONE)),
                look("culled face", look -> look.withCull(Cull.BACK)),
                look("faded picture", look -> look.withCue(new DepthCue(0.6))),
                look(
                        "second eye",
                        look -> look.withStereo(new Stereo(Stereo.StereoMode.ANAGLYPH, 20))));
    }

    @ParameterizedTest(name = "{0} made in {1} steps has another picture by auto")
    @CsvSource({
        "sphere, 3",
        "sphere, 9",
        "sphere, 60",
        "torus, 5",
        "torus, 12",
        "globe, 7",
        "revolution, 4",
        "sphere-and-cylinder, 6"
    })
    void autoChangesNoPixelInAnyDetail(String name, int detail) {
        Scene scene = Scenes.named(name, detail);
        for (int turn = 0; turn < 3; turn++) assertSame(seen(scene, look -> look, turn, 96, 72));
    }

    /** Large pictures of few faces are where painters pay. */
    @Test
    void autoChangesNoPixelWhereItTakesAnotherMethod() {
        var taken = new TreeSet<String>();
        for (String name : new String[] {"cube", "house", "textured-quad", "cyclic-overlap"})
            for (ShadingMethod shading :
                    new ShadingMethod[] {ShadingMethod.FLAT, ShadingMethod.PHONG}) {
                Scene scene = Scenes.named(name);
                RenderRequest request = seen(scene, look -> look.withShading(shading), 0, 800, 600);
                taken.add(Renderer.visibility(request).chosen());
                assertSame(request);
            }
        assertTrue(taken.size() > 1, taken.toString());
    }

    /** The float buffer shows one of two faces in one plane, whichever rounding favours. */
    @Test
    void autoIsRightWhereTheBufferIsWrong() {
        RenderRequest auto = seen(Scenes.named("coplanar"), look -> look, 0, 160, 120);
        RenderRequest exact = auto.with(auto.look().withVisibility(Renderer.REFERENCE));
        RenderRequest buffer = auto.with(auto.look().withVisibility("zfloat"));
        assertEquals("", difference(drawn(exact), drawn(auto)));
        assertTrue(!difference(drawn(exact), drawn(buffer)).isEmpty());
    }

    private static void assertSame(RenderRequest auto) {
        RenderRequest buffer = auto.with(auto.look().withVisibility("zfloat"));
        assertEquals(
                "",
                difference(drawn(buffer), drawn(auto)),
                () -> auto.scene().name() + " from " + auto.camera());
    }

    private static Raster drawn(RenderRequest request) {
        return renderer.render(request, () -> false);
    }

    /** The first pixel that differs; "" where none does. */
    private static String difference(Raster expected, Raster drawn) {
        for (int i = 0; i < expected.argb().length; i++)
            if (expected.argb()[i] != drawn.argb()[i])
                return "pixel (%d, %d): %08X instead of %08X"
                        .formatted(
                                i % expected.width(),
                                i / expected.width(),
                                drawn.argb()[i],
                                expected.argb()[i]);
        return "";
    }

    private static RenderRequest seen(
            Scene scene, UnaryOperator<Look> look, int turn, int width, int height) {
        SphericalView usual = scene.defaultCamera();
        var camera =
                new SphericalView(
                        usual.thetaRadians() + 1.3 * turn,
                        turn == 0 ? usual.phiRadians() : 0.4 + 0.9 * turn,
                        usual.rho() * (1 - 0.15 * turn));
        var request =
                new RenderRequest(
                        scene, Renderer.AUTO, "auto", "perspective", camera, width, height);
        return request.with(look.apply(request.look()));
    }

    private static Arguments look(String name, UnaryOperator<Look> look) {
        return argumentSet(name, look);
    }
}
