package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.pipeline.paint.DepthCue;
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
        assertEquals(chosen, Renderer.visibility(request).chosen());
        new Renderer().render(request, () -> false);
    }

    static Stream<Arguments> mistakes() {
        UnaryOperator<Look> plain = look -> look;
        UnaryOperator<Look> cue = look -> look.withCue(new DepthCue(0.5));
        return Stream.of(
                argumentSet("depths for a convex body", "cube", "auto", plain, "convex"),
                argumentSet("open body is taken for convex", "vase", "auto", plain, "pipeline"),
                argumentSet("outlines by a method without", "vase", "auto", outline(), "painter"),
                argumentSet("glass numbered for a cue", "transparency", "auto", cue, "zfloat"),
                argumentSet("what is asked for is changed", "cube", "z16", plain, "z16"));
    }

    private static UnaryOperator<Look> outline() {
        return Look::withOutline;
    }
}
