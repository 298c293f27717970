package rasterlab.engine.pipeline;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.params.provider.Arguments.argumentSet;

import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import rasterlab.engine.scene.Scene;
import rasterlab.engine.scene.Scenes;

class RenderRequestTest {
    @ParameterizedTest(name = "{argumentSetName}")
    @MethodSource("mistakes")
    void refuses(
            String visibility,
            String shading,
            String projection,
            int width,
            boolean outline,
            String message) {
        Scene vase = Scenes.named("vase");
        var refusal =
                assertThrows(
                        IllegalArgumentException.class,
                        () ->
                                new RenderRequest(
                                        vase,
                                        visibility,
                                        shading,
                                        projection,
                                        vase.defaultCamera(),
                                        width,
                                        10,
                                        outline));
        assertEquals(message, refusal.getMessage());
    }

    static Stream<Arguments> mistakes() {
        String z = "zfloat";
        String central = "perspective";
        return Stream.of(
                argumentSet(
                        "unknown visibility is accepted",
                        "z17",
                        "tone",
                        central,
                        10,
                        false,
                        "no visibility method 'z17';"
                                + " there are painter-textbook, painter, zfloat, raycast"),
                argumentSet(
                        "unknown shading is accepted",
                        z,
                        "Tone",
                        central,
                        10,
                        false,
                        "no shading 'Tone'; there are tone, flat"),
                argumentSet(
                        "unknown projection is accepted",
                        z,
                        "tone",
                        "",
                        10,
                        false,
                        "no projection ''; there are " + String.join(", ", Renderer.projections())),
                argumentSet(
                        "no pixel is accepted",
                        z,
                        "tone",
                        central,
                        0,
                        false,
                        "picture size must be from 1×1 to 8192×8192 pixels, got 0×10"),
                argumentSet(
                        "outline is silently dropped by zfloat",
                        z,
                        "tone",
                        central,
                        10,
                        true,
                        "visibility 'zfloat' draws no outlines; those that do are painter-textbook, painter"),
                argumentSet(
                        "outline is silently dropped by raycast",
                        "raycast",
                        "tone",
                        central,
                        10,
                        true,
                        "visibility 'raycast' draws no outlines;"
                                + " those that do are painter-textbook, painter"));
    }
}
