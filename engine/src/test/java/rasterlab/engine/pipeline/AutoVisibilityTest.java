package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.light.Material;
import rasterlab.engine.pipeline.paint.DepthCue;
import rasterlab.engine.raster.PictureDifference;
import rasterlab.engine.raster.Raster;
import rasterlab.engine.scene.Appearance;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.catalogue.Scenes;

class AutoVisibilityTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void choosesTheCheapestThatIsRight(
            String scene, String visibility, UnaryOperator<Look> change, String chosen) {
        Scene shown = Scenes.named(scene);
        var look = change.apply(Look.of(visibility, ShadingMethod.FLAT));
        var request =
                new RenderRequest(
                                shown,
                                visibility,
                                "flat",
                                "perspective",
                                shown.defaultCamera(),
                                80,
                                60)
                        .with(look);
        assertEquals(chosen, new AutoVisibility().of(request).chosen());
        new Renderer().render(request, () -> false);
    }

    static Stream<Arguments> mistakes() {
        UnaryOperator<Look> plain = look -> look;
        UnaryOperator<Look> cue = look -> look.withCue(new DepthCue(0.5));
        return Stream.of(
                argumentSet("painter dearer than depths", "cube", "auto", plain, "zfloat"),
                argumentSet("open body is taken for convex", "vase", "auto", plain, "zfloat"),
                argumentSet("outlines by a method without", "vase", "auto", outline(), "painter"),
                argumentSet("glass numbered for a cue", "transparency", "auto", cue, "zfloat"),
                argumentSet("depths tell faces of one plane", "coplanar", "auto", plain, "bsp"),
                argumentSet(
                        "opaque faces that cross are cut",
                        "interpenetrating",
                        "auto",
                        plain,
                        "zfloat"),
                argumentSet("what is asked for is changed", "cube", "z16", plain, "z16"));
    }

    @ParameterizedTest(name = "glass of {0} is drawn by {1}, right only for opaque faces")
    @CsvSource({"interpenetrating, 8, bsp", "torus, 8, zfloat"})
    void glassIsDrawnByAMethodThatIsRightForIt(String scene, int detail, String chosen) {
        Scene opaque = Scenes.named(scene, detail);
        Scene glass = opaque.with(AutoVisibilityTest::glass);
        var request =
                new RenderRequest(
                        glass, "auto", "flat", "perspective", glass.defaultCamera(), 160, 120);
        assertEquals(chosen, Renderer.visibility(request).chosen());
        Raster drawn = new Renderer().render(request, () -> false);
        RenderRequest exact = request.with(Look.of(Renderer.REFERENCE, ShadingMethod.FLAT));
        var difference = PictureDifference.of(new Renderer().render(exact, () -> false), drawn);
        assertTrue(
                difference.plainlyWrongPixels() < 20, difference.plainlyWrongPixels() + " wrong");
    }

    private static Appearance glass(Appearance finish) {
        return new Appearance(
                new Material(finish.front().surface(), 0.5),
                new Material(finish.back().surface(), 0.5),
                finish.texture());
    }

    private static UnaryOperator<Look> outline() {
        return Look::withOutline;
    }
}
